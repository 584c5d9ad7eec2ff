// SPDX-License-Identifier: MIT
// The choice of section 4.2: the cell's list, narrowed to the view frustum, sorted by what was hidden lately and by
// area-angle, the best n_occ.
#pragma once

#include <span>
#include <vector>

#include "occlude/culler/culler.h"
#include "occlude/culler/occluder_history.h"

namespace occlude::culler {

/// The occluders of a frame, best first: five in eight of them those that hid most in the frames before, then those that
/// were not tried lately, by area-angle, and where these run out those that hid little or nothing. Left out are regions that
/// the kernel refuses as occluders from this viewpoint, regions that reach before the renderer's near plane (what is clipped
/// away must not occlude), and regions that lie in the shadow of a better one: their shadow is part of its shadow.
[[nodiscard]] std::vector<Occluder> choose_occluders(const PolygonSoup& soup, const ConvexRegions& regions,
                                                     const OccluderGrid& grid, const OccluderHistory& history,
                                                     const Camera& camera, std::span<const HalfSpace> view,
                                                     const CullOptions& options, CullStats& stats);

}  // namespace occlude::culler
