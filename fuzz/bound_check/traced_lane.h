// SPDX-License-Identifier: MIT
// A traced number that is summed in the same order as lanes.
#pragma once

#include "lanes-inl.h"
#include "traced_number.h"

namespace occlude::bound_check {

/// multiply_add() rounds twice here. A fused one omits the first rounding and is otherwise the same.
struct TracedLane : TracedNumber {
  using TracedNumber::TracedNumber;
  TracedLane(const TracedNumber& x) : TracedNumber(x) {}  // implicit, so that sums of lanes are lanes

  friend TracedLane multiply_add(const TracedLane& a, const TracedLane& b, const TracedLane& c) { return a * b + c; }
};

[[nodiscard]] inline TracedLane dot(const kernel::Vector3<TracedLane>& a, const kernel::Vector3<TracedLane>& b) {
  return kernel::HWY_NAMESPACE::fused_dot(a, b);
}
[[nodiscard]] inline TracedLane dot(const kernel::Vector3<TracedLane>& a, const kernel::Vector3<TracedLane>& b,
                                    const TracedLane& plus) {
  return kernel::HWY_NAMESPACE::fused_dot(a, b, plus);
}

struct TracingLaneArithmetic : TracingArithmetic {
  using Number = TracedLane;
  static TracedLane constant(const TracedLane& x) { return x; }
  static TracedLane difference(double a, double b) { return TracingArithmetic::difference(a, b); }
  static TracedLane magnitude(const TracedLane& x) { return fabs(x); }
  static TracedLane rounded(const TracedLane& x) { return x; }
};

}  // namespace occlude::bound_check
