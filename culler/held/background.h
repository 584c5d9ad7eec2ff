// SPDX-License-Identifier: MIT
// One task at a time on another thread of the caller's.
#pragma once

#include <functional>
#include <memory>

#include "occlude/culler/held_cull.h"

namespace occlude::culler {

class Background {
 public:
  explicit Background(Later later) : later_(std::move(later)) {}
  /// Drops a task that has not begun, and waits for one that is running.
  ~Background();
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  [[nodiscard]] bool is_there() const { return later_ != nullptr; }
  /// Whether a task was started and not yet seen to have ended.
  [[nodiscard]] bool is_busy() const { return task_ != nullptr; }
  /// Has the task run some time. It throws nothing. What the caller's function throws is thrown on, and the task is dropped.
  /// REQUIRES: not is_busy().
  void start(std::function<void()> work);
  /// Whether the task has ended, which it is told once. REQUIRES: is_busy().
  [[nodiscard]] bool has_ended();
  /// Ends it: runs what has not begun. REQUIRES: is_busy().
  void finish();

 private:
  class Task;

  Later later_;
  std::shared_ptr<Task> task_;
};

}  // namespace occlude::culler
