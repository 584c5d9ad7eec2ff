// SPDX-License-Identifier: MIT
#include "camera/extent.h"

#include <glm/vec2.hpp>

#include "camera/frame_view.h"
#include "camera/matrix_eye.h"

namespace occlude::culler {
namespace {

/// Of the corners of a picture, to the right and up.
constexpr std::array<glm::dvec2, 4> kSides{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};

}  // namespace

void Extent::set(std::size_t i, const glm::dvec3& corner, double off) {
  corners[i] = corner;
  error = std::max(error, off);
  length = std::max(length, glm::length(corner));
}

Extent::Extent(const Camera& camera, const FrameView& view)
    : nearest(camera.near_plane), farthest(camera.far_plane), near_until(camera.near_plane) {
  const auto& [right, up, forward] = view.axes;
  const glm::dvec3 x = view.half_width * right, y = view.half_height * up;
  const glm::dvec3 middle = view.is_perspective ? forward : glm::dvec3(0);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 corner = middle + kSides[i].x * x + kSides[i].y * y;
    set(i, corner, kProductRounded * glm::length(corner));
  }
}

/// A plane n . v + d >= 0 is met on the line through a corner c at t = -d / (n . c). The extremes of t over the picture are
/// at corners where n . c has one sign.
Extent::Extent(const MatrixCamera& camera, const FrameView& view) {
  const MatrixEye eye(camera);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto corner = eye.vector(kSides[i].x * view.half_width, kSides[i].y * view.half_height, 1);
    set(i, corner.value, corner.error);
  }
  const auto planes = eye.planes(0);
  const ClipPlane &near = planes[MatrixEye::kNear], &far = planes[MatrixEye::kNear + 1];
  const double before = -(glm::dot(near.normal, eye.eye()) + near.offset);
  const double flattest = least(near.normal), steepest = -least(-near.normal);
  if (flattest > 0 && before > near.error) {
    nearest = (1 - kProductRounded) * (before - near.error) / steepest;
    near_until = (1 + kProductRounded) * (before + near.error) / flattest;
  }
  if (far.is_everywhere) return;
  const double beyond = glm::dot(far.normal, eye.eye()) + far.offset + far.error;
  const double least_to_far = least(-far.normal);
  if (least_to_far > 0 && beyond > 0) farthest = (1 + kProductRounded) * beyond / least_to_far;
}

}  // namespace occlude::culler
