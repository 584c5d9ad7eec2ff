// SPDX-License-Identifier: MIT
// Joined shadows, judged as the questions of oracle.h are.
#pragma once

#include <optional>
#include <vector>

#include "occlude/oracle/oracle.h"
#include "occlude/oracle/questions.h"

namespace occlude::oracle {

/// Relation of `box` to the joined shadow of the polygons, each its fan of triangles: inside when each of its points has one
/// of them strictly between it and the viewpoint, else partial. With `drawn` only what of the triangles is in that
/// half-space counts, and of those that are seen edge-on nothing. The time may grow exponentially with their number: what
/// would take more than half a minute or so is refused.
[[nodiscard]] Answer relation_to_cover(const Viewpoint& view, const std::vector<Loop>& polygons, const Box& box,
                                       const std::optional<HalfSpaceCoefficients>& drawn = {});

}  // namespace occlude::oracle
