// SPDX-License-Identifier: MIT
#include "waiting_threads.h"

namespace occlude::experiments {

WaitingThreads::WaitingThreads(std::size_t threads) {
  try {
    while (others_.size() + 1 < threads) others_.emplace_back([this] { wait_and_work(); });
  } catch (...) {
    end();
    throw;
  }
}

WaitingThreads::~WaitingThreads() { end(); }

void WaitingThreads::end() {
  is_over_ = true;
  ++round_;
}

culler::Executor WaitingThreads::executor() {
  return {others_.size() + 1, [this](std::size_t count, const culler::Executor::Part& part) { run(count, part); }};
}

void WaitingThreads::wait_and_work() {
  for (std::size_t seen = 0;; ++seen) {
    while (round_ == seen) std::this_thread::yield();
    if (is_over_) return;
    work();
    --busy_;
  }
}

void WaitingThreads::run(std::size_t count, const culler::Executor::Part& part) {
  count_ = count;
  part_ = &part;
  next_ = 0;
  busy_ = others_.size();
  ++round_;
  work();
  while (busy_ != 0) std::this_thread::yield();
}

void WaitingThreads::work() {
  for (std::size_t i = next_++; i < count_; i = next_++) (*part_)(i);
}

}  // namespace occlude::experiments
