// SPDX-License-Identifier: MIT
#include "threads.h"

#include <algorithm>
#include <chrono>
#include <thread>

#include "bench.h"
#include "occlude/culler/culler.h"
#include "occlude/render/progress.h"
#include "occlude/render/view_along_path.h"
#include "rounds.h"
#include "waiting_threads.h"

namespace occlude::experiments {
namespace {

/// A number of threads and its timings, one number per round.
struct ThreadsTrial {
  std::size_t threads;
  std::vector<double> cull_ms;
};

/// By the clock, in the mean over the frames.
double cull_ms(const culler::Culler& culler, const Subject& subject, const render::WalkOptions& walk,
               const culler::CullOptions& cull) {
  using Clock = std::chrono::steady_clock;
  render::ViewAlongPath along(culler, subject.path, walk, cull);
  const auto frames = frames_of(subject.path, walk);
  Clock::duration sum{};
  for (const std::size_t frame : frames) {
    render::check_interrupt();
    const culler::Camera camera = subject.path.camera(frame, aspect(walk));
    culler::View& view = along.before(frame);
    const auto start = Clock::now();
    culler.cull(camera, cull, view);
    sum += Clock::now() - start;
  }
  return std::chrono::duration<double, std::milli>(sum).count() / static_cast<double>(frames.size());
}

}  // namespace

std::vector<ThreadsPoint> measure_threads(const Subject& subject, const Options& options) {
  render::WalkOptions walk = options.walk;
  walk.cull.method = culler::Method::frusta;
  const culler::Culler culler = make_culler(subject.soup, walk);
  const std::size_t processors = std::max(1U, std::thread::hardware_concurrency());
  std::vector<ThreadsTrial> trials;
  for (std::size_t threads = 1; threads <= processors; threads *= 2) trials.push_back({threads, {}});
  run_in_rounds("threads", options.repetitions, trials, [&](ThreadsTrial& trial) {
    WaitingThreads waiting(trial.threads);
    const culler::Executor executor = waiting.executor();
    culler::CullOptions cull = walk.cull;
    cull.executor = &executor;
    trial.cull_ms.push_back(cull_ms(culler, subject, walk, cull));
  });
  std::vector<ThreadsPoint> points;
  for (const ThreadsTrial& trial : trials) {
    std::vector<double> speedups;
    for (std::size_t round = 0; round < trial.cull_ms.size(); ++round) {
      speedups.push_back(trials[0].cull_ms[round] / trial.cull_ms[round]);
    }
    points.push_back({trial.threads, bench::median(trial.cull_ms), bench::median(speedups)});
  }
  return points;
}

}  // namespace occlude::experiments
