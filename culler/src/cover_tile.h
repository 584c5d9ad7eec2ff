// SPDX-License-Identifier: MIT
// The pixels of a tile of the coarse picture, all at once.
#pragma once

#include <cstddef>
#include <cstdint>

#include "beam_picture.h"

namespace occlude::culler {

/// The sides of a tile in pixels. The nearness of pixels is stored tile by tile. A mask has a bit for each pixel of a tile:
/// bit 8 y + x.
inline constexpr int kTile = 8;
inline constexpr std::size_t kTilePixels = std::size_t{kTile} * kTile;

/// The nearness of pixels, stored by tiles.
struct TilePicture {
  const float* nearness;  ///< of each pixel, tile after tile
  const float* farthest;  ///< of each tile, the least nearness of its pixels
  int tiles_across;
};
/// How many pixels of the rectangle have a nearness of at most `most`. Counts tile by tile, and stops at `enough`.
[[nodiscard]] int open_pixels(const TilePicture& picture, const PixelRectangle& r, float most, int enough);
/// Raises the pixels of the mask to `nearness` unless they are nearer already. Returns the least nearness of all pixels of
/// the tile.
float bring_nearer(float* pixels, std::uint64_t mask, float nearness);

}  // namespace occlude::culler
