// SPDX-License-Identifier: MIT
// Questions about the umbra and penumbra of an occluder for a region of viewpoints, made from random numbers.
#pragma once

#include "occlude/fuzz/case.h"
#include "occlude/fuzz/random.h"

namespace occlude::fuzz {

/// A third each:
/// - the scene of a case of any family, with a region about its viewpoint: a corner of the region may be a vertex of the
///   occluder, and its half edges may be edges of it, zero or any;
/// - polygons, tetrahedra and parallelepipeds on a small lattice, with a region on it: corners lie in planes of faces;
/// - rectangles before a larger region, whose umbra ends in a ridge or apex on the lattice; sheared.
/// The box is at a point of a line of sight through a vertex of the occluder, at the end of the umbra, or anywhere. A few in
/// a hundred are not legal.
[[nodiscard]] RegionCase region_question(Random& random, kernel::ShadowKind kind);

}  // namespace occlude::fuzz
