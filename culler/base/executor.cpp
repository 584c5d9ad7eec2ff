// SPDX-License-Identifier: MIT
#include "occlude/culler/executor.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <utility>
#include <vector>

namespace occlude::culler {

Executor::Executor(std::size_t threads, Run run) : threads_(threads), run_(std::move(run)) {}

Executor Executor::own_threads() {
  static const std::size_t processors = std::max(1U, std::thread::hardware_concurrency());  // which asks the system
  return own_threads(processors);
}

Executor Executor::own_threads(std::size_t threads) {
  const auto run = [threads](std::size_t count, const Part& part) {
    std::atomic<std::size_t> next = 0;
    const auto share = [&] {
      for (std::size_t i = next++; i < count; i = next++) part(i);
    };
    std::vector<std::thread> others;
    try {
      while (others.size() + 1 < std::min(threads, count)) others.emplace_back(share);
    } catch (const std::exception&) {
      // No thread, or no memory for one. Fewer do it as well.
    }
    share();
    for (std::thread& thread : others) thread.join();
  };
  return {threads, run};
}

void Executor::run(std::size_t count, const Part& part) const {
  if (run_ && count > 1) return run_(count, part);
  for (std::size_t i = 0; i < count; ++i) part(i);
}

}  // namespace occlude::culler
