// SPDX-License-Identifier: MIT
// Triangles that hide together, and which of them share an edge.
#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

namespace occlude::culler {

/// A view of a mesh: whoever has made it keeps it.
struct CoverMesh {
  /// Corners, counted in the vertices: three different ones.
  using Triangle = std::array<std::uint32_t, 3>;

  /// An edge, and which of the uses are its own: those from first_use to before end_use.
  struct Edge {
    std::uint32_t from, to;  ///< from < to
    std::uint32_t first_use, end_use;
  };
  /// A triangle that has an edge, and whether it goes along it from .from to .to.
  struct Use {
    std::uint32_t triangle : 31;
    std::uint32_t ascends : 1;
  };

  std::span<const glm::dvec3> vertices;  ///< different points
  std::span<const Triangle> triangles;
  std::span<const Edge> edges;
  std::span<const Use> uses;
  /// Of each triangle whether it is part of a surface that is closed, or nearly so, and turned outwards: what is seen from
  /// behind has something before it. A hint: nothing that it says can make a pixel close that is open.
  std::span<const std::uint8_t> is_closed;
};

}  // namespace occlude::culler
