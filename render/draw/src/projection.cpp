// SPDX-License-Identifier: MIT
#include "projection.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace occlude::render {
namespace {

using culler::Camera;
using glm::dvec3;
using glm::dvec4;

/// A linear function of a vector relative to the eye: coefficients, constant.
dvec4 row(const dvec3& coefficients, double constant) { return {coefficients, constant}; }

glm::dmat4 from_rows(const dvec4& x, const dvec4& y, const dvec4& z, const dvec4& w) {
  return glm::transpose(glm::dmat4(x, y, z, w));
}

glm::dmat4 perspective(const Camera& camera, const Camera::Axes& axes) {
  const double y_scale = 1 / std::tan(glm::radians(camera.fov_y_deg) / 2);
  // depth = z / w, where w is the distance along the line of sight: near / w, or near (far - w) / (far - near) / w.
  const bool endless = std::isinf(camera.far_plane);
  const double slope = endless ? 0 : -camera.near_plane / (camera.far_plane - camera.near_plane);
  const double constant =
      endless ? camera.near_plane : camera.near_plane * (camera.far_plane / (camera.far_plane - camera.near_plane));
  return from_rows(row(y_scale / camera.aspect * axes.right, 0), row(y_scale * axes.up, 0),
                   row(slope * axes.forward, constant), row(axes.forward, 0));
}

/// Distance along the line of sight of the farthest corner of `model`.
double farthest(const Extent& model, const Camera& camera, const dvec3& forward) {
  dvec3 corner;
  for (int axis = 0; axis < 3; ++axis) corner[axis] = forward[axis] > 0 ? model.max[axis] : model.min[axis];
  return glm::dot(corner - camera.eye, forward);
}

glm::dmat4 orthographic(const Camera& camera, const Camera::Axes& axes, const Extent& model) {
  // Twice as far as the model reaches, so that rounding cannot clip it.
  const double behind_model = camera.near_plane + 2 * std::max(farthest(model, camera, axes.forward), camera.near_plane);
  const double far = std::min(camera.far_plane, behind_model);
  const double y_scale = 2 / camera.height, z_scale = 1 / (far - camera.near_plane);
  return from_rows(row(y_scale / camera.aspect * axes.right, 0), row(y_scale * axes.up, 0),
                   row(-z_scale * axes.forward, far * z_scale), row(dvec3(0, 0, 0), 1));
}

}  // namespace

glm::mat4 clip_from_eye_relative(const Camera& camera, const Extent& model, const glm::dvec2& shift) {
  const Camera::Axes axes = camera.axes();
  glm::dmat4 clip =
      camera.projection == culler::Projection::perspective ? perspective(camera, axes) : orthographic(camera, axes, model);
  for (int column = 0; column < 4; ++column) {
    clip[column].x += shift.x * clip[column].w;
    clip[column].y += shift.y * clip[column].w;
  }
  return glm::mat4(clip);
}

}  // namespace occlude::render
