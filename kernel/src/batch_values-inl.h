// SPDX-License-Identifier: MIT
// The values of a plane over as many boxes as a vector has lanes. Compiled for every instruction set of those who include
// it.
#if defined(OCCLUDE_BATCH_VALUES_INL_H) == defined(HWY_TARGET_TOGGLE)
#ifdef OCCLUDE_BATCH_VALUES_INL_H
#undef OCCLUDE_BATCH_VALUES_INL_H
#else
#define OCCLUDE_BATCH_VALUES_INL_H
#endif

#include <hwy/highway.h>

#include <cstddef>

#include "occlude/kernel/planes.h"

#ifndef OCCLUDE_MAX_LANES
#define OCCLUDE_MAX_LANES
namespace occlude::kernel {

/// No vector is taken longer, so that what is read and written beyond the end is bounded.
inline constexpr std::size_t kMaxLanes = 32;

}  // namespace occlude::kernel
#endif

HWY_BEFORE_NAMESPACE();
namespace occlude::kernel {
namespace {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using Doubles = hn::CappedTag<double, kMaxLanes>;
using Vector = hn::Vec<Doubles>;

/// Sums and differences of the bounds of the boxes in the lanes, relative to the origin of a frustum: twice their centres
/// and twice their half extents, in which both extremal vertices of every plane are alike to find.
struct Block {
  Vector center_x, center_y, center_z, extent_x, extent_y, extent_z;
};

/// Twice the values of a plane at the centres of the boxes, and twice what it gains from there to a vertex at most.
struct Values {
  Vector center, spread;
};

HWY_INLINE Values values(const Block& block, const FilterPlane& plane) {
  const Doubles d;
  const Vector nx = hn::Set(d, plane.normal.x), ny = hn::Set(d, plane.normal.y), nz = hn::Set(d, plane.normal.z);
  const Vector z = hn::MulAdd(nz, block.center_z, hn::Set(d, 2 * plane.offset));
  return {hn::MulAdd(nx, block.center_x, hn::MulAdd(ny, block.center_y, z)),
          hn::MulAdd(hn::Abs(nx), block.extent_x,
                     hn::MulAdd(hn::Abs(ny), block.extent_y, hn::Mul(hn::Abs(nz), block.extent_z)))};
}

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace occlude::kernel
HWY_AFTER_NAMESPACE();

#endif
