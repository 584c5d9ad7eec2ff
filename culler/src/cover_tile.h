// SPDX-License-Identifier: MIT
// The pixels of a square of the coarse picture, all at once.
#pragma once

#include <cstddef>
#include <cstdint>

namespace occlude::culler {

/// How near things are, at least, is kept for squares of so many pixels a side. A bit for each pixel of one: bit 8 y + x.
inline constexpr int kTile = 8;
inline constexpr std::size_t kTilePixels = std::size_t{kTile} * kTile;

/// The pixels from x0 to before x1 of the rows y0 to before y1. REQUIRES: 0 <= x0 < x1 <= kTile, and likewise y0 and y1.
[[nodiscard]] constexpr std::uint64_t tile_pixels(int x0, int y0, int x1, int y1) {
  const std::uint64_t row = 0xFFU >> (8 - x1) & 0xFFU << x0;
  return row * 0x0101010101010101U & ~std::uint64_t{0} >> (64 - 8 * y1) & ~std::uint64_t{0} << (8 * y0);
}

/// Which of the pixels are nearer than `most`.
[[nodiscard]] std::uint64_t nearer_pixels(const float* pixels, float most);
/// Brings those of the mask to `nearness` unless they are nearer, and returns the least of all.
float bring_nearer(float* pixels, std::uint64_t mask, float nearness);

}  // namespace occlude::culler
