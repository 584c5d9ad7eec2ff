// SPDX-License-Identifier: MIT
#include "occlude/culler/camera.h"

#include <cmath>
#include <glm/geometric.hpp>

#include "camera/eye_region.h"
#include "camera/frame_view.h"
#include "camera/legal_numbers.h"
#include "camera/negligible.h"
#include "model/bounds.h"

namespace occlude::culler {
namespace {

/// The least sine of the angle between the line of sight and `up`. Below it, rounding decides which way the picture is
/// turned.
constexpr double kLeastSine = 1e-9;

/// Far more than any picture has. Rounding tilts the planes of the view; the larger the ratio, the farther the tilt moves a
/// plane at the ends of its side.
constexpr double kLargestAspect = 65536;

bool has_line_of_sight(const Camera& camera) {
  const glm::dvec3 sight = camera.target - camera.eye;
  const double length = glm::length(sight) * glm::length(camera.up);
  return length > 0 && glm::length(glm::cross(sight, camera.up)) > kLeastSine * length;
}

}  // namespace

std::string fault(const Camera& camera) {
  if (!is_legal(camera.eye) || !is_legal(camera.target) || !is_legal(camera.up))
    return "a number is not finite or out of range";
  if (!is_legal_length(camera.near_plane)) return "the near plane must be before the eye and in range";
  if (!(camera.far_plane > camera.near_plane) || (std::isfinite(camera.far_plane) && !is_legal_length(camera.far_plane)))
    return "the far plane must be beyond the near plane";
  if (!is_legal_length(camera.height)) return "the picture must have a height";
  if (!has_line_of_sight(camera)) return "eye and target meet, or up lies along the line of sight";
  // With a smaller angle, rounding would exceed the margin of the planes. With a larger one, the tangent of its half grows
  // without bound.
  if (!(camera.fov_y_deg >= 0.001 && camera.fov_y_deg <= 179)) return "the opening must be from 0.001 to 179 degrees";
  if (!(camera.aspect >= 1 / kLargestAspect && camera.aspect <= kLargestAspect))
    return "the picture must not be more than 65536 times as wide as high, or as high as wide";
  if (const std::string_view of_eyes = fault(camera.eyes); !of_eyes.empty()) return std::string(of_eyes);
  return "";
}

Camera::Axes Camera::axes() const {
  const glm::dvec3 forward = without_negligible(glm::normalize(target - eye));
  const glm::dvec3 right = glm::normalize(glm::cross(forward, up));
  return {right, glm::cross(right, forward), forward};
}

kernel::Viewpoint Camera::viewpoint() const {
  return projection == Projection::perspective ? kernel::Viewpoint::eye(to_kernel(eye))
                                               : kernel::Viewpoint::direction(to_kernel(axes().forward));
}

void append_view_frustum(const Camera& camera, double depth, std::vector<HalfSpace>& planes) {
  FrameView(camera, depth).append_half_spaces(planes);
}

}  // namespace occlude::culler
