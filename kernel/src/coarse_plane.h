// SPDX-License-Identifier: MIT
// The planes of a shadow frustum in floats, for tests of eight boxes at once, twice as many in a vector. What they cannot
// tell is left to the planes in doubles.
#pragma once

#include <cstddef>

#include "planes.h"

namespace occlude::kernel {

/// A FilterPlane rounded to floats, with its offset doubled.
struct CoarsePlane {
  float x = 0, y = 0, z = 0, twice_offset = 0;

  friend bool operator==(const CoarsePlane&, const CoarsePlane&) = default;
};

/// Planes are tested so many at a time, with one branch less for each. The last of a frustum is repeated.
inline constexpr std::size_t kCoarseWidth = 2;

/// A bound of errors: twice the value of a CoarsePlane at a vertex of a box, computed in floats, is off by at most
/// slope * twice_reach + twice_base, and where it exceeds that bound, it exceeds the bound of the FilterPlane as well
/// (error_bounds.h).
struct CoarseBound {
  float slope = 0, twice_base = 0;

  friend bool operator==(const CoarseBound&, const CoarseBound&) = default;
};

/// The plane in floats, or one that decides nothing, with an infinite bound, if its offset is too large. `bound` becomes one
/// for this plane too. `filter_bound` is that of the frustum.
[[nodiscard]] CoarsePlane coarse(const FilterPlane& plane, const FilterBound& filter_bound, CoarseBound& bound);

}  // namespace occlude::kernel
