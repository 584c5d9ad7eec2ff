// SPDX-License-Identifier: MIT
// The choice of section 4.2: the list of the eye's region, narrowed to the view frustum, sorted by the objective, the best
// n_occ.
#pragma once

#include <span>

#include "occlude/culler/camera.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/occluder_grid.h"
#include "occlude/culler/potential_occluders.h"
#include "view_memory.h"

namespace occlude::culler {

/// The work that choosing may take, for each occluder that a frame may use: PlaneWork, to which each corner of a candidate
/// counts as a plane, and a candidate that the kernel refuses as an answer of the exact stage. Without a bound one wall that
/// hides all other candidates has every one of them asked. For each occluder that is half a millisecond or so, and more
/// than four times what the models tried take at most: 14,100, with 64 occluders a frame.
inline constexpr std::size_t kChoiceWorkOfEach = std::size_t{1} << 16U;

/// The model's side of the choice.
struct OccluderSource {
  const PolygonSoup& soup;
  const PotentialOccluders& occluders;
  const OccluderGrid& grid;
};

/// Whether the renderer may clip something of the vertices' convex hull at its near plane: then it must not occlude. `depth`
/// as append_view_frustum() takes it.
[[nodiscard]] bool may_be_clipped(const Camera& camera, double depth, std::span<const kernel::Vec3> vertices);

/// Fills memory.result.occluders and memory.pairs for a frame whose view is known, best first: those that hid something in
/// the frames before, then those that were not tried lately, and where these run out the rest; and memory.probes. Left out
/// are occluders that the kernel refuses from this viewpoint, those that reach before the renderer's near plane (what is
/// clipped away must not occlude), and those that lie in the shadow of a better one: their shadow is part of its shadow.
/// Once the work is spent no more are taken.
void choose_occluders(const OccluderSource& source, const Camera& camera, double depth, const CullOptions& options,
                      View::Memory& memory);

}  // namespace occlude::culler
