// SPDX-License-Identifier: MIT
// The work of testing boxes against shadows, where it has to be bounded.
#pragma once

#include <algorithm>
#include <cstddef>

#include "occlude/kernel/shadow_frustum.h"

namespace occlude::culler {

/// Work is counted, not timed, so that what a bound leaves out is the same on every machine. The unit is the test of a box
/// against a plane: some ten nanoseconds.
class PlaneWork {
 public:
  /// An answer of the exact stage takes up to twenty microseconds, as much as this many planes.
  static constexpr std::size_t kExact = 2048;

  explicit PlaneWork(std::size_t most) : most_(most) {}

  [[nodiscard]] bool is_left() const { return taken_ < most_; }
  [[nodiscard]] std::size_t left() const { return most_ - std::min(most_, taken_); }
  [[nodiscard]] std::size_t taken() const { return taken_; }
  void take(std::size_t planes) { taken_ += planes; }
  /// The work of an answer about one box and one shadow.
  void take(const kernel::ShadowFrustum& shadow, kernel::Stage stage) {
    take(shadow.plane_count() + (stage == kernel::Stage::exact ? kExact : 0));
  }

 private:
  std::size_t most_, taken_ = 0;
};

}  // namespace occlude::culler
