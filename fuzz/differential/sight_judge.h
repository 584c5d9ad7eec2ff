// SPDX-License-Identifier: MIT
// Refutes culls of regions of eyes by single lines of sight.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "occlude/culler/culler.h"
#include "occlude/fuzz/random.h"
#include "proof/camera_picture.h"

namespace occlude::fuzz {

/// Eyes of the region: for a box its corners, for a ball those farthest along the axes, and others on its border and inside.
/// By exact arithmetic, all are in the region.
[[nodiscard]] std::vector<oracle::Point> some_eyes(Random& random, const oracle::EyeRegion& region);

/// A corner of the box, or another point of it.
[[nodiscard]] oracle::Point some_point(Random& random, const kernel::Aabb& box);

/// What is wrong with what `result` culls by cover, which culler.cull(camera) returned: from some eye of the region, a
/// corner or another point of the box of a culled subtree has no opaque polygon before it, beyond the near plane. Empty when
/// no line of sight that was tried is clear. Their number is added to `lines`: at most kLinesOfCull for each subtree.
[[nodiscard]] std::string fault_of_sight(Random& random, const culler::Culler& culler, const proof::AnyCamera& camera,
                                         const culler::CullResult& result, std::uint64_t& lines);

}  // namespace occlude::fuzz
