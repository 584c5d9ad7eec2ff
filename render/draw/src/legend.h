// SPDX-License-Identifier: MIT
// The legend of a plate.
#pragma once

#include <span>

#include "occlude/render/image.h"
#include "occlude/render/plate_renderer.h"

namespace occlude::render {

/// Draws the entries, each a swatch and a text, in the lower left corner on a light ground. Texts that are too wide end at
/// the edge of the picture. Throws std::runtime_error if the font cannot be used.
void draw_legend(Image& image, std::span<const LegendEntry> entries);

}  // namespace occlude::render
