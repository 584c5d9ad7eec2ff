// SPDX-License-Identifier: MIT
#include "threads.h"

#include <algorithm>
#include <future>
#include <thread>

#include "bench.h"
#include "occlude/culler/culler.h"
#include "occlude/render/stopwatch.h"
#include "pass.h"
#include "rounds.h"
#include "waiting_threads.h"

namespace occlude::experiments {
namespace {

/// A number of threads and its timings, one number per round.
struct ThreadsTrial {
  std::size_t threads;
  std::vector<double> cull_ms{}, rate_at_once{}, call_us{};
};

/// Frames per millisecond of so many passes at once, together. run_pass() returns its milliseconds per frame.
template <class RunPass>
double rate_at_once(std::size_t passes, const RunPass& run_pass) {
  std::vector<std::future<double>> others;
  while (others.size() + 1 < passes) others.push_back(std::async(std::launch::async, run_pass));
  double rate = 1 / run_pass();
  for (std::future<double>& other : others) rate += 1 / other.get();
  return rate;
}

/// Microseconds of a call that gives the threads nothing to do.
double call_us(const culler::Executor& executor) {
  constexpr int kCalls = 1000;
  const render::Stopwatch clock;
  for (int i = 0; i < kCalls; ++i) executor.run(executor.threads(), [](std::size_t) {});
  return clock.milliseconds() * 1000 / kCalls;
}

}  // namespace

std::vector<ThreadsPoint> measure_threads(const Subject& subject, const Options& options) {
  render::WalkOptions walk = options.walk;
  walk.cull.method = culler::Method::frusta;
  const culler::Culler culler = make_culler(subject.soup, walk);
  const std::size_t processors = std::max(1U, std::thread::hardware_concurrency());
  std::vector<ThreadsTrial> trials;
  for (std::size_t threads = 1; threads <= processors; threads *= 2) trials.push_back({threads});
  run_in_rounds("threads", options.repetitions, trials, [&](ThreadsTrial& trial) {
    const auto clock_ms = [&](const culler::CullOptions& cull) {
      return pass_along(culler, subject.path, walk, cull).clock_ms;
    };
    trial.rate_at_once.push_back(rate_at_once(trial.threads, [&] { return clock_ms(walk.cull); }));
    WaitingThreads waiting(trial.threads);
    const culler::Executor executor = waiting.executor();
    culler::CullOptions cull = walk.cull;
    cull.executor = &executor;
    trial.cull_ms.push_back(clock_ms(cull));
    trial.call_us.push_back(call_us(executor));
  });
  std::vector<ThreadsPoint> points;
  for (const ThreadsTrial& trial : trials) {
    points.push_back({trial.threads, bench::median(trial.cull_ms), bench::median_ratio(trials[0].cull_ms, trial.cull_ms),
                      bench::median_ratio(trial.rate_at_once, trials[0].rate_at_once), bench::median(trial.call_us)});
  }
  return points;
}

}  // namespace occlude::experiments
