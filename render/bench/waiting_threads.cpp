// SPDX-License-Identifier: MIT
#include "waiting_threads.h"

namespace occlude::experiments {

WaitingThreads::WaitingThreads(std::size_t threads) {
  try {
    for (std::size_t i = 1; i < threads; ++i) others_.emplace_back([this, i] { wait_and_work(i); });
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

void WaitingThreads::wait_and_work(std::size_t thread) {
  for (std::size_t seen = 0;; ++seen) {
    while (round_ == seen) std::this_thread::yield();
    if (is_over_) return;
    work(thread);
    --busy_;
  }
}

void WaitingThreads::run(std::size_t count, const culler::Executor::Part& part) {
  count_ = count;
  part_ = &part;
  busy_ = others_.size();
  ++round_;
  work(0);
  while (busy_ != 0) std::this_thread::yield();
}

void WaitingThreads::work(std::size_t thread) const {
  for (std::size_t i = thread; i < count_; i += others_.size() + 1) (*part_)(i);
}

}  // namespace occlude::experiments
