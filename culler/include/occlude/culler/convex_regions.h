// SPDX-License-Identifier: MIT
// What can hide: the convex regions of the soup (section 4). A wall comes as two triangles, a roof as ten; joined they are
// one occluder, which hides what each of them does and what only some of them do together. Joined for hiding, never for
// drawing. A polygon that is not convex, or has very many sides, hides as convex pieces of the fan that it is drawn as.
// Reading order: 4.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "occlude/culler/checkpoint.h"
#include "occlude/culler/polygon_soup.h"

namespace occlude::culler {

struct SidePair;

/// Triangles [first, first + count) of the fan that a polygon is drawn as.
struct FanRun {
  std::uint32_t first = 0, count = 0;

  friend bool operator==(const FanRun&, const FanRun&) = default;
};

/// Region r below the number of polygons is polygon r; those after them are joined of several, edge to edge; the last are
/// pieces of polygons that are not convex or have more sides than kMostSides. A joined region is convex and nearly flat up
/// to rounding: whether its loop is an occluder for a viewpoint the kernel decides exactly.
///
/// Two things hold exactly of the parts of a region: every edge but those of the loop is run through as often one way as the
/// other, and all their corners are corners of the loop. So a loop that is convex from a viewpoint hides no more than its
/// parts do: seen from there, the triangles drawn of them cover all that the loop, their border, winds around; and what is
/// on one side of a plane with all corners of the loop is so with all of the triangles.
class ConvexRegions {
 public:
  /// Every side is a plane of the shadow, at which every test of a box may have to look: with so many a frame of some
  /// thousands of tests stays within milliseconds for each occluder. No region but a polygon of the soup has more.
  static constexpr std::uint32_t kMostSides = 256;

  /// REQUIRES: finite coordinates, and the adjacency of this soup.
  [[nodiscard]] static ConvexRegions find(const PolygonSoup& soup, std::span<const SidePair> adjacency,
                                          const Checkpoint& checkpoint = {});

  [[nodiscard]] std::size_t size() const { return first_vertex_.size() - 1; }
  /// The largest region that the polygon is part of: a joined one, or itself.
  [[nodiscard]] std::uint32_t whole(std::uint32_t polygon) const { return whole_[polygon]; }
  /// The corners, as vertices of the soup, in order.
  [[nodiscard]] std::span<const std::uint32_t> loop(std::size_t r) const {
    return std::span(vertices_).subspan(first_vertex_[r], first_vertex_[r + 1] - first_vertex_[r]);
  }
  /// The polygons of the soup that it is drawn as, in ascending order; of a piece the polygon that it is of.
  [[nodiscard]] std::span<const std::uint32_t> parts(std::size_t r) const {
    return std::span(polygons_).subspan(first_polygon_[r], first_polygon_[r + 1] - first_polygon_[r]);
  }

  /// Of a piece the run of its polygon's fan; none of other regions.
  [[nodiscard]] std::optional<FanRun> piece(std::size_t r) const {
    return r < first_piece_ ? std::nullopt : std::optional(runs_[r - first_piece_]);
  }

 private:
  void end_region();

  std::vector<std::uint32_t> vertices_, first_vertex_ = {0};
  std::vector<std::uint32_t> polygons_, first_polygon_ = {0};
  std::vector<std::uint32_t> whole_;
  std::uint32_t first_piece_ = 0;
  std::vector<FanRun> runs_;
};

/// The loop around the run of triangles of the fan of a loop.
[[nodiscard]] std::vector<std::uint32_t> piece_of(std::span<const std::uint32_t> loop, const FanRun& run);

}  // namespace occlude::culler
