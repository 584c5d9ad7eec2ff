// SPDX-License-Identifier: MIT
// Draws meshes into the coarse picture: which pixels they close, and how near they are there.
//
// Whether a ray meets an odd number of triangles of a set changes only where it crosses the border of the set: the edges
// that an odd number of its triangles share, and the cuts of triangles at the near plane. All rays of a pixel that the
// border does not touch are in this as the ray in its middle. If that meets an odd number, all of them meet the set. Only
// the border is drawn. So it does not matter for correctness which triangles are in the set and whether they overlap: a bad
// choice can leave a pixel open, but never close a wrong one.
//
// Meshes are drawn sheet by sheet, because that leaves few pixels open. The triangles of a sheet are connected across edges
// that, as seen, have a triangle on either side. A sheet has no fold and no inner border, and its depth is its own.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "cover/conservative_viewport.h"
#include "cover/cover_border.h"
#include "cover/cover_mesh.h"
#include "cover/cover_outline.h"
#include "cover/cover_sheets.h"
#include "cover/cover_tile.h"
#include "cover/projected_plane.h"

namespace occlude::culler {

class SheetRasteriser {
 public:
  /// Reserves memory for meshes of this many triangles.
  void reserve(std::size_t triangles);
  /// The calls that follow draw into this picture. REQUIRES: its width and height are multiples of kTile.
  void begin(const ConservativeViewport& picture);
  /// Projects a mesh and divides it into sheets. REQUIRES: begin() was called; the mesh stays as it is while its sheets are
  /// drawn.
  void project(const CoverMesh& mesh);
  /// No point of the mesh is nearer.
  [[nodiscard]] float nearest_of_mesh() const { return nearness_from(nearest_of_mesh_); }
  /// About how near its farthest point is.
  [[nodiscard]] float farthest_of_mesh() const { return nearness_from(farthest_of_mesh_); }
  [[nodiscard]] std::size_t sheets() const { return sheets_.size(); }
  /// The calls that follow are about the picture with this focus. REQUIRES: the picture is of several eyes; project() was
  /// called since begin().
  void focus(double focus);

  /// Finds where a sheet is in the picture. Returns false if it closes nothing, or so little that it is not worth drawing.
  [[nodiscard]] bool find(std::size_t sheet);
  /// Its triangles.
  [[nodiscard]] std::span<const std::uint32_t> sheet() const { return sheet_; }
  /// The tiles that hold all pixels which the sheet may close.
  [[nodiscard]] const PixelRectangle& tiles() const { return found_; }
  /// The sheet is nowhere nearer than this.
  [[nodiscard]] float nearest() const { return nearest_; }

  /// Finds how near the sheet that was found is in these tiles. REQUIRES: at least one tile, all of them in the picture.
  void rasterise_depth(const PixelRectangle& tiles);
  /// For each tile of the picture, row by row: in those of the last rasterise_depth(), the sheet is nowhere less near than
  /// this; infinity if it is not there. Other tiles have what an earlier sheet left.
  [[nodiscard]] const float* nearness() const { return nearness_.data(); }
  /// The work of the last rasterise_depth(): the tiles of the triangles.
  [[nodiscard]] std::size_t work() const { return work_; }
  /// Draws the border of the sheet into these tiles. REQUIRES: at least one tile, all of them among those of
  /// rasterise_depth().
  void draw(const PixelRectangle& tiles);
  /// For each tile of the picture, row by row: in those of the last draw(), a bit for each pixel that the sheet closes.
  /// Other tiles have what an earlier sheet left.
  [[nodiscard]] const std::uint64_t* closed() const { return closed_.data(); }
  /// A rectangle that holds a triangle of the mesh with its error; none if the triangle is in no sheet.
  [[nodiscard]] std::optional<PixelBounds> places(std::size_t triangle) const;

 private:
  [[nodiscard]] std::size_t tile_at(int x, int y) const { return static_cast<std::size_t>(y * tiles_across_ + x); }
  [[nodiscard]] CoverVertex vertex(const EyePoint& seen) const;
  [[nodiscard]] float least_nearness(const EyePoint& seen) const;
  [[nodiscard]] float nearness_from(double forward) const;
  [[nodiscard]] bool is_before(std::uint32_t vertex) const { return seen_[vertex].forward < picture_.near(); }
  [[nodiscard]] CoverVertex cut(std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] CoverLoop loop(const CoverMesh::Triangle& triangle) const;
  [[nodiscard]] CoverOutline outline(const CoverMesh::Triangle& triangle) const {
    const auto [a, b, c] = triangle;
    return is_cut_ ? CoverOutline(loop(triangle)) : CoverOutline(vertices_[a], vertices_[b], vertices_[c]);
  }
  void move();
  [[nodiscard]] bool is_consumed() const;
  void clear(const PixelRectangle& tiles);
  [[nodiscard]] int sign(const CoverMesh::Triangle& triangle) const;
  void rasterise_depth(std::uint32_t triangle, const CoverOutline& outline);
  [[nodiscard]] ProjectedPlane plane(std::uint32_t triangle);
  void lower(const PixelRectangle& tiles, float nearness);
  void draw_sides(std::uint32_t triangle);
  [[nodiscard]] bool is_in_sheet(std::uint32_t triangle) const { return sheet_of_[triangle] == sheet_number_; }
  [[nodiscard]] bool is_border(std::uint32_t side) const;
  void draw_edge(std::uint32_t side, std::uint32_t from, std::uint32_t to);
  void draw_edge(const MovedPosition& from, const MovedPosition& to);
  void draw_cut(const CoverMesh::Triangle& triangle);

  ConservativeViewport picture_;
  std::vector<double> slopes_x_, slopes_y_;  ///< of the rays along the borders of tiles
  double reach_ = 0;                         ///< as ProjectedPlane takes it
  CoverMesh mesh_;
  std::vector<EyePoint> seen_;         ///< the vertices
  std::vector<CoverVertex> vertices_;  ///< not set for those before the near plane
  std::vector<std::int8_t> signs_;     ///< of each triangle: 1, 0 if it hides nothing, or -1 if it is turned over
  CoverSheets sheets_;
  std::span<const std::uint32_t> sheet_;  ///< the triangles of the sheet that was found
  std::vector<CoverOutline> outlines_;    ///< of these
  std::vector<std::uint32_t> sheet_of_;   ///< for each triangle, the last of sheet_number_ whose depth it was part of
  bool is_cut_ = false;
  double nearest_of_mesh_ = 0, farthest_of_mesh_ = 0, focus_ = 0;
  // What the eyes of a region do: to vertices, to sides and to triangles.
  std::vector<MovingPosition> moving_;
  std::vector<std::optional<MovingEdge>> edges_;
  std::vector<std::optional<ProjectedPlane>> planes_;
  PixelRectangle found_{};   ///< tiles
  PixelRectangle window_{};  ///< pixels
  float nearest_ = 0;
  std::size_t work_ = 0;

  int tiles_across_ = 0;
  std::uint32_t sheet_number_ = 0;  ///< counts those of the mesh whose depth was found
  CoverBorder border_;
  std::vector<std::uint64_t> closed_;  ///< of each tile
  std::vector<float> nearness_;
};

}  // namespace occlude::culler
