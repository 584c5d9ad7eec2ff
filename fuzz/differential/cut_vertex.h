// SPDX-License-Identifier: MIT
// A polytope with a vertex less.
#pragma once

#include <cstdint>
#include <vector>

#include "occlude/kernel/types.h"

namespace occlude::fuzz {

/// What may be left of a convex polytope when a vertex is cut off: the faces round it lose it, and the hole is covered by
/// one polygon or by a fan of triangles from one of its corners, whichever is convex. None where the faces round it do not
/// close, as where a corner lies on a neighbour's edge. REQUIRES: there is such a vertex.
[[nodiscard]] std::vector<kernel::Polytope> cut_vertex(const kernel::Polytope& polytope, std::uint32_t vertex);

}  // namespace occlude::fuzz
