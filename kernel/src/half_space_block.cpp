// SPDX-License-Identifier: MIT
// This file is compiled once for every instruction set; the one that runs is chosen at run time. Boxes that the filter
// cannot decide are left to the test of a single box.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "half_space_block.cpp"
#include <hwy/foreach_target.h>
// foreach_target.h must come first.
#include <hwy/highway.h>

#include <bit>
#include <cstddef>
#include <span>

#include "error_bounds.h"
#include "lanes-inl.h"
#include "occlude/kernel/box_block.h"

#ifndef OCCLUDE_HALF_SPACE_BLOCK_ONCE
#define OCCLUDE_HALF_SPACE_BLOCK_ONCE
namespace occlude::kernel {
namespace {

/// What the filter knows of the boxes of a block. Boxes of which none of these is set straddle the plane.
struct Known {
  unsigned outside = 0, inside = 0, unknown = 0;
};

/// The answers, by the test of a single box where the filter has none.
inline Known decided(const HalfSpace& half_space, const BoxBlock& block, BoxBits asked, Known known) {
  for (unsigned left = known.unknown & asked; left != 0; left &= left - 1) {
    const auto i = static_cast<unsigned>(std::countr_zero(left));
    const Relation relation = kernel::relation(half_space, block.box(i), Arithmetic::certified);
    known.outside |= (relation == Relation::outside ? 1U : 0U) << i;
    known.inside |= (relation == Relation::inside ? 1U : 0U) << i;
  }
  return {known.outside & asked, known.inside & asked};
}

}  // namespace
}  // namespace occlude::kernel
#endif

HWY_BEFORE_NAMESPACE();
namespace occlude::kernel {
namespace HWY_NAMESPACE {
namespace {

static_assert(kMaxLanes <= BoxBlock::kBoxes, "a vector of boxes is read from one block");

/// The value of the half-space at a corner of each box, and the bound of its error: as in half_space.cpp, where the
/// derivation of kHalfSpaceError allows any order of the sum.
struct Value {
  hn::Vec<Doubles> value, error;

  HWY_INLINE Value(const HalfSpace& h, const double* x, const double* y, const double* z) {
    const Doubles d;
    const auto px = hn::Mul(hn::Set(d, h.normal.x), hn::Load(d, x)), py = hn::Mul(hn::Set(d, h.normal.y), hn::Load(d, y)),
               pz = hn::Mul(hn::Set(d, h.normal.z), hn::Load(d, z));
    value = hn::Add(hn::Add(hn::Add(px, py), pz), hn::Set(d, h.offset));
    const auto magnitude = hn::Add(hn::Add(hn::Abs(px), hn::Abs(py)), hn::Abs(pz));
    error = hn::Mul(hn::Set(d, kHalfSpaceError), magnitude);
  }
};

HWY_INLINE Known filter(const HalfSpace& h, const BoxBlock& block) {
  const auto &x = h.normal.x >= 0 ? block.max[0] : block.min[0], &far_x = h.normal.x >= 0 ? block.min[0] : block.max[0];
  const auto &y = h.normal.y >= 0 ? block.max[1] : block.min[1], &far_y = h.normal.y >= 0 ? block.min[1] : block.max[1];
  const auto &z = h.normal.z >= 0 ? block.max[2] : block.min[2], &far_z = h.normal.z >= 0 ? block.min[2] : block.max[2];
  Known known;
  for (std::size_t i = 0; i < BoxBlock::kBoxes; i += hn::Lanes(Doubles())) {
    const Value most(h, &x[i], &y[i], &z[i]), least(h, &far_x[i], &far_y[i], &far_z[i]);
    const auto outside = hn::Lt(most.value, hn::Neg(most.error)), inside = hn::Gt(least.value, least.error);
    const auto straddles = hn::And(hn::Gt(most.value, most.error), hn::Lt(least.value, hn::Neg(least.error)));
    known.outside |= bits(Doubles(), outside) << i;
    known.inside |= bits(Doubles(), inside) << i;
    known.unknown |= bits(Doubles(), hn::Not(hn::Or(hn::Or(outside, inside), straddles))) << i;
  }
  return known;
}

HWY_ATTR BlockRelations relations(std::span<const HalfSpace> half_spaces, const BoxBlock& block, BoxBytes asked) {
  BlockRelations answers;
  for (BoxBytes left = asked; left != 0;) {
    const auto k = static_cast<std::size_t>(std::countr_zero(left)) / 8;
    const Known known = decided(half_spaces[k], block, boxes_of(asked, k), filter(half_spaces[k], block));
    answers.outside |= BoxBytes{known.outside} << 8 * k;
    answers.inside |= BoxBytes{known.inside} << 8 * k;
    left &= ~(BoxBytes{0xFF} << 8 * k);
  }
  return answers;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace occlude::kernel
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace occlude::kernel {
namespace {
HWY_EXPORT(relations);
}  // namespace

BlockRelations relations(std::span<const HalfSpace> half_spaces, const BoxBlock& block, BoxBytes asked) {
  return HWY_DYNAMIC_DISPATCH(relations)(half_spaces, block, asked);
}

}  // namespace occlude::kernel
#endif
