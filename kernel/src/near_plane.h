// SPDX-License-Identifier: MIT
// The near plane of a shadow frustum.
#pragma once

#include <optional>
#include <span>

#include "occlude/kernel/shadow_frustum.h"
#include "planes.h"

namespace occlude::kernel {

/// The plane through the vertex of `loop` farthest from the viewpoint (the first of equally far ones), perpendicular to the
/// line of sight to this vertex.
[[nodiscard]] ExactPlane farthest_plane(const Viewpoint& viewpoint, std::span<const Vec3> loop);

/// The plane of the polygon, its inner side away from the viewpoint, or nothing unless all vertices lie exactly in one
/// plane. REQUIRES: `corners` as silhouette() returns them.
[[nodiscard]] std::optional<ExactPlane> polygon_plane(std::span<const Vec3> corners, std::span<const Vec3> loop);

/// A plane close to the loop's mean plane, with all of `loop` on or before it and the viewpoint strictly before it.
[[nodiscard]] SupportPlane support_plane(const Viewpoint& viewpoint, std::span<const Vec3> corners,
                                         std::span<const Vec3> loop);

[[nodiscard]] ExactPlane exact_plane(const SupportPlane& plane);

}  // namespace occlude::kernel
