// SPDX-License-Identifier: MIT
#include "coarse_plane.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "error_bounds.h"

namespace occlude::kernel {

CoarsePlane coarse(const FilterPlane& plane, const FilterBound& filter_bound, CoarseBound& bound) {
  if (!(std::fabs(plane.offset) < kCoarseOffset)) {
    bound.twice_base = std::numeric_limits<float>::infinity();
    return {};
  }
  const double magnitudes = plane.magnitudes.x + plane.magnitudes.y + plane.magnitudes.z;
  const double slope = kCoarsePlaneError * magnitudes + 4 * filter_bound.slope;
  const double base = kCoarseOffsetError * std::fabs(plane.offset) + 4 * filter_bound.base + kCoarseUnderflow;
  bound.slope = std::max(bound.slope, static_cast<float>(slope * kCoarseInflation));
  bound.twice_base = std::max(bound.twice_base, static_cast<float>(2 * base * kCoarseInflation));
  const auto in_float = [](double x) { return static_cast<float>(x); };
  return {in_float(plane.normal.x), in_float(plane.normal.y), in_float(plane.normal.z), in_float(2 * plane.offset)};
}

}  // namespace occlude::kernel
