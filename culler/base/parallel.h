// SPDX-License-Identifier: MIT
// The same work on several threads.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>

#include "occlude/culler/executor.h"
#include "occlude/kernel/validity.h"

namespace occlude::culler {

/// Calls checkpoint() and then work(i), once for every i < count, by the executor of the checkpoint. Returns when all calls
/// have returned. If a call throws, no further calls begin. Once those that run have returned, the first exception is thrown
/// on. Threads that do not round to nearest call nothing; what they leave, the calling thread does.
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
  const auto sound_share = [&](std::size_t) {
    if (kernel::check_rounding() == kernel::Refusal::none) share();
  };
  const Executor& executor = checkpoint.executor();
  executor.run(std::min(executor.threads(), count), sound_share);
  share();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace occlude::culler
