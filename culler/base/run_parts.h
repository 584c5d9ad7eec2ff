// SPDX-License-Identifier: MIT
// Parts of a frame on the threads of the caller.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <deque>
#include <functional>
#include <new>
#include <vector>

#include "occlude/culler/executor.h"
#include "occlude/kernel/validity.h"

namespace occlude::culler {

/// Runs parts, and keeps the memory for that. Each thread has a share: consecutive parts, with about as much work as others
/// have. It begins with what is most work, and goes on with what others have left. So while parts are much alike from frame
/// to frame, and the executor gives the same call to the same thread, what they read stays in the cache of one processor.
class PartRunner {
 public:
  /// A part, by its number.
  struct Turn {
    std::size_t part, work;
    bool is_done;
  };

  /// Calls run_part(i) for each i < count, on any threads; work_of(i) is about how much work that is. A thread that rounds
  /// otherwise runs nothing. What no thread runs, or had no memory for, the calling thread runs when all have returned. What
  /// the executor throws, and what run_part throws there, is thrown on. REQUIRES: run_part begins anew with a part that it
  /// could not finish.
  template <class WorkOf, class RunPart>
  void run(const Executor& executor, std::size_t count, const WorkOf& work_of, const RunPart& run_part) {
    divide(executor.threads(), count, work_of);
    const auto finish = [&](Turn& turn) {
      run_part(turn.part);
      turn.is_done = true;
    };
    const auto take_turns = [&](std::size_t own) {
      if (kernel::check_rounding() != kernel::Refusal::none) return;
      for (std::size_t i = 0; i < used_; ++i) {
        Share& share = shares_[(own + i) % used_];
        for (std::size_t k = share.next++; k < share.end; k = share.next++) {
          try {
            finish(turns_[k]);
          } catch (const std::bad_alloc&) {
            // It is not done.
          }
        }
      }
    };
    executor.run(used_, std::cref(take_turns));
    for (Turn& turn : turns_) {
      if (!turn.is_done) finish(turn);
    }
  }

  /// Reserves memory for so many parts.
  void reserve(std::size_t parts) { turns_.reserve(parts); }

  /// Of the last run.
  [[nodiscard]] const std::vector<Turn>& turns() const { return turns_; }

 private:
  /// Turns from `next` to before `end`. In a cache line of its own, because other threads write to others.
  struct alignas(64) Share {
    std::atomic<std::size_t> next = 0;
    std::size_t end = 0;
  };

  template <class WorkOf>
  void divide(std::size_t threads, std::size_t count, const WorkOf& work_of) {
    while (shares_.size() < threads) shares_.emplace_back();
    used_ = std::min(threads, count);
    turns_.clear();
    std::size_t all = 0, before = 0, first = 0;
    for (std::size_t i = 0; i < count; ++i) {
      turns_.push_back({i, work_of(i) + 1, false});
      all += turns_.back().work;
    }
    for (std::size_t i = 0, end = 0; i < used_; ++i, first = end) {
      // A part that lies across the border of two shares belongs to the one that has its middle.
      for (; end < count && (before + turns_[end].work / 2) * used_ < all * (i + 1); ++end) before += turns_[end].work;
      shares_[i].next = first;
      shares_[i].end = end;
      std::sort(turns_.begin() + static_cast<std::ptrdiff_t>(first), turns_.begin() + static_cast<std::ptrdiff_t>(end),
                [](const Turn& a, const Turn& b) { return a.work != b.work ? a.work > b.work : a.part < b.part; });
    }
  }

  std::vector<Turn> turns_;
  std::deque<Share> shares_;  ///< may be longer than what is used
  std::size_t used_ = 0;
};

}  // namespace occlude::culler
