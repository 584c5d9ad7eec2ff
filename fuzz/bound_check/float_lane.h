// SPDX-License-Identifier: MIT
// A float that is summed in the same order as lanes, with or without fused multiply-adds.
#pragma once

#include <cmath>

#include "lanes-inl.h"

namespace occlude::bound_check {

template <bool kIsFused>
struct FloatLane {
  float value = 0;

  FloatLane() = default;
  FloatLane(double x) : value(static_cast<float>(x)) {}  // implicit, because the kernel's templates mix numbers and doubles

  friend FloatLane operator+(FloatLane a, FloatLane b) { return FloatLane(double{a.value + b.value}); }
  friend FloatLane operator-(FloatLane a, FloatLane b) { return FloatLane(double{a.value - b.value}); }
  friend FloatLane operator*(FloatLane a, FloatLane b) { return FloatLane(double{a.value * b.value}); }
  friend bool operator<(FloatLane a, FloatLane b) { return a.value < b.value; }
  friend FloatLane multiply_add(FloatLane a, FloatLane b, FloatLane c) {
    return kIsFused ? FloatLane(double{std::fma(a.value, b.value, c.value)}) : a * b + c;
  }
};

template <bool kIsFused>
using FloatLanes = kernel::Vector3<FloatLane<kIsFused>>;

template <bool kIsFused>
[[nodiscard]] FloatLane<kIsFused> dot(const FloatLanes<kIsFused>& a, const FloatLanes<kIsFused>& b) {
  return kernel::HWY_NAMESPACE::fused_dot(a, b);
}
template <bool kIsFused>
[[nodiscard]] FloatLane<kIsFused> dot(const FloatLanes<kIsFused>& a, const FloatLanes<kIsFused>& b,
                                      const FloatLane<kIsFused>& plus) {
  return kernel::HWY_NAMESPACE::fused_dot(a, b, plus);
}

/// An arithmetic for AabbFrame.
template <bool kIsFused>
struct FloatArithmetic {
  using Number = FloatLane<kIsFused>;
  static Number constant(Number x) { return x; }
  static Number difference(double a, double b) { return a - b; }
  static Number magnitude(Number x) { return std::fabs(x.value); }
  static Number rounded(Number x) { return x; }
};

}  // namespace occlude::bound_check
