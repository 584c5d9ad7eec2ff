// SPDX-License-Identifier: MIT
// A plane's coefficients rounded to doubles, and to twice their precision, with bounds on what rounding does to its values.
#pragma once

#include "occlude/kernel/planes.h"
#include "plane_coefficients.h"

namespace occlude::kernel {

struct RoundedPlane {
  FilterPlane filter;
  FilterBound bound;
  RefinedPlane refined;
};

[[nodiscard]] RoundedPlane rounded(const PlaneCoefficients<DoubleDoubleArithmetic>& plane);

/// Sign of the plane at a vertex of the box whose bounds, relative to `origin`, reach as far as `reach`: at its low or high
/// vertex along the plane's normal. 0 with `is_certain` false when twice the precision of a double cannot tell.
struct CertainSign {
  int sign = 0;
  bool is_certain = false;
};
[[nodiscard]] CertainSign refined_sign(const FilterPlane& plane, const RefinedPlane& tail, const Vec3& vertex,
                                       const Vec3& origin, double reach);

}  // namespace occlude::kernel
