// SPDX-License-Identifier: MIT
// A way of the eye, and the frames of a film along it.
#pragma once

#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "occlude/render/camera_path.h"
#include "place.h"

namespace occlude::render {

/// Where the eye is and where it looks, in coordinates of the place. Yaw and pitch are angles in radians: the line of sight
/// is (cos yaw cos pitch, sin yaw cos pitch, sin pitch).
struct Pose {
  glm::dvec3 eye{};
  double yaw = 0, pitch = 0;
  double stride = 1;  ///< how far the eye may move in a frame from here on
};

/// The pose at `eye` that looks to `target`; level, in direction `yaw`, where that is no other point.
[[nodiscard]] Pose pose(const glm::dvec3& eye, const glm::dvec3& target, double yaw, double stride);

/// Of the line through these points.
template <class Point>
[[nodiscard]] double length_of(const std::vector<Point>& points) {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += glm::distance(points[i - 1], points[i]);
  return sum;
}

/// Poses along the points, each looking at the way `ahead` of it, and the last ones straight on.
[[nodiscard]] std::vector<Pose> looking_ahead(const std::vector<glm::dvec3>& points, double ahead, double stride);

/// A path with about 300 frames along the poses, more where strides and turns of the head would become too large. It has
/// near planes as make_tour() says. None if that does not keep what make_tour() promises, or a triangle is nearer to the eye
/// than `clearance`. REQUIRES: at least two poses.
[[nodiscard]] std::optional<CameraPath> film(const Place& place, const std::vector<Pose>& poses, double clearance);

}  // namespace occlude::render
