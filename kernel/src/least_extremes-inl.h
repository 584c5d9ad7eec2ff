// SPDX-License-Identifier: MIT
// What the filter of the conservative test knows of the boxes in the lanes of a vector. This file is compiled for every
// instruction set of the files that include it.
#if defined(OCCLUDE_LEAST_EXTREMES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef OCCLUDE_LEAST_EXTREMES_INL_H
#undef OCCLUDE_LEAST_EXTREMES_INL_H
#else
#define OCCLUDE_LEAST_EXTREMES_INL_H
#endif

#include <hwy/highway.h>

#include "lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace occlude::kernel {
namespace HWY_NAMESPACE {

using Mask = hn::Mask<Doubles>;
using Frame = AabbFrame<LaneArithmetic>;
using LaneVector = Vector3<Lanes>;

/// What the filter knows about the tests in the lanes of a vector. A test of which none of these is set is inside.
struct Known {
  Mask outside, straddling, unknown;
};

/// The least value over all planes at the nearest vertex of each box, and at the farthest. One bound serves all planes of a
/// frustum, so the filter needs no more than these two.
struct Least {
  Lanes low, high;

  HWY_INLINE Least() : low(HUGE_VAL), high(HUGE_VAL) {}
  HWY_INLINE void include(const Extremes<Lanes>& extremes) {
    low = min(low, extremes.low());
    high = min(high, extremes.high());
  }
};

HWY_INLINE Known classify(const Least& least, Lanes error) {
  const auto minus_error = hn::Neg(error.v);
  const Mask outside = hn::Lt(least.high.v, minus_error);
  const Mask straddling = hn::And(hn::Lt(least.low.v, minus_error), hn::Gt(least.high.v, error.v));
  return {outside, straddling, hn::Not(hn::Or(hn::Or(outside, straddling), hn::Gt(least.low.v, error.v)))};
}

}  // namespace HWY_NAMESPACE
}  // namespace occlude::kernel
HWY_AFTER_NAMESPACE();

#endif
