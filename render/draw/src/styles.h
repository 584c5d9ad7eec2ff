// SPDX-License-Identifier: MIT
// What the styles of a plate look like.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec3.hpp>

#include "occlude/render/image.h"
#include "occlude/render/plate_renderer.h"

namespace occlude::render {

/// The colour of a surface in a style without light, in [0, 1], at a place in the picture in pixels from its upper left
/// corner, of a picture of this height. `own` is the surface's own colour.
[[nodiscard]] glm::dvec3 styled(Style style, const glm::dvec3& own, double x, double y, int height);

/// How much light and shade show in a style, in [0, 1].
[[nodiscard]] double relief(Style style);

/// A colour as a pixel. Channels outside [0, 1] become the nearest in it, NaN 0.
[[nodiscard]] inline Rgba to_rgba(const glm::dvec3& colour) {
  const auto channel = [](double value) {
    return value > 0 ? static_cast<std::uint8_t>(std::lround(255 * std::min(value, 1.0))) : std::uint8_t{0};
  };
  return {channel(colour.r), channel(colour.g), channel(colour.b), 255};
}

}  // namespace occlude::render
