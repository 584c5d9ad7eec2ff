// SPDX-License-Identifier: MIT
// What one method of culling needs of a model, made when it is first asked for. The other method then pays nothing for it.
#pragma once

#include <atomic>
#include <mutex>
#include <optional>

namespace occlude::culler {

/// May be asked on several threads at once.
template <class T>
class Lazy {
 public:
  /// What make() makes at the first call. If make() throws, so does get(), and the next call tries again.
  template <class Make>
  const T& get(const Make& make) {
    // std::call_once() would leave its lock to nobody when make() throws, with MinGW.
    if (!is_made_.load(std::memory_order_acquire)) {
      const std::lock_guard lock(mutex_);
      if (!is_made_.load(std::memory_order_relaxed)) {
        made_.emplace(make());
        is_made_.store(true, std::memory_order_release);
      }
    }
    return *made_;
  }

 private:
  std::atomic<bool> is_made_ = false;
  std::mutex mutex_;
  std::optional<T> made_;
};

}  // namespace occlude::culler
