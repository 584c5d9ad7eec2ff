// SPDX-License-Identifier: MIT
// What the styles of a plate look like.
#pragma once

#include <glm/vec3.hpp>

#include "occlude/render/plate_renderer.h"

namespace occlude::render {

/// The colour of a surface in a style without light, in [0, 1], at a place in the picture in pixels from its upper left
/// corner, of a picture of this height. `own` is the surface's own colour.
[[nodiscard]] glm::dvec3 styled(Style style, const glm::dvec3& own, double x, double y, int height);

/// How much light and shade show in a style, in [0, 1].
[[nodiscard]] double relief(Style style);

}  // namespace occlude::render
