// SPDX-License-Identifier: MIT
// Lines over a plate.
#pragma once

#include <span>

#include "occlude/render/image.h"
#include "occlude/render/plate_renderer.h"
#include "seen_surface.h"

namespace occlude::render {

/// Draws the lines with smooth edges; what is behind the surface is faint.
void draw_lines(Image& image, const SeenSurface& seen, double near, std::span<const Line> lines);

/// Mixes a share of a colour into a pixel.
void blend(Rgba& pixel, const Rgba& colour, double share);

}  // namespace occlude::render
