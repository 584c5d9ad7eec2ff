// SPDX-License-Identifier: MIT
#include "occlude/culler/executor.h"

#include <algorithm>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace occlude::culler {
namespace {

/// A thread for each part but the first, which the calling thread does. Parts for which the system starts no thread are done
/// by the calling thread as well.
void run_on_own_threads(std::size_t count, const Executor::Part& part) {
  std::vector<std::jthread> others;
  std::size_t started = 1;
  try {
    for (; started < count; ++started) others.emplace_back([&part, started] { part(started); });
  } catch (const std::system_error&) {
    // Fewer do it as well.
  }
  for (std::size_t i = started; i < count; ++i) part(i);
  if (count > 0) part(0);
}

}  // namespace

Executor::Executor(std::size_t threads, Run run) : threads_(threads), run_(std::move(run)) {}

Executor Executor::own_threads() {
  static const std::size_t processors = std::max(1U, std::thread::hardware_concurrency());  // which asks the system
  return {processors, run_on_own_threads};
}

void Executor::run(std::size_t count, const Part& part) const {
  if (run_ && count > 1) return run_(count, part);
  for (std::size_t i = 0; i < count; ++i) part(i);
}

}  // namespace occlude::culler
