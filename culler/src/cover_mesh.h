// SPDX-License-Identifier: MIT
// Triangles that hide together, and which of them share an edge.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

namespace occlude::culler {

/// More sides along one edge would make frames slow, and hide hardly more.
inline constexpr std::size_t kMostInRing = 16;

/// A view of a mesh: whoever has made it keeps it.
struct CoverMesh {
  /// Corners, counted in the vertices: three different ones.
  using Triangle = std::array<std::uint32_t, 3>;
  /// Side 3 t + i goes from corner i of triangle t to the next. Of each side of a triangle, the next along the same edge, of
  /// whatever triangle: they make rings of at most kMostInRing, and one that is alone is its own next.
  using Next = std::array<std::uint32_t, 3>;

  std::span<const glm::dvec3> vertices;  ///< different points
  std::span<const Triangle> triangles;
  std::span<const Next> next;  ///< of the triangles

  [[nodiscard]] std::uint32_t next_of(std::uint32_t side) const { return next[side / 3][side % 3]; }
};

}  // namespace occlude::culler
