// SPDX-License-Identifier: MIT
// What of the picture of a camera shows, in real numbers.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>

#include "occlude/culler/camera.h"

namespace occlude::culler {

struct FrameView;

/// Bounds the roundings of a product of two vectors, and of some that follow, as a share of their lengths.
inline constexpr double kProductRounded = 0x1p-49;

/// What shows is on the lines from the eye through t c, for c between the corners and t between the nearest and the
/// farthest; with parallel rays, at c + t forward.
struct Extent {
  std::array<glm::dvec3, 4> corners{};
  double error = 0;   ///< of each corner
  double length = 0;  ///< of the longest
  double nearest = 0, farthest = std::numeric_limits<double>::infinity();
  /// At least the farthest that the near plane is on a ray; infinite if there is one on which it is not.
  double near_until = std::numeric_limits<double>::infinity();

  /// REQUIRES: the view is of the camera.
  Extent(const Camera& camera, const FrameView& view);
  /// REQUIRES: the same; perspective.
  Extent(const MatrixCamera& camera, const FrameView& view);

  /// The least of n . c, or less.
  [[nodiscard]] double least(const glm::dvec3& n) const {
    double least = std::numeric_limits<double>::infinity();
    for (const glm::dvec3& c : corners) least = std::min(least, glm::dot(n, c));
    return least - glm::length(n) * (error + kProductRounded * length);
  }

 private:
  void set(std::size_t i, const glm::dvec3& corner, double off);
};

}  // namespace occlude::culler
