// SPDX-License-Identifier: MIT
#include "camera_picture.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <utility>
#include <vector>

#include "occlude/oracle/questions.h"

namespace occlude::proof {
namespace {

using glm::dvec3;
using oracle::HalfSpaceCoefficients;
using oracle::Relation;

/// Each term of an offset goes through fewer than eight roundings, of 2^-53 each.
constexpr double kRounded = 0x1p-50;

double sum_of_magnitudes(const dvec3& v) { return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z); }

/// {x : normal . (x - eye) + ahead >= 0}, moved by the distance `outward` and, in the same direction, by more than its
/// offset may be wrong by rounding.
HalfSpaceCoefficients half_space(const dvec3& normal, const dvec3& eye, double ahead, double outward) {
  const double moved = outward * glm::length(normal);
  const double size = sum_of_magnitudes(normal) * sum_of_magnitudes(eye) + std::fabs(ahead) + std::fabs(moved);
  return {normal.x, normal.y, normal.z, ahead - glm::dot(normal, eye) + moved + std::copysign(kRounded, outward) * size};
}

}  // namespace

oracle::Picture picture_of(const culler::Camera& camera, double outward) {
  const auto [right, up, forward] = camera.axes();
  const auto within = [&](const dvec3& normal, double ahead) { return half_space(normal, camera.eye, ahead, outward); };
  const bool perspective = camera.projection == culler::Projection::perspective;
  const double y = perspective ? std::tan(glm::radians(camera.fov_y_deg) / 2) : camera.height / 2;
  const double x = y * camera.aspect;

  oracle::Picture picture;
  for (const auto& [half, across] : {std::pair{x, right}, {x, -right}, {y, up}, {y, -up}}) {
    // The rounding of the tangent and of the sum changes each coordinate of the normal by less than 2^-50 (1 + half). At
    // depth 1 a point of the picture is at most 1 + x + y away from the eye. There the rounding changes the height by less
    // than the tilt does.
    const double tilted = std::copysign(kRounded, outward) * (1 + half) * (1 + x + y);
    picture.sides.push_back(perspective ? within((half + tilted) * forward - across, 0) : within(-across, half));
  }
  picture.depth.push_back(within(forward, -camera.near));
  if (std::isfinite(camera.far)) picture.depth.push_back(within(-forward, camera.far));
  return picture;
}

double depth_of(const oracle::Aabb& model, const culler::Camera& camera) {
  double sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double eye = camera.eye[static_cast<int>(axis)];
    sum += std::max(std::fabs(model.min[axis] - eye), std::fabs(model.max[axis] - eye));
  }
  return sum;
}

bool may_draw_beyond(const std::array<double, 4>& plane, const culler::Camera& camera, const oracle::Aabb& model) {
  const oracle::Picture picture = picture_of(camera, kRendererRounds * depth_of(model, camera));
  std::vector<HalfSpaceCoefficients> both{{-plane[0], -plane[1], -plane[2], -plane[3]}};
  both.insert(both.end(), picture.sides.begin(), picture.sides.end());
  both.insert(both.end(), picture.depth.begin(), picture.depth.end());
  return oracle::relation_to_half_spaces(both, model).relation != Relation::outside;
}

HalfSpaceCoefficients drawn(const culler::Camera& camera, const oracle::Aabb& model) {
  constexpr double kLeast = 0x1p-100, kMost = 0x1p100;
  HalfSpaceCoefficients near = picture_of(camera, -kRendererRounds * depth_of(model, camera)).depth.front();
  double& offset = near[3];
  if (offset != 0 && std::fabs(offset) < kLeast) offset = -kLeast;  // inward
  if (std::fabs(offset) > kMost) {
    for (double& number : near) number *= 0x1p-4;
  }
  return near;
}

bool may_clip(const culler::Camera& camera, const oracle::Aabb& model, std::span<const oracle::Point> points) {
  const HalfSpaceCoefficients near = drawn(camera, model);
  return !std::ranges::all_of(points, [&](const oracle::Point& p) {
    return oracle::relation_to_half_spaces(std::span(&near, 1), oracle::Aabb{p, p}).relation == Relation::inside;
  });
}

}  // namespace occlude::proof
