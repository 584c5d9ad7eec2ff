// SPDX-License-Identifier: MIT
// The same work on several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>

#include "occlude/culler/checkpoint.h"
#include "occlude/culler/executor.h"

namespace occlude::culler {

/// Calls checkpoint() and then work(i), once for every i < count, by the executor of the checkpoint. Returns when all calls
/// have returned. If a call throws, no further calls begin. Once those that run have returned, the first exception is thrown
/// on.
template <class Work>
void parallel_for(std::size_t count, Work&& work, const Checkpoint& checkpoint = {}) {
  std::atomic<std::size_t> next = 0;
  std::mutex mutex;
  std::exception_ptr failure;
  const auto share = [&](std::size_t) {
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
  const Executor& executor = checkpoint.executor();
  executor.run(std::min(executor.threads(), count), share);
  if (failure) std::rethrow_exception(failure);
}

}  // namespace occlude::culler
