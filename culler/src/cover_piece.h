// SPDX-License-Identifier: MIT
// A mesh in the coarse picture: which pixels it closes, and how near it is there.
//
// Triangles that look clockwise are turned over: so many of the mesh as a ray meets, that is its degree. It changes only
// where a ray crosses the border: the edges along which the triangles go more often one way than the other, and where they
// are cut at the near plane. All rays of a pixel that the border does not touch have the degree of its middle; where that is
// not 0, all of them meet the mesh. Which triangles are taken, which way they are turned and whether they overlap can make a
// pixel stay open, and never close a wrong one: only the border is drawn.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "beam_picture.h"
#include "cover_mesh.h"
#include "cover_tile.h"

namespace occlude::culler {

class CoverPiece {
 public:
  /// What follows is drawn into this picture. REQUIRES: a width and a height of multiples of kTile.
  void begin(const BeamPicture& picture);
  /// Finds where the mesh is in the picture. False where it closes nothing. REQUIRES: begin(); the mesh stays as it is.
  [[nodiscard]] bool find(const CoverMesh& mesh);
  /// The tiles that hold all pixels which the mesh may close.
  [[nodiscard]] const PixelRectangle& tiles() const { return found_; }
  /// How near, at most, the mesh is.
  [[nodiscard]] float nearest() const { return nearest_; }

  /// Draws what was found, in these tiles. REQUIRES: tiles of the picture, one at least.
  void draw(const PixelRectangle& tiles);
  /// The pixels of a tile that the mesh closes.
  [[nodiscard]] std::uint64_t closed(int tile_x, int tile_y) const { return closed_[tile_at(tile_x, tile_y)]; }
  /// How near, at least, the mesh is there.
  [[nodiscard]] float nearness(int tile_x, int tile_y) const { return nearness_[tile_at(tile_x, tile_y)]; }
  /// Tiles that it took to draw, and tiles of each triangle.
  [[nodiscard]] std::size_t work() const { return work_; }
  /// Holds a triangle, wherever it is by what it is out; none where it was not drawn.
  [[nodiscard]] std::optional<PlaceRectangle> places(std::size_t triangle) const;

 private:
  /// A vertex in the picture; of what is before the near plane, nothing.
  struct Vertex {
    Corner corner;
    float nearness;  ///< no more than it is
  };
  /// What is drawn of a triangle: a convex loop.
  struct Outline;

  /// What is drawn of the border into a tile.
  struct Tile {
    std::uint64_t border = 0;  ///< pixels that it touches
    /// By how much the degree changes from the pixel below to a pixel, modulo 256: a byte of the row for each column.
    std::array<std::uint64_t, kTile> turns{};
    std::uint32_t piece = 0;  ///< nothing is, unless this is the piece's number
  };

  [[nodiscard]] std::size_t tile_at(int x, int y) const { return static_cast<std::size_t>(y * tiles_across_ + x); }
  [[nodiscard]] Tile& touch(int tile_x, int tile_y);
  void see();
  [[nodiscard]] Vertex vertex(const Seen& seen) const;
  [[nodiscard]] bool is_before(std::uint32_t vertex) const { return seen_[vertex].forward < picture_.near(); }
  [[nodiscard]] Vertex cut(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] Outline outline(const CoverMesh::Triangle& triangle) const;
  void clear();
  void take(std::size_t triangle);
  [[nodiscard]] int sign(const CoverMesh::Triangle& triangle) const;
  void lay_depth(const CoverMesh::Triangle& triangle, const Outline& outline);
  void lay(int tile_x, int tile_y, float nearness);
  void draw_sides(std::size_t triangle);
  [[nodiscard]] int degree(std::uint32_t side) const;
  void draw_edge(std::uint32_t from, std::uint32_t to, int degree);
  void draw_cut(const CoverMesh::Triangle& triangle, int degree);
  void draw_border(const Corner& from, const Corner& to, int degree);
  void mark_border(const Corner& from, const Corner& to);
  void mark_row(int row, int x0, int x1);
  void turn_degree(const Place& a, const Place& b, int degree);
  void close();

  BeamPicture picture_;
  std::vector<double> slopes_x_, slopes_y_;  ///< of the rays between tiles
  double reach_ = 0;                         ///< of SeenPlane
  CoverMesh mesh_;
  std::vector<Seen> seen_;  ///< the vertices
  std::vector<Vertex> vertices_;
  std::vector<std::int8_t> signs_;  ///< of the triangles: 0 where it is not taken, -1 where it is turned over
  bool is_cut_ = false;
  PixelRectangle found_{};      ///< tiles
  PixelRectangle rectangle_{};  ///< pixels that are drawn
  float nearest_ = 0;
  std::size_t work_ = 0;

  int tiles_across_ = 0;
  std::uint32_t piece_ = 0;
  std::vector<Tile> tiles_;
  std::vector<std::uint64_t> degrees_;  ///< of the topmost row so far, as Tile::turns, of each tile
  std::vector<std::uint64_t> closed_;   ///< of the tiles
  std::vector<float> nearness_;
};

}  // namespace occlude::culler
