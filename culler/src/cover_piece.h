// SPDX-License-Identifier: MIT
// Draws meshes into the coarse picture: which pixels they close, and how near they are there.
//
// Triangles that look clockwise are turned over. The degree of a ray is the number of triangles of a set that it then meets.
// It changes only where a ray crosses the border of the set: the edges along which its triangles go more often one way than
// the other, and the cuts of triangles at the near plane. All rays of a pixel that the border does not touch have the degree
// of the ray in its middle. If that is not 0, all of them meet the set. Only the border is drawn. So it does not matter for
// correctness which triangles are in the set, which way they are turned and whether they overlap: a bad choice can leave a
// pixel open, but never close a wrong one.
//
// Meshes are therefore drawn sheet by sheet. The triangles of a sheet are connected across edges that, as seen, have a
// triangle on either side. A sheet has no fold and no inner border, and its depth is its own.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "beam_picture.h"
#include "cover_border.h"
#include "cover_mesh.h"
#include "cover_sheets.h"
#include "cover_tile.h"

namespace occlude::culler {

class CoverPiece {
 public:
  /// Reserves memory for meshes of this many triangles.
  void reserve(std::size_t triangles);
  /// The calls that follow draw into this picture. REQUIRES: its width and height are multiples of kTile.
  void begin(const BeamPicture& picture);
  /// Projects a mesh and divides it into sheets. REQUIRES: begin() was called; the mesh stays as it is while its sheets are
  /// drawn.
  void see(const CoverMesh& mesh);
  [[nodiscard]] std::size_t sheets() const { return sheets_.size(); }

  /// Finds where a sheet is in the picture. Returns false if it closes nothing.
  [[nodiscard]] bool find(std::size_t sheet);
  /// The tiles that hold all pixels which the sheet may close.
  [[nodiscard]] const PixelRectangle& tiles() const { return found_; }
  /// The sheet is nowhere nearer than this.
  [[nodiscard]] float nearest() const { return nearest_; }

  /// Draws the sheet that was found into these tiles. REQUIRES: at least one tile, all of them in the picture.
  void draw(const PixelRectangle& tiles);
  /// The pixels of a tile that the sheet closes.
  [[nodiscard]] std::uint64_t closed(int tile_x, int tile_y) const { return closed_[tile_at(tile_x, tile_y)]; }
  /// In this tile the sheet is nowhere less near than this.
  [[nodiscard]] float nearness(int tile_x, int tile_y) const { return nearness_[tile_at(tile_x, tile_y)]; }
  /// The work of the last draw(): the tiles of the triangles drawn.
  [[nodiscard]] std::size_t work() const { return work_; }
  /// A rectangle that holds a triangle of the mesh with its error; none if the triangle is in no sheet.
  [[nodiscard]] std::optional<PlaceRectangle> places(std::size_t triangle) const;

 private:
  /// A vertex in the picture. It is not set for a vertex before the near plane.
  struct Vertex {
    Corner corner;
    float nearness;  ///< a lower bound
  };
  /// What is drawn of a triangle: a convex loop.
  struct Outline;

  [[nodiscard]] std::size_t tile_at(int x, int y) const { return static_cast<std::size_t>(y * tiles_across_ + x); }
  [[nodiscard]] Vertex vertex(const Seen& seen) const;
  [[nodiscard]] bool is_before(std::uint32_t vertex) const { return seen_[vertex].forward < picture_.near(); }
  [[nodiscard]] Vertex cut(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] Outline outline(const CoverMesh::Triangle& triangle) const;
  void clear(const PixelRectangle& tiles);
  void take(std::uint32_t triangle);
  [[nodiscard]] int sign(const CoverMesh::Triangle& triangle) const;
  void lay_depth(const CoverMesh::Triangle& triangle, const Outline& outline);
  void lay(int tile_x, int tile_y, float nearness);
  void draw_sides(std::uint32_t triangle);
  [[nodiscard]] bool is_taken(std::uint32_t triangle) const { return taken_[triangle] == piece_; }
  [[nodiscard]] bool is_first(std::uint32_t side) const;
  void draw_edge(std::uint32_t from, std::uint32_t to, int degree);
  void draw_cut(const CoverMesh::Triangle& triangle, int degree);

  BeamPicture picture_;
  std::vector<double> slopes_x_, slopes_y_;  ///< of the rays along the borders of tiles
  double reach_ = 0;                         ///< as SeenPlane takes it
  CoverMesh mesh_;
  std::vector<Seen> seen_;  ///< the vertices
  std::vector<Vertex> vertices_;
  std::vector<std::int8_t> signs_;  ///< of each triangle: 1, 0 if it hides nothing, or -1 if it is turned over
  CoverSheets sheets_;
  std::span<const std::uint32_t> sheet_;  ///< the triangles of the sheet that was found
  std::vector<std::uint32_t> taken_;      ///< for each triangle, the last piece_ that it was drawn for
  bool is_cut_ = false;
  PixelRectangle found_{};      ///< tiles
  PixelRectangle rectangle_{};  ///< pixels that are drawn
  float nearest_ = 0;
  std::size_t work_ = 0;

  int tiles_across_ = 0;
  std::uint32_t piece_ = 0;  ///< counts the sheets drawn of the mesh
  CoverBorder border_;
  std::vector<std::uint64_t> closed_;  ///< of each tile
  std::vector<float> nearness_;
};

}  // namespace occlude::culler
