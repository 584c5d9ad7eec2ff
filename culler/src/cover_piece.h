// SPDX-License-Identifier: MIT
// Meshes in the coarse picture: which pixels they close, and how near they are there.
//
// Triangles that look clockwise are turned over: so many of a set of them as a ray meets, that is its degree. It changes
// only where a ray crosses the border of the set: the edges along which its triangles go more often one way than the other,
// and where they are cut at the near plane. All rays of a pixel that the border does not touch have the degree of its
// middle; where that is not 0, all of them meet the set. Which triangles are in it, which way they are turned and whether
// they overlap can make a pixel stay open, and never close a wrong one: only the border is drawn.
//
// So a mesh is drawn sheet by sheet: what hangs together across edges that, as seen, have a triangle on either side. It has
// no fold and no border within, and is as near as it alone is.
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
  /// Makes room for meshes of so many triangles.
  void reserve(std::size_t triangles);
  /// What follows is drawn into this picture. REQUIRES: a width and a height of multiples of kTile.
  void begin(const BeamPicture& picture);
  /// Sees a mesh, and parts it into sheets. REQUIRES: begin(); the mesh stays as it is while its sheets are drawn.
  void see(const CoverMesh& mesh);
  [[nodiscard]] std::size_t sheets() const { return sheets_.size(); }

  /// Finds where a sheet is in the picture. False where it closes nothing.
  [[nodiscard]] bool find(std::size_t sheet);
  /// The tiles that hold all pixels which the sheet may close.
  [[nodiscard]] const PixelRectangle& tiles() const { return found_; }
  /// How near, at most, the sheet is.
  [[nodiscard]] float nearest() const { return nearest_; }

  /// Draws what was found, in these tiles. REQUIRES: tiles of the picture, one at least.
  void draw(const PixelRectangle& tiles);
  /// The pixels of a tile that the sheet closes.
  [[nodiscard]] std::uint64_t closed(int tile_x, int tile_y) const { return closed_[tile_at(tile_x, tile_y)]; }
  /// How near, at least, it is there.
  [[nodiscard]] float nearness(int tile_x, int tile_y) const { return nearness_[tile_at(tile_x, tile_y)]; }
  /// Tiles of its triangles that it took to draw.
  [[nodiscard]] std::size_t work() const { return work_; }
  /// Holds a triangle of the mesh, wherever it is by what it is out; none where it is in no sheet.
  [[nodiscard]] std::optional<PlaceRectangle> places(std::size_t triangle) const;

 private:
  /// A vertex in the picture; of what is before the near plane, nothing.
  struct Vertex {
    Corner corner;
    float nearness;  ///< no more than it is
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
  std::vector<double> slopes_x_, slopes_y_;  ///< of the rays between tiles
  double reach_ = 0;                         ///< of SeenPlane
  CoverMesh mesh_;
  std::vector<Seen> seen_;  ///< the vertices
  std::vector<Vertex> vertices_;
  std::vector<std::int8_t> signs_;  ///< of the triangles: 0 where it is seen edge-on, -1 where it is turned over
  CoverSheets sheets_;
  std::span<const std::uint32_t> sheet_;  ///< that was found: its triangles
  std::vector<std::uint32_t> taken_;      ///< of the triangles, the last piece that they were drawn for
  bool is_cut_ = false;
  PixelRectangle found_{};      ///< tiles
  PixelRectangle rectangle_{};  ///< pixels that are drawn
  float nearest_ = 0;
  std::size_t work_ = 0;

  int tiles_across_ = 0;
  std::uint32_t piece_ = 0;  ///< counts what was drawn of the mesh
  CoverBorder border_;
  std::vector<std::uint64_t> closed_;  ///< of the tiles
  std::vector<float> nearness_;
};

}  // namespace occlude::culler
