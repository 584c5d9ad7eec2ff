// SPDX-License-Identifier: MIT
// Joined shadows, answered as exactly as the questions of oracle.h.
#pragma once

#include <optional>
#include <vector>

#include "occlude/oracle/oracle.h"
#include "occlude/oracle/questions.h"

namespace occlude::oracle {

/// Relation of `box` to the joined shadow of the polygons, each drawn as its fan: inside when every point of the box has one
/// of their triangles strictly between it and the viewpoint, else partial. With `drawn`, only the part of a triangle in that
/// half-space counts, and a triangle seen edge-on does not count. The time may grow exponentially with the number of
/// triangles. A question that would take more than about half a minute is refused, like one with bad numbers.
[[nodiscard]] Answer relation_to_cover(const Viewpoint& view, const std::vector<Loop>& polygons, const Box& box,
                                       const std::optional<HalfSpaceCoefficients>& drawn = {});

}  // namespace occlude::oracle
