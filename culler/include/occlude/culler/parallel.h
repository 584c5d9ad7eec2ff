// SPDX-License-Identifier: MIT
// The same work on all processors.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

#include "occlude/culler/checkpoint.h"

namespace occlude::culler {

/// Calls checkpoint() and then work(i), once for every i < count, on several threads at once: one for each processor, or as
/// many as the system can start. The calling thread is one of them. Returns when all calls have returned.
/// If a call throws, no further calls begin. Once those that run have returned, the first exception is thrown on.
template <class Work>
void parallel_for(std::size_t count, Work&& work, const Checkpoint& checkpoint = {}) {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr failure;
  const auto share = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) {
        checkpoint();
        work(i);
      }
    } catch (...) {
      next = count;
      const std::lock_guard lock(mutex);
      if (!failure) failure = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> others;
    const std::size_t threads = std::min<std::size_t>(std::max(1U, std::thread::hardware_concurrency()), count);
    try {
      for (std::size_t t = 1; t < threads; ++t) others.emplace_back(share);
    } catch (const std::system_error&) {
      // Fewer do it as well.
    }
    share();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace occlude::culler
