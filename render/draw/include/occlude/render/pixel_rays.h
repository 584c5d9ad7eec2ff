// SPDX-License-Identifier: MIT
// The rays through the pixels of a picture.
#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "occlude/culler/camera.h"

namespace occlude::render {

/// Points of a picture are in pixels from its upper left corner. Depths are along the line of sight.
class PixelRays {
 public:
  PixelRays(const culler::Camera& camera, int width, int height)
      : axes_(camera.axes()),
        eye_(camera.eye),
        is_perspective_(camera.projection == culler::Projection::perspective),
        middle_(0.5 * width, 0.5 * height) {
    const double half = is_perspective_ ? std::tan(glm::radians(camera.fov_y_deg) / 2) : camera.height / 2;
    step_ = {half * camera.aspect / middle_.x, half / middle_.y};
  }

  /// The ray at depth z is at origin + z * direction.
  struct Ray {
    glm::dvec3 origin, direction;
    [[nodiscard]] glm::dvec3 at(double depth) const { return origin + depth * direction; }
  };
  [[nodiscard]] Ray ray(double x, double y) const {
    const glm::dvec3 aside = step_.x * (x - middle_.x) * axes_.right + step_.y * (middle_.y - y) * axes_.up;
    return is_perspective_ ? Ray{eye_, axes_.forward + aside} : Ray{eye_ + aside, axes_.forward};
  }
  /// The depth of a point.
  [[nodiscard]] double depth(const glm::dvec3& point) const { return glm::dot(point - eye_, axes_.forward); }
  /// Where a point at this depth is in the picture. REQUIRES: depth > 0 in perspective.
  [[nodiscard]] glm::dvec2 project(const glm::dvec3& point, double depth) const {
    const double scale = is_perspective_ ? 1 / depth : 1;
    return {middle_.x + scale * glm::dot(point - eye_, axes_.right) / step_.x,
            middle_.y - scale * glm::dot(point - eye_, axes_.up) / step_.y};
  }
  /// The height of a pixel at a depth, in model units.
  [[nodiscard]] double pixel_size(double depth) const { return is_perspective_ ? step_.y * depth : step_.y; }

  [[nodiscard]] bool is_perspective() const { return is_perspective_; }

 private:
  culler::Camera::Axes axes_;
  glm::dvec3 eye_;
  bool is_perspective_;
  glm::dvec2 middle_, step_;  ///< the size of a pixel at depth 1, or anywhere without perspective
};

}  // namespace occlude::render
