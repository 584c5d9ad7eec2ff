// SPDX-License-Identifier: MIT
// Tiles of the coarse picture and their pixels, several at once.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "cover/conservative_viewport.h"
#include "cover/projected_boxes.h"
#include "occlude/kernel/box_block.h"

namespace occlude::culler {

/// The sides of a tile in pixels. The nearness of pixels is stored tile by tile. A mask has a bit for each pixel of a tile:
/// bit 8 y + x.
inline constexpr int kTileBits = 3, kTile = 1 << kTileBits;
inline constexpr std::size_t kTilePixels = std::size_t{kTile} * kTile;

/// A bit for each whole number from `first` to before `end`, of those from 0 to 7.
inline std::uint64_t from_to(int first, int end) {
  const auto below = [](int n) { return (std::uint64_t{1} << std::clamp(n, 0, kTile)) - 1; };
  return below(end) & ~below(first);
}
/// The pixels of a tile in these columns, and in rows from `first` to before `end`. REQUIRES: 0 <= first < end <= kTile.
inline std::uint64_t pixels_of(std::uint64_t columns, int first, int end) {
  constexpr std::uint64_t kEachRow = 0x0101'0101'0101'0101, kAll = ~std::uint64_t{0};
  return kAll << kTile * first & kAll >> kTile * (kTile - end) & columns * kEachRow;
}

/// How near an open pixel is closed.
inline constexpr float kOpen = -std::numeric_limits<float>::infinity();

/// The nearness of pixels, stored by tiles.
struct TilePicture {
  const float* nearness;       ///< of each pixel, tile after tile
  const float* farthest;       ///< of each tile, the least nearness of its pixels; readable kTile tiles past the last
  int tiles_across, tiles_up;  ///< of one layer

  /// The layer that begins with this tile.
  [[nodiscard]] TilePicture from(int tile) const {
    return {nearness + std::size_t(tile) * kTilePixels, farthest + tile, tiles_across, tiles_up};
  }

  [[nodiscard]] int width() const { return kTile * tiles_across; }
  [[nodiscard]] int height() const { return kTile * tiles_up; }
};
/// How many pixels of the rectangle, which may be empty, have a nearness of at most `most`. Counts tile by tile, and stops
/// at `enough`.
[[nodiscard]] int open_pixels(const TilePicture& picture, const PixelRectangle& r, float most, int enough);
/// Those of the asked boxes that are in the picture, beyond the near plane, and behind all pixels that they touch.
[[nodiscard]] kernel::BoxBits hidden(const TilePicture& picture, const BoxPixels& boxes, kernel::BoxBits asked);
/// A lower bound of the nearness of a plane along the ray (x, y, 1): the product of constant + of_x x + of_y y and `scale`,
/// up to some roundings of `scale` and the product.
struct PlaneBound {
  double constant, of_x, of_y, scale;
};
/// How near something is in each tile of a picture, row by row. The rays of tile (i, j) are those from slopes_x[i] to
/// slopes_x[i + 1] and from slopes_y[j] to slopes_y[j + 1].
struct TileNearness {
  float* nearness;
  int tiles_across;
  const double *slopes_x, *slopes_y;
};
/// Lowers the nearness of these tiles to that of a plane, or to `least` where the plane is not nearer. Reads up to kTile
/// numbers of `nearness` and slopes_x past the tiles, and stores those of `nearness` unchanged.
void lower(const TileNearness& picture, const PixelRectangle& tiles, const PlaneBound& plane, float least);

/// Of tiles that lie side by side, from the first to after the last in which something may bring a pixel nearer. Empty if
/// there are none.
struct TileRange {
  int first, end;
};
/// Something of this nearness in all of the tiles, whose pixels have at least the nearness `farthest`. Here and below, up to
/// kTile numbers past the tiles are read.
[[nodiscard]] TileRange nearer(std::span<const float> farthest, float nearness);
/// Something of this nearness in each. It is not in a tile where it is infinite.
[[nodiscard]] TileRange nearer(std::span<const float> farthest, const float* nearness);

/// Raises pixels of tiles that lie side by side: those of the mask closed[i] of tile i to nearness[i], unless they are
/// nearer already, or it is infinite. farthest[i] is the least nearness of all pixels of the tile. Touches nothing past the
/// tiles.
void bring_nearer(float* pixels, std::span<float> farthest, const std::uint64_t* closed, const float* nearness);
/// The pixels of a tile that have a nearness of at most `most`.
[[nodiscard]] std::uint64_t pixels_up_to(const float* pixels, float most);

}  // namespace occlude::culler
