// SPDX-License-Identifier: MIT
#include "occlude/culler/camera.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "bounds.h"
#include "occlude/kernel/validity.h"
#include "single_precision.h"

namespace occlude::culler {
namespace {

/// Components of normals and of the line of sight below this fraction of their length are dropped, so that all stay within
/// the kernel's legal range: far below what rounding turns them by, which is 2^-53.
constexpr double kNegligible = 0x1p-60;

/// REQUIRES: a length of 1, up to rounding.
glm::dvec3 without_negligible(glm::dvec3 v) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::fabs(v[axis]) < kNegligible) v[axis] = 0;
  }
  return v;
}

/// The same half-space, or one little larger, in numbers that are legal for the kernel: coordinates up to 2^100 have offsets
/// up to 2^103, and what is left of an offset that cancels may be as small as any number.
HalfSpace legal(const glm::dvec3& normal, double offset) {
  if (std::fabs(offset) > kernel::kMaxMagnitude) return {normal * 0x1p-4, offset * 0x1p-4};
  if (offset != 0 && std::fabs(offset) < kernel::kMinMagnitude) return {normal, kernel::kMinMagnitude};
  return {normal, offset};
}

/// The half-space beyond `point` along `inward`, moved outward by the margin and by more than its offset is rounded by:
/// three products |normal_k| |point_k|, each with at most four roundings and a dropped coefficient. The few roundings of a
/// normal tilt the plane by far less at `depth` than the margin.
HalfSpace half_space(const glm::dvec3& inward, const glm::dvec3& point, double depth) {
  const glm::dvec3 normal = without_negligible(inward / glm::length(inward));
  const double size = std::fabs(point.x) + std::fabs(point.y) + std::fabs(point.z);
  return legal(normal, -glm::dot(normal, point) + 0x1p-48 * size + kDepthMargin * depth);
}

bool is_legal(const glm::dvec3& v) { return kernel::check(to_kernel(v)) == kernel::Refusal::none; }

bool is_legal_length(double x) { return x > 0 && kernel::check(x) == kernel::Refusal::none; }

/// Sine of the least angle between the line of sight and `up`: below it rounding decides which way the picture is turned.
constexpr double kLeastSine = 1e-9;

/// Far more than any picture has. The planes of one side tilt by what rounding does at the far end of the other.
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
  if (!has_line_of_sight(camera)) return "eye and target meet, or up lies along the line of sight";
  // A smaller opening would drown the planes' margin in rounding; the tangent of half a larger one grows without bound.
  if (!(camera.fov_y_deg >= 0.001 && camera.fov_y_deg <= 179)) return "the opening must be from 0.001 to 179 degrees";
  if (!is_legal_length(camera.near)) return "the near plane must be before the eye and in range";
  if (!(camera.far > camera.near) || (std::isfinite(camera.far) && !is_legal_length(camera.far)))
    return "the far plane must be beyond the near plane";
  if (!is_legal_length(camera.height)) return "the picture must have a height";
  if (!(camera.aspect >= 1 / kLargestAspect && camera.aspect <= kLargestAspect))
    return "the picture must not be more than 65536 times as wide as high, or as high as wide";
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
  const auto [right, up, forward] = camera.axes();
  const auto append = [&](const glm::dvec3& inward, const glm::dvec3& point) {
    planes.push_back(half_space(inward, point, depth));
  };
  const bool perspective = camera.projection == Projection::perspective;
  const double y = perspective ? std::tan(glm::radians(camera.fov_y_deg) / 2) : camera.height / 2;
  const double x = y * camera.aspect;
  for (const auto& [half, across] : {std::pair{x, right}, {x, -right}, {y, up}, {y, -up}}) {
    if (perspective) {
      append(half * forward + across, camera.eye);
    } else {
      append(across, camera.eye - half * across);
    }
  }
  append(forward, camera.eye + camera.near * forward);
  if (std::isfinite(camera.far)) append(-forward, camera.eye + camera.far * forward);
}

}  // namespace occlude::culler
