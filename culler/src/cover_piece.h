// SPDX-License-Identifier: MIT
// A set of triangles in the coarse picture: which pixels it closes, and how near it is there.
//
// A ray meets an odd number of the triangles, or an even one, and which changes only where a ray crosses the border: the
// edges that an odd number of the triangles have, and where they are cut at the near plane. All rays of a pixel that the
// border does not touch have the parity of its middle; if that is odd, all of them meet the piece. Where a triangle faces,
// whether triangles overlap, and what is inside of the border does not matter: only the border is drawn.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "beam_picture.h"

namespace occlude::culler {

class CoverPiece {
 public:
  /// Corners of a triangle, counted in the vertices. Edges are one where they have the same two corners.
  using Triangle = std::array<std::uint32_t, 3>;

  /// How near things are, at least, is kept for squares of so many pixels.
  static constexpr int kTile = 8;

  /// Draws the piece. False where it closes nothing. REQUIRES: a width of a multiple of 64 and a height of one of kTile.
  [[nodiscard]] bool draw(const BeamPicture& picture, std::span<const glm::dvec3> vertices,
                          std::span<const Triangle> triangles);

  /// Holds all pixels that the piece that was drawn last closes.
  [[nodiscard]] const PixelRectangle& rectangle() const { return rectangle_; }
  /// Of the pixels of a row from 64 `word` on, which it closes: the first is the lowest bit.
  [[nodiscard]] std::uint64_t closed(int row, int word) const {
    const auto at = static_cast<std::size_t>(row * words_ + word);
    return parity_[at] & ~border_[at];
  }
  /// How near, at least, the piece is in a tile.
  [[nodiscard]] float nearness(int tile_x, int tile_y) const {
    return tiles_[static_cast<std::size_t>(tile_y * tiles_across_ + tile_x)];
  }

 private:
  struct Edge {
    std::uint32_t from, to;  ///< from < to
  };
  /// What is left of a triangle beyond the near plane.
  struct Part {
    std::array<Seen, 4> corners;
    std::size_t count = 0;
  };

  void see(std::span<const glm::dvec3> vertices, std::span<const Triangle> triangles);
  void find_border();
  [[nodiscard]] bool find_place();
  void clear();
  [[nodiscard]] bool is_before(std::uint32_t vertex) const { return seen_[vertex].forward < picture_.near(); }
  [[nodiscard]] Seen cut(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] Part part(const Triangle& triangle) const;
  void draw_edge(const Edge& edge);
  void draw_cut(const Triangle& triangle);
  void draw_border(const Place& a, const Place& b);
  void lay_depth(const Triangle& triangle);

  BeamPicture picture_;
  int words_ = 0, tiles_across_ = 0;
  std::vector<std::uint64_t> parity_, border_;
  std::vector<float> tiles_;

  std::vector<Seen> seen_;           ///< the corners, each once
  std::vector<Triangle> triangles_;  ///< by these
  std::vector<Edge> edges_;          ///< of the border
  std::vector<std::uint32_t> own_, stamp_;
  std::uint32_t stamp_now_ = 0;
  bool is_cut_ = false;
  double widening_ = 0;  ///< no place of the piece is out by more, in pixels
  PixelRectangle rectangle_{};
};

}  // namespace occlude::culler
