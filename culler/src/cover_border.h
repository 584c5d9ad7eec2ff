// SPDX-License-Identifier: MIT
// The border of a sheet in the coarse picture: the pixels that it touches, and those that it goes around.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "beam_picture.h"
#include "cover_tile.h"

namespace occlude::culler {

/// What is drawn of a border into a tile.
struct BorderTile {
  std::uint64_t touched = 0;  ///< pixels
  /// By how much the degree changes from the pixel below to a pixel, modulo 256: rows of a byte for each column.
  std::array<std::array<std::uint8_t, kTile>, kTile> turns{};
  std::uint32_t border = 0;  ///< nothing is, unless this is the border's number
};

class CoverBorder {
 public:
  /// Nothing is drawn so far, in these tiles of a picture. REQUIRES: a width and a height of multiples of kTile.
  void begin(const BeamPicture& picture, const PixelRectangle& tiles);

  /// An edge of degree d: pixels that come as near it as its ends are out are touched; above it, where it goes to the right,
  /// the degree is d higher than below, and where it goes to the left, lower.
  void draw(const Corner& from, const Corner& to, int degree);

  /// Of a closed border: the pixels of the tiles that it does not touch, and whose degree is not 0.
  void find_closed(std::vector<std::uint64_t>& closed);

 private:
  void touch(const Corner& from, const Corner& to);
  void turn(const Place& a, const Place& b, int degree);

  int width_ = 0, height_ = 0, tiles_across_ = 0;
  PixelRectangle tiles_{}, pixels_{};
  std::uint32_t border_ = 0;  ///< counts what was begun
  std::vector<BorderTile> drawn_;
  std::vector<std::uint8_t> degrees_;  ///< of the topmost row so far
};

}  // namespace occlude::culler
