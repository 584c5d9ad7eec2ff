// SPDX-License-Identifier: MIT
// Exact visibility: which triangles of a small scene show in a picture of any resolution. This is the ground truth for a
// culler. Unlike a sampling of rays or pixels, it misses nothing.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "occlude/oracle/oracle.h"
#include "occlude/oracle/questions.h"

namespace occlude::oracle {

using Triangle = std::array<Point, 3>;

/// The part of a scene that a picture shows.
struct Picture {
  /// The near and the far plane. What is outside one of these, or in its plane, neither shows nor hides.
  std::vector<HalfSpaceCoefficients> depth;
  /// The sides of the picture. What is outside one of these does not show but may hide. A side given in doubles hardly ever
  /// passes through the viewpoint exactly. If the sides clipped what hides, they could clip slightly more of it than of what
  /// it hides.
  std::vector<HalfSpaceCoefficients> sides;
};

/// For each triangle, whether any of it shows: whether the rays from the viewpoint that meet it first, in the picture, fill
/// an open set. Triangles are opaque from both sides, but for those in `see_through`, which hide nothing; it is empty, or
/// has whether each is. A triangle seen edge-on does not show. Triangles in one plane do not hide each other. The time grows
/// with the square of the number of triangles, and with the number of pieces into which the hidden parts are cut. REQUIRES:
/// all numbers are finite; a direction is not zero.
[[nodiscard]] std::vector<bool> visible_triangles(const Viewpoint& view, std::span<const Triangle> triangles,
                                                  const Picture& picture, const std::vector<bool>& see_through = {});

}  // namespace occlude::oracle
