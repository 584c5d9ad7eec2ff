// SPDX-License-Identifier: MIT
// Colours as files have them: numbers from 0 to 1, in sRGB or of light, which adds up.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "occlude/render/rgb.h"

namespace occlude::render {

/// Of numbers in sRGB. What is below 0 or no number is 0, and what is above 1 is 1.
[[nodiscard]] Rgb rgb_of(const glm::dvec3& colour);
/// Of light, likewise.
[[nodiscard]] Rgb rgb_of_light(const glm::dvec3& light);

/// The mean of the colours of the corners. REQUIRES: at least one, and a colour for each.
[[nodiscard]] Rgb mean_colour(std::span<const std::uint32_t> loop, const std::vector<Rgb>& colours);

/// The mean light of a picture, in which a pixel counts as much as it is opaque. Nothing if that is no PNG that can be read,
/// has no opaque pixel, or more than 2^26 pixels.
[[nodiscard]] std::optional<glm::dvec3> mean_light_of_png(std::string_view bytes);

}  // namespace occlude::render
