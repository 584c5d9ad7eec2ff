// SPDX-License-Identifier: MIT
// Which groups of polygons are looked at as shells.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "occlude/culler/polygon_soup.h"

namespace occlude::culler {

/// Every face turned to the eye is a plane of the shadow and costs time at every test. The check that a solid is convex
/// takes time in proportion to faces times vertices and to sides times vertices.
inline constexpr std::size_t kMostFaces = 64;
/// A prism with that many faces has almost six times as many sides. This is twice that.
inline constexpr std::size_t kMostSides = 768;
/// The faces of a tetrahedron.
inline constexpr std::size_t kLeastFaces = 4;

/// How many sides the polygons have together.
[[nodiscard]] inline std::size_t sides_of(SoupView soup, std::span<const std::uint32_t> polygons) {
  std::size_t sides = 0;
  for (const std::uint32_t p : polygons) sides += soup.loop(p).size();
  return sides;
}

}  // namespace occlude::culler
