// SPDX-License-Identifier: MIT
// The forms in which a shadow frustum stores its planes: in input coordinates, which are exact, and in doubles, which are
// fast. Reading order: 6.
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

/// The plane through the edge in which a side plane meets the near plane (plane 0, the only one), parallel to `axis`. Its
/// value is |N_side . axis| f_near + |N_near . axis| f_side, in which `axis` cancels.
struct CutEdgePlane {
  std::uint32_t side;  ///< index of the side plane in StoredFrustum::recipes
  Vec3 axis;

  friend bool operator==(const CutEdgePlane&, const CutEdgePlane&) = default;
};

/// The plane parallel to `face` through a vertex of the near side: the point in which the ray through a silhouette corner
/// meets the near plane (plane 0, the only one). REQUIRES: face.origin is that corner.
struct CutVertexPlane {
  std::uint32_t corner;  ///< index in StoredFrustum::silhouette
  ExactPlane face;

  friend bool operator==(const CutVertexPlane&, const CutVertexPlane&) = default;
};

/// A corner of a region of eyes or of directions of view: exactly the sum of `at` and `moves`.
struct RegionCorner {
  bool is_eye = true;
  Vec3 at;
  std::array<Vec3, 3> moves;

  friend bool operator==(const RegionCorner&, const RegionCorner&) = default;
};

/// The plane through `point`, along the line of sight from a corner of a region to it and along to - from. Its inner side is
/// where (sight x (to - from)) . (x - point) >= 0.
struct SightPlane {
  RegionCorner corner;
  Vec3 point, to, from;

  friend bool operator==(const SightPlane&, const SightPlane&) = default;
};

/// A plane by input coordinates alone: nothing is rounded.
using PlaneRecipe = std::variant<ExactPlane, CutEdgePlane, CutVertexPlane, SightPlane>;

/// A bound on rounding errors: at a vertex of a box the value of a FilterPlane is off by at most slope * reach + base
/// (error_bounds.h). `reach` bounds every coordinate of the box, in magnitude, relative to the origin of the frustum.
/// `Real` is double, or a number type that tracks rounding errors.
template <class Real>
struct BasicFilterBound {
  Real slope = 0, base = 0;

  friend bool operator==(const BasicFilterBound&, const BasicFilterBound&) = default;
};
using FilterBound = BasicFilterBound<double>;

/// A plane in doubles: its value at x is normal . (x - origin of the frustum) + offset, where x - origin is rounded too. It
/// is scaled by a power of two that brings the slope of its bound into [1/2, 1), so that one bound serves all planes of a
/// frustum.
struct FilterPlane {
  Vec3 normal, magnitudes;  ///< the normal, and the absolute values of its components
  double offset = 0;
  /// For each axis, which bound of a box the vertex farthest along the normal has: axis + (0 for min, 4 for max). The fourth
  /// entry is padding.
  std::array<std::uint8_t, 4> farther{};

  friend bool operator==(const FilterPlane&, const FilterPlane&) = default;
};

/// What rounding to a FilterPlane lost: the next 53 bits of normal and offset, in the same scale. Added to the FilterPlane
/// they leave an error of at most uncertainty.slope in the normal (sum over components) and uncertainty.base in the offset,
/// up to the rounding of these bounds themselves.
struct RefinedPlane {
  Vec3 normal;
  double offset = 0;
  FilterBound uncertainty;

  friend bool operator==(const RefinedPlane&, const RefinedPlane&) = default;
};

}  // namespace occlude::kernel
