// SPDX-License-Identifier: MIT
// Colours of polygons.
#pragma once

#include <array>
#include <cstdint>

namespace occlude::render {

/// Red, green and blue as screens take them (sRGB).
using Rgb = std::array<std::uint8_t, 3>;

inline constexpr Rgb kWhite = {255, 255, 255};

}  // namespace occlude::render
