// SPDX-License-Identifier: MIT
// A mesh in the coarse picture: which pixels it closes, and how near it is there.
//
// Of the triangles that are taken, those that look clockwise are turned over: so many of them as a ray meets, that is its
// degree. It changes only where a ray crosses the border: the edges along which the triangles taken go more often one way
// than the other, and where they are cut at the near plane. All rays of a pixel that the border does not touch have the
// degree of its middle; where that is not 0, all of them meet the mesh. Which triangles are taken, which way they are
// turned and whether they overlap can make a pixel stay open, and never close a wrong one: only the border is drawn.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "beam_picture.h"
#include "cover_mesh.h"

namespace occlude::culler {

class CoverPiece {
 public:
  /// How near things are, at least, is kept for squares of so many pixels.
  static constexpr int kTile = 8;

  /// What follows is drawn into this picture. REQUIRES: a width and a height of multiples of kTile.
  void begin(const BeamPicture& picture);
  /// Finds where the mesh is in the picture. False where it closes nothing. REQUIRES: begin().
  [[nodiscard]] bool find(const CoverMesh& mesh);
  /// The tiles that hold all pixels which the mesh may close.
  [[nodiscard]] const PixelRectangle& tiles() const { return found_; }
  /// How near, at most, the mesh is.
  [[nodiscard]] float nearest() const { return nearest_; }

  /// Draws what was found, in these tiles. False where it closes nothing.
  [[nodiscard]] bool draw(const PixelRectangle& tiles);
  /// Of each pixel of a row whether the mesh closes it.
  [[nodiscard]] const std::uint8_t* closed(int row) const { return border_.data() + at(0, row); }
  /// How near, at least, the mesh is in a tile.
  [[nodiscard]] float nearness(int tile_x, int tile_y) const {
    return tiles_[static_cast<std::size_t>(tile_y * tiles_across_ + tile_x)];
  }
  /// Tiles that it took to draw, and tiles of each triangle.
  [[nodiscard]] std::size_t work() const { return work_; }
  /// Whether the triangle was taken.
  [[nodiscard]] bool is_taken(std::size_t triangle) const { return signs_[triangle] != 0; }
  /// Holds a triangle, wherever it is by what it is out; none where all of it is before the near plane.
  [[nodiscard]] std::optional<PlaceRectangle> places(const CoverMesh::Triangle& triangle) const;

 private:
  /// A point of the picture, and by how much it is out.
  struct Corner {
    Place place;
    double error;
  };
  /// What is left of a triangle beyond the near plane.
  struct Part {
    std::array<Seen, 4> corners;
    std::size_t count = 0;
  };
  struct Extent;
  struct Outline;

  [[nodiscard]] std::size_t at(int x, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(picture_.width()) + static_cast<std::size_t>(x);
  }
  [[nodiscard]] double slope_x(int tile) const { return slopes_x_[static_cast<std::size_t>(tile)]; }
  [[nodiscard]] double slope_y(int tile) const { return slopes_y_[static_cast<std::size_t>(tile)]; }
  void see();
  [[nodiscard]] bool take();
  [[nodiscard]] int sign(const CoverMesh::Triangle& triangle, bool is_closed) const;
  void clear();
  [[nodiscard]] bool is_before(std::uint32_t vertex) const { return seen_[vertex].forward < picture_.near(); }
  [[nodiscard]] Corner corner(const Seen& seen) const;
  [[nodiscard]] Seen cut(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] Part part(const CoverMesh::Triangle& triangle) const;
  [[nodiscard]] Outline outline(const CoverMesh::Triangle& triangle) const;
  [[nodiscard]] int degree(const CoverMesh::Edge& edge) const;
  void draw_edge(const CoverMesh::Edge& edge, int degree);
  void draw_cut(const CoverMesh::Triangle& triangle, int degree);
  void draw_border(const Corner& from, const Corner& to, int degree);
  void mark_border(const Corner& a, const Corner& b);
  void turn_degree(const Place& a, const Place& b, int degree);
  void lay_depth(const CoverMesh::Triangle& triangle);
  void lay(int tile_x, int tile_y, float nearness);
  void close();

  BeamPicture picture_;
  std::vector<double> slopes_x_, slopes_y_;  ///< of the rays between tiles
  CoverMesh mesh_;
  std::vector<Seen> seen_;          ///< the vertices
  std::vector<Corner> corners_;     ///< in the picture; of what is before the near plane, nothing
  std::vector<std::int8_t> signs_;  ///< of the triangles: 0 where it is not taken, -1 where it is turned over
  bool is_cut_ = false;
  PixelRectangle found_{};      ///< tiles
  PixelRectangle rectangle_{};  ///< pixels that are drawn
  float nearest_ = 0;
  std::size_t work_ = 0;

  int tiles_across_ = 0;
  std::vector<std::uint8_t> turns_;    ///< by how much the degree changes from the pixel below to a pixel, modulo 256
  std::vector<std::uint8_t> border_;   ///< of each pixel whether the border touches it; in the end, whether it is closed
  std::vector<std::uint8_t> degrees_;  ///< of a row
  std::vector<float> tiles_;
};

}  // namespace occlude::culler
