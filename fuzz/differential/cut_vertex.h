// SPDX-License-Identifier: MIT
// Removes a vertex from a polytope.
#pragma once

#include <cstdint>
#include <vector>

#include "occlude/kernel/types.h"

namespace occlude::fuzz {

/// The candidates for what is left of a convex polytope when a vertex is cut off. The faces around the vertex lose it. The
/// hole is covered by one polygon, or by a fan of triangles from one of its corners. The caller finds out which of these is
/// convex. Empty when the faces around the vertex do not close, for example when it is on an edge of a neighbour. REQUIRES:
/// the vertex exists.
[[nodiscard]] std::vector<kernel::Polytope> cut_vertex(const kernel::Polytope& polytope, std::uint32_t vertex);

}  // namespace occlude::fuzz
