// SPDX-License-Identifier: MIT
// Threads that wait for work without sleeping, as those of an engine's job system do within a frame.
#pragma once

#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

#include "occlude/culler/executor.h"

namespace occlude::experiments {

/// They take all time of their processors while the object lives, so it should not live long.
class WaitingThreads {
 public:
  /// So many threads, the calling one among them. Throws std::system_error if they cannot be started.
  /// REQUIRES: 0 < threads <= Executor::kMostThreads.
  explicit WaitingThreads(std::size_t threads);
  ~WaitingThreads();
  WaitingThreads(const WaitingThreads&) = delete;
  WaitingThreads& operator=(const WaitingThreads&) = delete;

  /// Valid while this object lives. One thread at a time may run work. Part i is run by the same thread each time.
  [[nodiscard]] culler::Executor executor();

 private:
  void end();
  void wait_and_work(std::size_t thread);
  void run(std::size_t count, const culler::Executor::Part& part);
  void work(std::size_t thread) const;

  // What the calling thread writes, what others write and what nobody writes have cache lines of their own.
  alignas(64) std::size_t count_ = 0;
  const culler::Executor::Part* part_ = nullptr;
  bool is_over_ = false;                           ///< the three are written before `round_` is
  std::atomic<std::size_t> round_ = 0;             ///< counts what was run
  alignas(64) std::atomic<std::size_t> busy_ = 0;  ///< other threads that have not finished the round
  alignas(64) std::vector<std::jthread> others_;
};

}  // namespace occlude::experiments
