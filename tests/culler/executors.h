// SPDX-License-Identifier: MIT
// Executors that run parts in different orders and on different threads.
#pragma once

#include <cfenv>
#include <cstddef>
#include <thread>
#include <vector>

#include "occlude/culler/executor.h"

namespace occlude::culler {

/// Starts a thread for each part. REQUIRES: threads > 0.
inline Executor a_thread_for_each_part(std::size_t threads) {
  return {threads, [](std::size_t count, const Executor::Part& part) {
            std::vector<std::jthread> all;
            for (std::size_t i = 0; i < count; ++i) all.emplace_back([&part, i] { part(i); });
          }};
}

/// The calling thread alone, parts in the reverse order, a thread for each part, and a thread for each processor.
inline std::vector<Executor> some_executors() {
  const auto backwards = [](std::size_t count, const Executor::Part& part) {
    while (count > 0) part(--count);
  };
  return {Executor(), Executor(5, backwards), a_thread_for_each_part(3), Executor::own_threads()};
}

/// Rounds upwards while its parts run.
inline Executor rounding_upwards(std::size_t threads) {
  return {threads, [](std::size_t count, const Executor::Part& part) {
            std::fesetround(FE_UPWARD);
            for (std::size_t i = 0; i < count; ++i) part(i);
            std::fesetround(FE_TONEAREST);
          }};
}

}  // namespace occlude::culler
