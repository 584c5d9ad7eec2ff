// SPDX-License-Identifier: MIT
// A second judge, which checks the first. It finds the same relation in another way and shares only the types of oracle.h
// and region.h. It has no side planes and no silhouette, only triangles and weights of vertices. A program that links it
// (occlude::second_oracle) is GPL-3.0-or-later as a whole (docs/proof.md, Licences).
#pragma once

#include <span>

#include "occlude/oracle/oracle.h"
#include "occlude/oracle/region.h"
#include "occlude/oracle/region_shadow.h"

namespace occlude::oracle::second {

/// Relation of `box` to the shadow frustum of the occluder. It never refuses. REQUIRES: the question is legal, which the
/// first oracle decides: its relation() of the same arguments has no refusal.
[[nodiscard]] Answer relation(const Viewpoint& view, const Occluder& occluder, const Near& near, const Box& box);

/// Relation of `box` to the umbra or penumbra of the occluder for a region. It never refuses. REQUIRES: the first oracle's
/// RegionShadow does not refuse these arguments.
[[nodiscard]] Answer relation(const ViewRegion& region, const Occluder& occluder, ShadowKind kind, const Box& box);

/// The verdict on a witness whose eyes are a box, without its reason in words. REQUIRES: the first oracle does not refuse
/// it.
[[nodiscard]] RegionVerdict judge(const RegionWitness& witness);

/// The same for the hull of `eyes` in place of the eyes of the witness.
[[nodiscard]] RegionVerdict judge(const RegionWitness& witness, std::span<const Point> eyes);

}  // namespace occlude::oracle::second
