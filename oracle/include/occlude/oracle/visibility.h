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

/// Of each triangle whether any of it shows: whether the rays from the viewpoint that meet it before all others fill an open
/// set. All triangles are opaque from both sides. What of one lies outside of a half-space is clipped away: it neither shows
/// nor hides. A triangle seen edge-on shows nothing; of triangles in one plane none hides another. The time grows with the
/// square of their number: seconds for a few thousand. REQUIRES: all numbers are finite, and a direction is not zero.
[[nodiscard]] std::vector<bool> visible_triangles(const Viewpoint& view, std::span<const Triangle> triangles,
                                                  std::span<const HalfSpaceCoefficients> half_spaces);

}  // namespace occlude::oracle
