// SPDX-License-Identifier: MIT
#include "dealer.h"

#include <fmt/format.h>

#include <utility>

#include "occlude/render/errors.h"
#include "occlude/render/packing.h"

namespace occlude::render {

std::optional<Dealer::Part> Dealer::next() {
  const std::lock_guard lock(mutex_);
  std::optional<Part> part;
  attempt([&] { part = next_not_kept(); });
  return part;
}

void Dealer::accept(std::uint64_t number, const std::string& result, std::size_t rank) {
  const std::lock_guard lock(mutex_);
  attempt([&] {
    const auto input = inputs_.extract(number);
    const std::string place = fmt::format("rank {}", rank);
    if (input.empty()) throw InputError(place + ": a result of a part that it was not given");
    take(number, {result, place});
    // A result that cannot be taken is not kept: take() has thrown.
    if (kept_ != nullptr) kept_->keep({stage_number_, number}, input.mapped(), result);
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
    if (kept_ == nullptr) {
      inputs_[number];
      return Part{number, std::move(*input)};
    }
    if (std::optional<std::string> result = kept_->find({stage_number_, number}, *input)) {
      take(number, {std::move(*result), kept_->file_of({stage_number_, number}).string()});
      continue;
    }
    inputs_[number] = *input;
    return Part{number, std::move(*input)};
  }
  return std::nullopt;
}

void Dealer::take(std::uint64_t number, Result result) {
  waiting_[number] = std::move(result);
  while (!waiting_.empty() && waiting_.begin()->first == taken_) {
    ++taken_;
    const Result first = waiting_.extract(waiting_.begin()).mapped();
    try {
      stage_.take(first.bytes);
    } catch (const PartError& error) {
      throw InputError(fmt::format("{}: not the result of this part: {}", first.place, error.what()));
    }
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
