// SPDX-License-Identifier: MIT
// The border of a sheet in the coarse picture: which pixels it touches, and which it encloses.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "beam_picture.h"
#include "cover_tile.h"

namespace occlude::culler {

/// What a border has drawn into a tile.
struct BorderTile {
  std::uint64_t touched = 0;  ///< pixels
  /// The change of the degree from the pixel below to each pixel, modulo 256: rows with a byte for each column.
  std::array<std::array<std::uint8_t, kTile>, kTile> turns{};
  std::uint32_t border = 0;  ///< the number of the border that drew it; for another border the tile is empty
};

class CoverBorder {
 public:
  /// Starts an empty border in these tiles of a picture. REQUIRES: its width and height are multiples of kTile.
  void begin(const BeamPicture& picture, const PixelRectangle& tiles);

  /// Draws an edge of degree d. Pixels are touched that come as near to it as the errors of its ends, if it may be in the
  /// tiles at all. Above an edge that goes to the right the degree is d higher than below it; above one that goes to the
  /// left, d lower.
  void draw(const Corner& from, const Corner& to, int degree);

  /// Finds the closed pixels of the tiles: those that the border does not touch and whose degree is not 0. REQUIRES: the
  /// border is a closed curve.
  void find_closed(std::vector<std::uint64_t>& closed);

 private:
  [[nodiscard]] bool may_touch(const Corner& from, const Corner& to) const;
  void touch(const Corner& from, const Corner& to);
  void turn(const Place& a, const Place& b, int degree);

  int width_ = 0, height_ = 0, tiles_across_ = 0;
  PixelRectangle tiles_{}, pixels_{};
  std::uint32_t border_ = 0;  ///< counts calls of begin()
  std::vector<BorderTile> drawn_;
  std::vector<std::uint8_t> degrees_;  ///< in the topmost row of pixels so far
};

}  // namespace occlude::culler
