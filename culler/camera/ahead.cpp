// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <stdexcept>
#include <string>

#include "camera/extent.h"
#include "camera/frame_view.h"
#include "camera/sound_camera.h"
#include "occlude/culler/camera.h"
#include "occlude/kernel/validity.h"

namespace occlude::culler {
namespace {

/// What rounds is widened by this. It rounds by far less.
constexpr double kWider = 1 + 0x1p-40;
/// A near plane is so much farther, for what a renderer in single precision misjudges it by. That is a part of the depth of
/// the model, which is not known here, and turns with the camera: holds_for.cpp. With a near plane at a distance of .1 it is
/// enough for a model of 10,000.
constexpr double kBeyondNear = 1 + 1.0 / 64;
/// Tangents of the widest opening that a camera may have, nearly 179 degrees.
constexpr double kWidest = 114;

constexpr double kNoPlane = std::numeric_limits<double>::infinity();

/// A picture in the middle of its axes, which are orthonormal.
struct Picture {
  double width, height;  ///< half of its own at a distance of 1
  double near, far;
};

/// A picture with all rays that are at an angle of up to `turn` from a ray of this one. The side x = T z, whose normal is (T
/// z - x) / sqrt(1 + T^2), must be by the sine of the angle away from all unit vectors of the picture. The one along its
/// corner of length l is nearest: (T - w) / (l sqrt(1 + T^2)) = sin(turn).
///
/// A ray of length l is at an angle of acos(1 / l) from the axis, and reaches l cos(acos(1 / l) - turn) along it when it is
/// turned: cos(turn) + sqrt(l^2 - 1) sin(turn), or l if it can be turned so far.
Picture turned(const Picture& picture, double turn) {
  const double across = picture.width * picture.width + picture.height * picture.height;
  const double sine = std::sin(turn), square = sine * sine * (1 + across);
  const auto widened = [&](double half) {
    if (!(square < 1) || turn > glm::radians(90.0)) return std::max(half, kWidest);
    const double wide = (half + std::sqrt(square * (1 + half * half - square))) / (1 - square);
    return std::min(kWider * wide, std::max(half, kWidest));
  };
  const double longest = std::sqrt(1 + across);
  const double along = turn < std::acos(1 / longest) ? std::cos(turn) + std::sqrt(across) * sine : longest;
  const double farther = kWider * std::max(along, 1.0);
  return {widened(picture.width), widened(picture.height), kBeyondNear * farther * picture.near, farther * picture.far};
}

glm::dvec3 flushed(const glm::dvec3& v) { return {kernel::flushed(v.x), kernel::flushed(v.y), kernel::flushed(v.z)}; }

/// Half-edges around the way. They are perpendicular, one of them along it, or along the line of sight if there is no way.
/// There is room for how far the eyes of such cameras are rounded.
EyeRegion around(const glm::dvec3& way, const EyeRegion& eyes, const FrameView& view, const Camera::Axes& axes,
                 const AheadOptions& options) {
  const double length = glm::length(way);
  const glm::dvec3 along = length > 0 ? way / length : axes.forward;
  const bool is_upright = std::fabs(glm::dot(along, axes.up)) > 0.9;
  const glm::dvec3 side = glm::normalize(glm::cross(along, is_upright ? axes.right : axes.up));
  const glm::dvec3 up = glm::cross(side, along);
  const double rounded = 0x1p-44 * (glm::length(view.eye) + length) + 8 * view.eye_uncertainty;
  const auto half_edge = [&](const glm::dvec3& axis, double half) {
    return flushed(kWider * (half + eyes.reach(axis) + rounded) * axis);
  };
  return EyeRegion::box(half_edge(along, std::max(length / 2, options.aside)), half_edge(side, options.aside),
                        half_edge(up, options.up));
}

Camera require(const Camera& camera) {
  if (const std::string reason = fault(camera); !reason.empty()) throw std::invalid_argument("the way ahead: " + reason);
  return camera;
}

void widen(Camera& camera, const Picture& picture, double turn_degrees) {
  if (!(turn_degrees >= 0)) throw std::invalid_argument("the way ahead: the camera must turn by 0 degrees or more");
  const auto [width, height, near, far] = turned(picture, glm::radians(turn_degrees));
  camera.fov_y_deg = 2 * glm::degrees(std::atan(height));
  camera.aspect = width / height;
  camera.near_plane = std::min(near, kernel::kMaxMagnitude / 2);
  camera.far_plane = far <= kernel::kMaxMagnitude && far > camera.near_plane ? far : kNoPlane;
}

void move_ahead(Camera& camera, const glm::dvec3& way, const EyeRegion& eyes) {
  camera.eyes = eyes;
  const glm::dvec3 sight = camera.target - camera.eye;
  camera.eye = flushed(camera.eye + way / 2.0);
  camera.target = flushed(camera.eye + sight);
}

}  // namespace

Camera ahead(const Camera& camera, const glm::dvec3& velocity, double seconds, const AheadOptions& options) {
  require_sound(camera);
  const FrameView view(camera, 0);
  Camera result = camera;
  if (view.is_perspective) {
    widen(result, {view.half_width, view.half_height, camera.near_plane, camera.far_plane}, options.turn_degrees);
  }
  const glm::dvec3 way = seconds * velocity;
  move_ahead(result, way, around(way, camera.eyes, view, view.axes, options));
  return require(result);
}

Camera ahead(const MatrixCamera& camera, const glm::dvec3& velocity, double seconds, const AheadOptions& options) {
  require_sound(camera);
  const FrameView view(camera, 0);
  if (!view.is_perspective) throw std::invalid_argument("the way ahead: the matrix has parallel rays");
  const Extent extent(camera, view);
  const glm::dvec3& forward = view.axes.forward;
  const glm::dvec3 right = glm::normalize(glm::cross(forward, view.axes.up));
  const Camera::Axes axes{right, glm::cross(right, forward), forward};
  Picture picture{0, 0, extent.near_until, extent.farthest};
  for (const glm::dvec3& corner : extent.corners) {
    picture.width = std::max(picture.width, kWider * std::fabs(glm::dot(axes.right, corner)) + extent.error);
    picture.height = std::max(picture.height, kWider * std::fabs(glm::dot(axes.up, corner)) + extent.error);
  }
  Camera result{.eye = view.eye, .target = view.eye + forward, .up = axes.up};
  widen(result, picture, options.turn_degrees);
  const glm::dvec3 way = seconds * velocity;
  move_ahead(result, way, around(way, camera.eyes, view, axes, options));
  return require(result);
}

}  // namespace occlude::culler
