// SPDX-License-Identifier: MIT
#include "base/parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>

#include "occlude/kernel/validity.h"

namespace occlude::culler {

void parallel_for(std::size_t count, const Executor::Part& work, const Checkpoint& checkpoint) {
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
