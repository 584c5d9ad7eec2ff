// SPDX-License-Identifier: MIT
// The border of a sheet in the coarse picture: which pixels it touches, and which it encloses.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "cover/conservative_viewport.h"
#include "cover/cover_tile.h"

namespace occlude::culler {

/// What a border has drawn into a tile.
struct BorderTile {
  std::uint64_t touched = 0;       ///< pixels
  std::uint64_t parity_flips = 0;  ///< pixels between whose middle and that of the pixel below an odd number of edges passes
  std::uint32_t border = 0;        ///< the number of the border that drew it; for another border the tile is empty
};

class CoverBorder {
 public:
  /// Starts an empty border in these tiles of a picture. REQUIRES: its width and height are multiples of kTile.
  void begin(const ConservativeViewport& picture, const PixelRectangle& tiles);

  /// Draws an edge. Pixels are touched that come as near to it as ConservativeViewport::edge_error(), if it may be in the
  /// tiles at all. REQUIRES: the errors are those of ConservativeViewport::place_error() or larger.
  void draw(const BoundedPosition& from, const BoundedPosition& to);
  /// The same in a picture of several eyes: pixels are touched that come as near to the swept edge as its error.
  void draw(const MovedPosition& from, const MovedPosition& to, const SweptEdge& swept);

  /// Finds the closed pixels of the tiles: those that the border does not touch, and whose middle it encloses an odd number
  /// of times. REQUIRES: the border is one or several closed curves.
  void find_closed(std::vector<std::uint64_t>& closed);

 private:
  [[nodiscard]] bool may_touch(const BoundedPosition& from, const BoundedPosition& to) const;
  void touch(const BoundedPosition& from, const BoundedPosition& to);
  void touch(const SweptEdge& edge, const PixelBounds& within);
  void turn(const BoundedPosition& from, const BoundedPosition& to);
  void turn(const PixelPosition& a, const PixelPosition& b);

  ConservativeViewport picture_;
  int tiles_across_ = 0;
  PixelRectangle tiles_{}, pixels_{};
  std::uint32_t border_ = 0;  ///< counts calls of begin()
  std::vector<BorderTile> drawn_;
  std::vector<std::uint8_t> enclosed_;  ///< for each tile across, a bit for each column: in the topmost row so far
};

}  // namespace occlude::culler
