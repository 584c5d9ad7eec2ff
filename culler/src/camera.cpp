// SPDX-License-Identifier: MIT
#include "occlude/culler/camera.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace occlude::culler {
namespace {

/// How much wider the planes are than the renderer's: a relative margin far above what single precision does to a point on
/// the border of the picture (2^-22 of its distance) and far below half a pixel, which is as near as a sample comes to the
/// border (2^-12 of the picture's width at 2048 pixels). The near and far planes move by the same fraction.
constexpr double kMargin = 0x1p-20;

/// Coefficients below this fraction of the normal's length are dropped so that all stay within the kernel's legal range.
constexpr double kNegligible = 0x1p-60;

/// The half-space beyond `point` along `inward`, moved outward by more than rounding moved the coefficients: the offset
/// sums three products of |normal_k| |point_k|, each term with at most four roundings and a dropped coefficient.
HalfSpace half_space(const glm::dvec3& inward, const glm::dvec3& point) {
  glm::dvec3 normal = inward / glm::length(inward);
  for (int axis = 0; axis < 3; ++axis) {
    if (std::fabs(normal[axis]) < kNegligible) normal[axis] = 0;
  }
  const double reach = std::fabs(point.x) + std::fabs(point.y) + std::fabs(point.z);
  return {normal, -glm::dot(normal, point) + 0x1p-50 * reach};
}

}  // namespace

Camera::Axes Camera::axes() const {
  const glm::dvec3 forward = glm::normalize(target - eye);
  const glm::dvec3 right = glm::normalize(glm::cross(forward, up));
  return {right, glm::cross(right, forward), forward};
}

std::vector<HalfSpace> view_frustum(const Camera& camera) {
  const auto [right, up, forward] = camera.axes();
  std::vector<HalfSpace> planes;
  if (camera.projection == Projection::perspective) {
    const double y = std::tan(glm::radians(camera.fov_y_deg) / 2) * (1 + kMargin);
    const double x = y * camera.aspect;
    for (const glm::dvec3& inward : {x * forward + right, x * forward - right, y * forward + up, y * forward - up}) {
      planes.push_back(half_space(inward, camera.eye));
    }
  } else {
    const double y = camera.height / 2 * (1 + kMargin);
    const double x = y * camera.aspect;
    for (const glm::dvec3& outward : {-x * right, x * right, -y * up, y * up}) {
      planes.push_back(half_space(-outward, camera.eye + outward));
    }
  }
  planes.push_back(half_space(forward, camera.eye + camera.near * (1 - kMargin) * forward));
  if (std::isfinite(camera.far)) planes.push_back(half_space(-forward, camera.eye + camera.far * (1 + kMargin) * forward));
  return planes;
}

}  // namespace occlude::culler
