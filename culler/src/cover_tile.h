// SPDX-License-Identifier: MIT
// The pixels of a square of the coarse picture, all at once.
#pragma once

#include <cstddef>
#include <cstdint>

#include "beam_picture.h"

namespace occlude::culler {

/// How near things are, at least, is kept for squares of so many pixels a side. A bit for each pixel of one: bit 8 y + x.
inline constexpr int kTile = 8;
inline constexpr std::size_t kTilePixels = std::size_t{kTile} * kTile;

/// How near things are, in tiles.
struct TilePicture {
  const float* nearness;  ///< of the pixels, tile after tile
  const float* farthest;  ///< of the tiles, the least of it
  int tiles_across;
};
/// How many pixels of the rectangle are no nearer than `most`; counted, a tile at a time, until there are enough.
[[nodiscard]] int open_pixels(const TilePicture& picture, const PixelRectangle& r, float most, int enough);
/// Brings those of the mask to `nearness` unless they are nearer, and returns the least of all.
float bring_nearer(float* pixels, std::uint64_t mask, float nearness);

}  // namespace occlude::culler
