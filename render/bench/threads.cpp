// SPDX-License-Identifier: MIT
#include "threads.h"

#include <algorithm>
#include <thread>

#include "bench.h"
#include "occlude/culler/culler.h"
#include "pass.h"
#include "rounds.h"
#include "waiting_threads.h"

namespace occlude::experiments {
namespace {

/// A number of threads and its timings, one number per round.
struct ThreadsTrial {
  std::size_t threads;
  std::vector<double> cull_ms;
};

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
    trial.cull_ms.push_back(pass_along(culler, subject.path, walk, cull).clock_ms);
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
