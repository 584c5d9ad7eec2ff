// SPDX-License-Identifier: MIT
// Triangles that hide together, and which of them share an edge.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

namespace occlude::culler {

/// With more sides along one edge, frames would be slow and hide hardly more.
inline constexpr std::size_t kMostInRing = 16;

/// A view of a mesh. Its maker keeps the memory.
struct CoverMesh {
  /// Corners as indices of vertices: three different ones.
  using Triangle = std::array<std::uint32_t, 3>;
  /// The sides from which triangles hide. A renderer that culls back faces draws a triangle only if it looks
  /// counter-clockwise, or only if it looks clockwise.
  enum class Front : std::int8_t { clockwise = -1, both = 0, counter_clockwise = 1 };

  std::span<const glm::dvec3> vertices;  ///< different points
  std::span<const Triangle> triangles;
  /// For each side of a triangle, the next side along the same edge, of any triangle. Side 3 t + i goes from corner i of
  /// triangle t to the next corner. The sides along an edge form rings of at most kMostInRing sides. A side that is alone is
  /// its own next.
  std::span<const std::uint32_t> next;
  /// So many of the triangles, the first ones, are new in the picture. The others were drawn before and touch them; a sheet
  /// that has no new triangle is left out.
  std::size_t new_triangles = 0;
  Front front = Front::both;

  [[nodiscard]] std::uint32_t next_of(std::uint32_t side) const { return next[side]; }
};

}  // namespace occlude::culler
