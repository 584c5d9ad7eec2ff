// SPDX-License-Identifier: MIT
#include "held/around_box.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "held/held_region.h"
#include "occlude/kernel/validity.h"

namespace occlude::culler {
namespace {

/// A flat region has no room before it in which nothing is, so the layers of its picture would be spread over all
/// distances. It is taken thicker: by this share of its greatest width to each side, so that it grows by an eighth at most.
/// Other shares were not tried.
constexpr double kLeastShare = 1.0 / 16;

}  // namespace

Camera camera_of(const kernel::Aabb& eyes) {
  Camera camera;
  for (int i = 0; i < 3; ++i) {
    const double low = eyes.min[i], high = eyes.max[i], middle = kernel::flushed(low / 2 + high / 2);
    const double half = std::max(high - middle, middle - low);
    camera.eye[i] = middle;
    // The next larger number, because the differences are rounded.
    if (half > 0) {
      camera.eyes.half_edges[static_cast<std::size_t>(i)][i] =
          std::max(std::nextafter(half, std::numeric_limits<double>::infinity()), kernel::kMinMagnitude);
    }
  }
  return camera;
}

/// A region has no near plane; a point has one that lies farther behind the eye, by the margin for single precision, than
/// this nearest one of all is before it.
std::array<Camera, 6> cameras_around(const kernel::Aabb& eyes) {
  Camera camera = camera_of(eyes);
  double most = 0;
  for (std::size_t i = 0; i < 3; ++i) most = std::max(most, camera.eyes.half_edges[i][static_cast<int>(i)]);
  for (std::size_t i = 0; i < 3; ++i) {
    double& reach = camera.eyes.half_edges[i][static_cast<int>(i)];
    reach = std::max(reach, kernel::flushed(kLeastShare * most));
  }
  return all_around(camera, kernel::kMinMagnitude);
}

}  // namespace occlude::culler
