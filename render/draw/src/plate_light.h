// SPDX-License-Identifier: MIT
// The light on a plate: the sun with its shadows, and the sky, of which corners see less.
#pragma once

#include <glm/vec3.hpp>
#include <optional>

#include "occlude/culler/camera.h"
#include "occlude/culler/polygon_soup.h"
#include "seen_surface.h"

namespace occlude::render {

/// Direction to the sun, south-west and 45 degrees high.
inline constexpr glm::dvec3 kSun = {-0.57, -0.42, 0.71};

/// How much of the sky a pixel's surface sees, in [0, 1], as far as the picture shows what is near it: ambient occlusion in
/// screen space (McGuire et al., "The Alchemy Screen-Space Ambient Obscurance Algorithm", 2011). REQUIRES: there is a
/// polygon at the pixel.
[[nodiscard]] double seen_sky(const SeenSurface& seen, int x, int y);

/// A camera at the sun that sees what the picture sees, but for what is much farther than the rest; none if the picture
/// shows nothing. `aspect` is the width over the height of its own picture.
[[nodiscard]] std::optional<culler::Camera> sun_camera(const SeenSurface& seen, culler::SoupView soup, double aspect);

/// Whether the sun reaches a point, by what the sun sees beside it, in the direction of `angle`. Surfaces within a few
/// pixels of the sun's picture do not shade it.
[[nodiscard]] bool is_in_sun(const SeenSurface& from_sun, const glm::dvec3& point, double angle);

}  // namespace occlude::render
