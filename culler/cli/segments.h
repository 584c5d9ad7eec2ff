// SPDX-License-Identifier: MIT
// Whether something is between two points, quickly and up to rounding.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "occlude/culler/hierarchy.h"

namespace occlude::cli {

/// Heuristic: nothing is decided by it that could be wrong.
class Segments {
 public:
  /// REQUIRES: the tree outlives this object.
  explicit Segments(const culler::Hierarchy& tree) : tree_(tree) {}

  /// Whether an opaque polygon seems to be between an eye and a point of polygon `own`. `hider` is tried first, and becomes
  /// the one that was found.
  [[nodiscard]] bool is_blocked(const glm::dvec3& eye, const glm::dvec3& point, std::uint32_t own,
                                std::uint32_t& hider) const;

 private:
  [[nodiscard]] bool blocks(std::uint32_t p, const glm::dvec3& eye, const glm::dvec3& along) const;

  const culler::Hierarchy& tree_;
};

}  // namespace occlude::cli
