// SPDX-License-Identifier: MIT
// The joined shadow of polygons as convex pieces: the shadow of a triangle, and where it is seen edge-on the flat ones of
// its edges and corners.
#pragma once

#include <optional>
#include <vector>

#include "occlude/oracle/questions.h"
#include "plane.h"

namespace occlude::oracle {

/// What is on the inner side of all of these: with the planes of `closed`, without those of `open`.
template <class N>
struct ShadowPiece {
  std::vector<HalfSpace<N>> closed, open;
};

template <class N>
[[nodiscard]] std::vector<ShadowPiece<N>> pieces_of(const Viewpoint& view, const std::vector<Loop>& polygons,
                                                    const std::optional<HalfSpaceCoefficients>& drawn);

}  // namespace occlude::oracle
