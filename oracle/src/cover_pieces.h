// SPDX-License-Identifier: MIT
// The joined shadow of polygons as convex pieces: the shadow of each triangle, or, for a triangle seen edge-on, the flat
// shadows of its edges and corners.
#pragma once

#include <optional>
#include <vector>

#include "occlude/oracle/questions.h"
#include "plane.h"

namespace occlude::oracle {

/// The points on the inner side of all these half-spaces. The planes of `closed` belong to the piece, those of `open` do
/// not.
template <class N>
struct ShadowPiece {
  std::vector<HalfSpace<N>> closed, open;
};

template <class N>
[[nodiscard]] std::vector<ShadowPiece<N>> pieces_of(const Viewpoint& view, const std::vector<Loop>& polygons,
                                                    const std::optional<HalfSpaceCoefficients>& drawn);

}  // namespace occlude::oracle
