// SPDX-License-Identifier: MIT
// Items of work of a frame on the threads of the caller.
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

/// Runs items, and keeps the memory for that. Each thread has a share: consecutive items, with about as much work as others
/// have. It begins with what is most work, and goes on with what others have left. So while items are much alike from frame
/// to frame, and the executor gives the same call to the same thread, what they read stays in the cache of one processor.
class WorkRunner {
 public:
  /// An item, by its number.
  struct WorkItem {
    std::size_t number, work;
    bool is_done;
  };

  /// Calls run_item(i) for each i < count, on any threads; work_of(i) is about how much work that is. A thread that rounds
  /// otherwise runs nothing. What no thread runs, or had no memory for, the calling thread runs when all have returned. What
  /// the executor throws, and what run_item throws there, is thrown on. REQUIRES: run_item begins anew with an item that it
  /// could not finish.
  template <class WorkOf, class RunItem>
  void run(const Executor& executor, std::size_t count, const WorkOf& work_of, const RunItem& run_item) {
    divide(executor.threads(), count, work_of);
    const auto finish = [&](WorkItem& item) {
      run_item(item.number);
      item.is_done = true;
    };
    const auto take_items = [&](std::size_t own) {
      if (kernel::check_rounding() != kernel::Refusal::none) return;
      for (std::size_t i = 0; i < used_; ++i) {
        Share& share = shares_[(own + i) % used_];
        for (std::size_t k = share.next++; k < share.end; k = share.next++) {
          try {
            finish(items_[k]);
          } catch (const std::bad_alloc&) {
            // It is not done.
          }
        }
      }
    };
    executor.run(used_, std::cref(take_items));
    for (WorkItem& item : items_) {
      if (!item.is_done) finish(item);
    }
  }

  /// Reserves memory for so many items.
  void reserve(std::size_t items) { items_.reserve(items); }

  /// Of the last run.
  [[nodiscard]] const std::vector<WorkItem>& items() const { return items_; }

 private:
  /// Items from `next` to before `end`. In a cache line of its own, because other threads write to others.
  struct alignas(64) Share {
    std::atomic<std::size_t> next = 0;
    std::size_t end = 0;
  };

  template <class WorkOf>
  void divide(std::size_t threads, std::size_t count, const WorkOf& work_of) {
    while (shares_.size() < threads) shares_.emplace_back();
    used_ = std::min(threads, count);
    items_.clear();
    std::size_t all = 0, before = 0, first = 0;
    for (std::size_t i = 0; i < count; ++i) {
      items_.push_back({i, work_of(i) + 1, false});
      all += items_.back().work;
    }
    for (std::size_t i = 0, end = 0; i < used_; ++i, first = end) {
      // An item that lies across the border of two shares belongs to the one that has its middle.
      for (; end < count && (before + items_[end].work / 2) * used_ < all * (i + 1); ++end) before += items_[end].work;
      shares_[i].next = first;
      shares_[i].end = end;
      std::sort(
          items_.begin() + static_cast<std::ptrdiff_t>(first), items_.begin() + static_cast<std::ptrdiff_t>(end),
          [](const WorkItem& a, const WorkItem& b) { return a.work != b.work ? a.work > b.work : a.number < b.number; });
    }
  }

  std::vector<WorkItem> items_;
  std::deque<Share> shares_;  ///< may be longer than what is used
  std::size_t used_ = 0;
};

}  // namespace occlude::culler
