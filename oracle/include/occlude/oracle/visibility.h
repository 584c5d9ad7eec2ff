// SPDX-License-Identifier: MIT
// Exact visibility: which triangles of a small scene show in a picture of any resolution. The ground truth for a culler,
// that no sampling of rays or pixels can miss.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "occlude/oracle/oracle.h"
#include "occlude/oracle/questions.h"

namespace occlude::oracle {

using Triangle = std::array<Point, 3>;

/// What a picture has of a scene.
struct Picture {
  /// The near and the far plane. What is outside of one of these, or lies in its plane, neither shows nor hides.
  std::vector<HalfSpaceCoefficients> depth;
  /// What is outside of one of these shows nothing, but may hide: the sides of the picture, which in doubles hardly ever
  /// pass through the viewpoint exactly, and would cut what hides a hair's breadth more than what is hidden.
  std::vector<HalfSpaceCoefficients> sides;
};

/// Of each triangle whether any of it shows: whether the rays from the viewpoint that meet it before all others, in the
/// picture, fill an open set. All triangles are opaque from both sides. One seen edge-on shows nothing; of those in one
/// plane none hides another. The time grows with the square of their number, and with the pieces that what is hidden
/// is cut into. REQUIRES: all
/// numbers are finite, and a direction is not zero.
[[nodiscard]] std::vector<bool> visible_triangles(const Viewpoint& view, std::span<const Triangle> triangles,
                                                  const Picture& picture);

}  // namespace occlude::oracle
