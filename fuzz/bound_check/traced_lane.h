// SPDX-License-Identifier: MIT
// A traced number that is summed in the same order as lanes.
#pragma once

#include "lanes-inl.h"
#include "traced_number.h"

namespace occlude::bound_check {

/// multiply_add() rounds twice here. A fused one omits the first rounding and is otherwise the same.
template <int kBits>
struct BasicTracedLane : BasicTracedNumber<kBits> {
  using Traced = BasicTracedNumber<kBits>;
  using Traced::Traced;
  BasicTracedLane(const Traced& x) : Traced(x) {}  // implicit, so that sums of lanes are lanes

  friend BasicTracedLane multiply_add(const BasicTracedLane& a, const BasicTracedLane& b, const BasicTracedLane& c) {
    return a * b + c;
  }
};

template <int kBits>
using TracedLanes = kernel::Vector3<BasicTracedLane<kBits>>;

template <int kBits>
[[nodiscard]] BasicTracedLane<kBits> dot(const TracedLanes<kBits>& a, const TracedLanes<kBits>& b) {
  return kernel::HWY_NAMESPACE::fused_dot(a, b);
}
template <int kBits>
[[nodiscard]] BasicTracedLane<kBits> dot(const TracedLanes<kBits>& a, const TracedLanes<kBits>& b,
                                         const BasicTracedLane<kBits>& plus) {
  return kernel::HWY_NAMESPACE::fused_dot(a, b, plus);
}

template <int kBits>
struct BasicTracingLaneArithmetic {
  using Number = BasicTracedLane<kBits>;
  static Number constant(const Number& x) { return x; }
  static Number difference(double a, double b) { return BasicTracingArithmetic<kBits>::difference(a, b); }
  static Number magnitude(const Number& x) { return fabs(static_cast<const BasicTracedNumber<kBits>&>(x)); }
  static Number rounded(const Number& x) { return x; }
};
using TracingLaneArithmetic = BasicTracingLaneArithmetic<53>;

}  // namespace occlude::bound_check
