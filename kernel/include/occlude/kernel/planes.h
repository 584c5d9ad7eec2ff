// SPDX-License-Identifier: MIT
// How a shadow frustum holds its planes: in input coordinates, which are exact, and in doubles, which are fast. Reading
// order: 6.
#pragma once

#include <array>
#include <cstdint>
#include <variant>

#include "occlude/kernel/types.h"

namespace occlude::kernel {

/// An oriented plane given by input coordinates alone: f(x) = N . (x - origin), N = a cross b or, when `direct`, N = a, with
/// a = a_to - a_from and b = b_to - b_from taken exactly. The inner side is f >= 0.
struct ExactPlane {
  bool direct = false;
  Vec3 a_to, a_from, b_to, b_from, origin;

  friend bool operator==(const ExactPlane&, const ExactPlane&) = default;
};

/// Through the edge in which side `side` meets the one near plane, parallel to `axis`: the positive combination
/// |N_side . axis| f_near + |N_near . axis| f_side of their values, in which `axis` cancels.
struct CutEdgePlane {
  std::uint32_t side;  ///< number of the plane
  Vec3 axis;

  friend bool operator==(const CutEdgePlane&, const CutEdgePlane&) = default;
};

/// Parallel to `face`, through the point in which the frustum's edge through a corner of the silhouette meets the one near
/// plane. REQUIRES: face.origin is that corner.
struct CutVertexPlane {
  std::uint32_t corner;
  ExactPlane face;

  friend bool operator==(const CutVertexPlane&, const CutVertexPlane&) = default;
};

using PlaneRecipe = std::variant<ExactPlane, CutEdgePlane, CutVertexPlane>;

/// What rounding can do to the values of planes: over a box that reaches as far as `reach` from the origin of the frustum
/// they are off by at most slope * reach + base (error_bounds.h).
/// `Real` is double, or a number that follows every rounding.
template <class Real>
struct BasicFilterBound {
  Real slope = 0, base = 0;

  friend bool operator==(const BasicFilterBound&, const BasicFilterBound&) = default;
};
using FilterBound = BasicFilterBound<double>;

/// A plane in doubles, for points relative to the origin of the frustum, each coordinate rounded once. It is scaled by a
/// power of two so that the slope of its bound lies in [1/2, 1): one bound then serves all planes of a frustum.
struct FilterPlane {
  Vec3 normal, magnitudes;  ///< its components, and their absolute values
  double offset = 0;
  /// Where CornerFrame keeps the coordinates of the vertex farthest along the normal: axis + (0 for min, 4 for max).
  std::array<std::uint8_t, 4> farther{};

  friend bool operator==(const FilterPlane&, const FilterPlane&) = default;
};

/// The next 53 bits of the same: |N - (normal of the filter plane + normal)| <= uncertainty.slope in sum of components, the
/// offset likewise to uncertainty.base; up to the roundings of these sums.
struct RefinedPlane {
  Vec3 normal;
  double offset = 0;
  FilterBound uncertainty;

  friend bool operator==(const RefinedPlane&, const RefinedPlane&) = default;
};

}  // namespace occlude::kernel
