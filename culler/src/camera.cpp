// SPDX-License-Identifier: MIT
#include "occlude/culler/camera.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "bounds.h"
#include "occlude/kernel/validity.h"

namespace occlude::culler {
namespace {

/// How much wider the planes are than the renderer's: a relative margin far above what single precision does to a point on
/// the border of the picture (2^-22 of its distance) and far below half a pixel, which is as near as a sample comes to the
/// border (2^-12 of the picture's width at 2048 pixels). The near and far planes move by the same fraction.
constexpr double kMargin = 0x1p-20;

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

/// The half-space beyond `point` along `inward`, moved outward by more than rounding moves it: the offset sums three
/// products |normal_k| |point_k|, each with at most four roundings and a dropped coefficient, and a normal off by a few
/// roundings tilts the plane by as much at `reach` from the point.
HalfSpace half_space(const glm::dvec3& inward, const glm::dvec3& point, double reach) {
  const glm::dvec3 normal = without_negligible(inward / glm::length(inward));
  const double size = std::fabs(point.x) + std::fabs(point.y) + std::fabs(point.z) + reach;
  return legal(normal, -glm::dot(normal, point) + 0x1p-48 * size);
}

/// The tangent of half the opening, made wider by the margin and by more than rounding tilts the plane: a few roundings of a
/// normal 1 + tangent long, against points that are up to `reach` from a point one unit along the line of sight.
double opened(double tangent, double reach) { return tangent * (1 + kMargin) + 0x1p-48 * (1 + tangent) * reach; }

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
  if (camera.projection == Projection::perspective) {
    const double y = std::tan(glm::radians(camera.fov_y_deg) / 2), x = y * camera.aspect;
    const double wide_x = opened(x, 1 + x + y), wide_y = opened(y, 1 + x + y);
    for (const glm::dvec3& inward :
         {wide_x * forward + right, wide_x * forward - right, wide_y * forward + up, wide_y * forward - up}) {
      planes.push_back(half_space(inward, camera.eye, 0));  // what rounding tilts it is opened by
    }
  } else {
    const double y = camera.height / 2 * (1 + kMargin);
    const double x = y * camera.aspect;
    planes.push_back(half_space(right, camera.eye - x * right, depth));
    planes.push_back(half_space(-right, camera.eye + x * right, depth));
    planes.push_back(half_space(up, camera.eye - y * up, depth));
    planes.push_back(half_space(-up, camera.eye + y * up, depth));
  }
  planes.push_back(half_space(forward, camera.eye + camera.near * (1 - kMargin) * forward, depth));
  if (std::isfinite(camera.far)) {
    planes.push_back(half_space(-forward, camera.eye + camera.far * (1 + kMargin) * forward, depth));
  }
}

}  // namespace occlude::culler
