// SPDX-License-Identifier: MIT
// What can hide: the convex regions of the soup (section 4). A wall comes as two triangles, a roof as ten. Joined, they are
// one occluder, which hides what each hides alone and what only several hide together. They are joined for hiding, never for
// drawing. A polygon that is not convex, or has very many sides, hides as convex pieces of the fan that it is drawn as.
// Reading order: 4.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "occlude/culler/executor.h"
#include "occlude/culler/parts.h"
#include "occlude/culler/polygon_soup.h"

namespace occlude::culler {

struct SidePair;   // model/adjacency.h
class PartReader;  // model/part_list.h
class PartWriter;

/// Triangles [first, first + count) of the fan that a polygon is drawn as.
struct FanRun {
  std::uint32_t first = 0, count = 0;

  friend bool operator==(const FanRun&, const FanRun&) = default;
};

/// The regions are numbered in three groups:
/// 1. Region r < soup.size() is polygon r, whatever its shape. It has no corners if the polygon is see-through, so that it
///    hides nothing.
/// 2. Then come the joined regions: several polygons, joined edge to edge. Each is convex and nearly flat up to rounding,
///    and has at most 32 sides.
/// 3. Then come the pieces of polygons that are not convex or have more than kMostSides sides.
/// Joined regions and pieces have no see-through part.
/// Whether the loop of a region is an occluder for a viewpoint, the kernel decides exactly.
///
/// Two properties of a region's parts (of a piece: of its run of triangles) hold exactly:
/// 1. Every edge that is not on the loop is traversed as often in one direction as in the other.
/// 2. Every corner of a part is a corner of the loop.
/// So a loop that is convex from a viewpoint hides no more than its parts. By (1), the triangles drawn of the parts cover,
/// as seen from there, everything that the loop winds around. By (2), a plane with the whole loop on one side has all
/// triangles on that side.
///
/// Const calls may run on several threads at once. Region and polygon numbers are not checked.
class ConvexRegions {
 public:
  /// The most sides of a joined region or a piece; a polygon of the soup may have more. Each side is a plane of the shadow,
  /// and each test of a box may ask every plane. With this limit, some thousands of tests take milliseconds per occluder.
  static constexpr std::uint32_t kMostSides = 256;
  /// The most sides of a joined region. Few walls have more.
  static constexpr std::uint32_t kMostJoined = 32;

  /// Called by PotentialOccluders::find(). REQUIRES: the soup is well formed, its coordinates are finite, and `adjacency` is
  /// what find_adjacency() (model/adjacency.h) finds in it. What `checkpoint` throws is thrown on.
  [[nodiscard]] static ConvexRegions find(SoupView soup, std::span<const SidePair> adjacency,
                                          const Checkpoint& checkpoint = {});
  /// For Culler::parts().
  void append_parts(PartWriter& parts) const;
  /// The regions with these parts. Throws std::invalid_argument unless they are numbered as above, with both properties.
  /// REQUIRES: the soup is well formed.
  [[nodiscard]] static ConvexRegions from_parts(const PartReader& parts, SoupView soup, const Checkpoint& checkpoint = {});

  [[nodiscard]] std::size_t size() const { return first_vertex_.size() - 1; }
  /// The joined region that the polygon is a part of; `polygon` itself if there is none.
  [[nodiscard]] std::uint32_t whole(std::uint32_t polygon) const { return whole_[polygon]; }
  /// The corners of region r in loop order, as indices of soup vertices.
  [[nodiscard]] std::span<const std::uint32_t> loop(std::size_t r) const {
    return {vertices_.data() + first_vertex_[r], vertices_.data() + first_vertex_[r + 1]};
  }
  /// The polygons that region r is drawn as, ascending. For a piece: the polygon that it is a piece of.
  [[nodiscard]] std::span<const std::uint32_t> parts(std::size_t r) const {
    return {polygons_.data() + first_polygon_[r], polygons_.data() + first_polygon_[r + 1]};
  }

  /// For a piece: its run of triangles in the fan of its polygon. For other regions: none.
  [[nodiscard]] std::optional<FanRun> piece(std::size_t r) const {
    return r < first_piece_ ? std::nullopt : std::optional(runs_[r - first_piece_]);
  }

 private:
  /// Whether region r, with its corners and parts in their arrays, is what it must be by its number.
  [[nodiscard]] bool is_sound(std::size_t r, SoupView soup) const;
  /// The same for whole(polygon).
  [[nodiscard]] bool is_whole_sound(std::uint32_t polygon, std::size_t polygons) const;

  Array<std::uint32_t> vertices_, first_vertex_;   ///< region r has the corners [first_vertex_[r], first_vertex_[r + 1])
  Array<std::uint32_t> polygons_, first_polygon_;  ///< the same of its parts
  Array<std::uint32_t> whole_;
  std::size_t first_piece_ = 0;
  Array<FanRun> runs_;
};

/// The corners of region p: those of polygon p, or none if it is see-through.
[[nodiscard]] inline std::span<const std::uint32_t> corners_of_region(SoupView soup, std::size_t p) {
  return soup.is_opaque(p) ? soup.loop(p) : std::span<const std::uint32_t>{};
}

/// The border of a run of triangles in the fan of `loop`: v0, then the corners of the run in order.
/// REQUIRES: run.first + run.count <= loop.size() - 2.
[[nodiscard]] std::vector<std::uint32_t> piece_of(std::span<const std::uint32_t> loop, const FanRun& run);

}  // namespace occlude::culler
