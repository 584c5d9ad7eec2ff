// SPDX-License-Identifier: MIT
#include "dealer.h"

#include <utility>

namespace occlude::render {

std::optional<Dealer::Part> Dealer::next() {
  const std::lock_guard lock(mutex_);
  std::optional<Part> part;
  attempt([&] { part = next_not_kept(); });
  return part;
}

void Dealer::accept(std::uint64_t number, const std::string& result) {
  const std::lock_guard lock(mutex_);
  attempt([&] {
    take(number, result);
    // A result that shows bad input is not kept: take() has thrown.
    if (kept_ != nullptr) kept_->keep({stage_number_, number}, inputs_.extract(number).mapped(), result);
  });
}

void Dealer::fail(std::exception_ptr failure) {
  const std::lock_guard lock(mutex_);
  attempt([&] { std::rethrow_exception(std::move(failure)); });
}

void Dealer::finish() {
  const std::lock_guard lock(mutex_);
  if (failure_) std::rethrow_exception(failure_);
}

std::optional<Dealer::Part> Dealer::next_not_kept() {
  while (std::optional<std::string> input = stage_.next()) {
    const std::uint64_t number = dealt_++;
    if (kept_ == nullptr) return Part{number, std::move(*input)};
    if (std::optional<std::string> result = kept_->find({stage_number_, number}, *input)) {
      take(number, std::move(*result));
      continue;
    }
    inputs_[number] = *input;
    return Part{number, std::move(*input)};
  }
  return std::nullopt;
}

void Dealer::take(std::uint64_t number, std::string result) {
  waiting_[number] = std::move(result);
  while (!waiting_.empty() && waiting_.begin()->first == taken_) {
    ++taken_;
    stage_.take(waiting_.extract(waiting_.begin()).mapped());
  }
}

template <class Work>
void Dealer::attempt(Work&& work) {
  if (failure_) return;
  try {
    work();
  } catch (...) {
    failure_ = std::current_exception();
  }
}

}  // namespace occlude::render
