// SPDX-License-Identifier: MIT
// What can hide: the convex regions of the soup (section 4). A wall comes as two triangles, a roof as ten; merged they are
// one occluder that hides more than all its parts one by one. Only occluders are merged, never what is drawn. Reading
// order: 4.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "occlude/culler/polygon_soup.h"

namespace occlude::culler {

/// Region r is a polygon, or polygons joined edge to edge, flat and convex up to rounding: whoever takes its loop for an
/// occluder has the kernel decide exactly whether it is one. The parts fill the loop without a vertex inside it, so that
/// they hide from any viewpoint from which the loop is convex what any other polygons within the same loop do.
class ConvexRegions {
 public:
  /// Every polygon of the soup is part of exactly one region. REQUIRES: a soup that is not empty.
  [[nodiscard]] static ConvexRegions find(const PolygonSoup& soup);

  [[nodiscard]] std::size_t size() const { return first_vertex_.size() - 1; }
  /// The corners, as vertices of the soup, in order.
  [[nodiscard]] std::span<const std::uint32_t> loop(std::size_t r) const {
    return std::span(vertices_).subspan(first_vertex_[r], first_vertex_[r + 1] - first_vertex_[r]);
  }
  /// The polygons of the soup that it is drawn as, in ascending order.
  [[nodiscard]] std::span<const std::uint32_t> parts(std::size_t r) const {
    return std::span(polygons_).subspan(first_polygon_[r], first_polygon_[r + 1] - first_polygon_[r]);
  }

 private:
  std::vector<std::uint32_t> vertices_, first_vertex_ = {0};
  std::vector<std::uint32_t> polygons_, first_polygon_ = {0};
};

}  // namespace occlude::culler
