// SPDX-License-Identifier: MIT
#include "held/background.h"

#include <condition_variable>
#include <mutex>
#include <utility>

namespace occlude::culler {

/// It is shared with the caller's thread, which may have it after all else is gone.
class Background::Task {
 public:
  explicit Task(std::function<void()> work) : work_(std::move(work)) {}

  /// Does the work, unless another thread does or it was dropped.
  void run() {
    if (!begin()) return;
    work_();
    const std::lock_guard lock(mutex_);
    state_ = State::ended;
    ended_.notify_all();
  }
  /// Returns when nobody does the work any more.
  void drop() {
    if (begin()) return;
    std::unique_lock lock(mutex_);
    ended_.wait(lock, [&] { return state_ == State::ended; });
  }
  [[nodiscard]] bool has_ended() {
    const std::lock_guard lock(mutex_);
    return state_ == State::ended;
  }

 private:
  enum class State { waiting, begun, ended };

  /// True the first time.
  bool begin() {
    const std::lock_guard lock(mutex_);
    return std::exchange(state_, state_ == State::waiting ? State::begun : state_) == State::waiting;
  }

  std::function<void()> work_;
  std::mutex mutex_;
  std::condition_variable ended_;
  State state_ = State::waiting;
};

Background::~Background() {
  if (task_ != nullptr) task_->drop();
}

void Background::start(std::function<void()> work) {
  const auto task = std::make_shared<Task>(std::move(work));
  try {
    later_([task] { task->run(); });
  } catch (...) {
    task->drop();
    throw;
  }
  task_ = task;
}

bool Background::has_ended() {
  if (!task_->has_ended()) return false;
  task_ = nullptr;
  return true;
}

void Background::finish() {
  task_->run();
  task_->drop();
}

}  // namespace occlude::culler
