// SPDX-License-Identifier: MIT
// How a caller takes part in work that takes seconds: stops it, and says on which threads it is done. Reading order: 1.
#pragma once

#include <concepts>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>

#include "occlude/culler/executor.h"

namespace occlude::culler {

/// A function of the caller that long work calls every few milliseconds, on any of its threads and on several at once. What
/// it throws stops the work and is thrown on to the caller. So an engine cancels loading by throwing.
class Checkpoint {
 public:
  /// Calls nothing, and works on all processors.
  Checkpoint() = default;
  template <std::invocable Call>
  requires(!std::same_as<std::remove_cvref_t<Call>, Checkpoint>) Checkpoint(Call&& call)
      : call_(std::forward<Call>(call)) {}  // NOLINT: any call is one
  /// Calls nothing, and works by this executor.
  explicit Checkpoint(Executor executor) : executor_(std::move(executor)) {}
  template <std::invocable Call>
  Checkpoint(Call&& call, Executor executor) : call_(std::forward<Call>(call)), executor_(std::move(executor)) {}

  void operator()() const {
    if (call_) call_();
  }
  /// For step i of a loop of short steps: calls the function once in 2^14 steps, beginning with step 0.
  void at(std::size_t i) const {
    constexpr std::size_t kSteps = std::size_t{1} << 14U;  // each takes microseconds at most
    if (i % kSteps == 0) (*this)();
  }

  [[nodiscard]] const Executor& executor() const { return executor_; }

 private:
  std::function<void()> call_;
  Executor executor_ = Executor::own_threads();
};

}  // namespace occlude::culler
