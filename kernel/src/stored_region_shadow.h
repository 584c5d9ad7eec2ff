// SPDX-License-Identifier: MIT
// How the shadow of a region is stored (region_shadow.h): its planes as those of a frustum, and for axis-aligned boxes what
// else can separate it from a box (separation.h), made once.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "stored_frustum.h"

namespace occlude::kernel {

/// A number, as two doubles between which it lies.
struct Enclosed {
  double low, high;
};

/// How far the shadow reaches along a coordinate axis.
struct Extent {
  Enclosed least{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  Enclosed greatest{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
};

struct StoredRegionShadow {
  StoredFrustum planes;
  bool is_moderate = false;           ///< all numbers are (moderate.h)
  bool has_outlines = false;          ///< else the rest is empty
  std::vector<FilterPlane> outlines;  ///< sums of two planes that change along one axis no more
  FilterBound outline_bound;
  std::array<Extent, 3> extents;
};

/// Makes the outlines and the extents. REQUIRES: the planes were made, and the numbers are moderate.
void add_outlines(StoredRegionShadow& shadow);

}  // namespace occlude::kernel
