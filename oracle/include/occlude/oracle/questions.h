// SPDX-License-Identifier: MIT
// The kernel's other questions, answered as exactly as those of oracle.h: boxes against view frusta, the silhouette, and the
// relation of two convex objects as they are seen.
#pragma once

#include <array>
#include <span>
#include <string>
#include <vector>

#include "occlude/oracle/oracle.h"

namespace occlude::oracle {

/// The closed half-space a*x + b*y + c*z + d >= 0.
using HalfSpaceCoefficients = std::array<double, 4>;

/// Relation of `box` to the intersection of the half-spaces. The box is outside when the intersection is empty.
[[nodiscard]] Answer relation_to_half_spaces(std::span<const HalfSpaceCoefficients> half_spaces, const Box& box);

/// The silhouette of an occluder, or why there is none.
struct Outline {
  std::string refusal;
  /// The vertices at which the silhouette turns, in lexicographic order, each position once. Two vertices of a polygon that
  /// is not coplanar may be seen as one point. Then both are listed.
  std::vector<Point> corners;
  Point farthest{};  ///< the silhouette vertex farthest from the viewpoint; on a tie the first in the input
};

[[nodiscard]] Outline outline(const Viewpoint& view, const Occluder& occluder);

/// Relation of the cone of rays from the viewpoint that meet the occludee to the cone of those that meet the occluder:
/// inside when it is a subset, outside when the cones share no ray.
[[nodiscard]] Answer cone_relation(const Viewpoint& view, const Occluder& occluder, const Occluder& occludee);

}  // namespace occlude::oracle
