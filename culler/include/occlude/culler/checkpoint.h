// SPDX-License-Identifier: MIT
// How a caller stops work that takes seconds.
#pragma once

#include <concepts>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>

namespace occlude::culler {

/// A call that the caller wants made now and then, from any of the threads that work and from several at once. What it
/// throws stops the work and comes out of it: an engine throws when its loading screen was left.
class Checkpoint {
 public:
  /// Nothing is called.
  Checkpoint() = default;
  template <std::invocable Call>
  requires(!std::same_as<std::remove_cvref_t<Call>, Checkpoint>) Checkpoint(Call&& call)
      : call_(std::forward<Call>(call)) {}  // NOLINT: any call is one

  void operator()() const {
    if (call_) call_();
  }
  /// For step i of a loop with short steps: only now and then.
  void at(std::size_t i) const {
    constexpr std::size_t kSteps = std::size_t{1} << 14U;  // of at most microseconds each: some of them a second
    if (i % kSteps == 0) (*this)();
  }

 private:
  std::function<void()> call_;
};

}  // namespace occlude::culler
