// SPDX-License-Identifier: MIT
// What a frame computes from its camera once, whichever kind of camera it is. Reading order: 11.
#pragma once

#include <array>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <variant>
#include <vector>

#include "occlude/culler/camera.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// The picture is {v : |right . v| <= half_width forward . v and |up . v| <= half_height forward . v} of the directions v
/// from the eye. With parallel rays it is {v : |right . v| <= half_width and |up . v| <= half_height} of the vectors v from
/// `eye`. So it is always in the middle of its axes. Where the line of sight does not meet the middle of the picture,
/// `right` and `up` are not perpendicular to `forward`.
struct FrameView {
  /// For a model with no point farther than `reach` from the eye, in the sum of the axes. REQUIRES: the camera has no
  /// fault().
  FrameView(const Camera& camera, double reach);
  FrameView(const MatrixCamera& camera, double reach);
  /// For no model.
  FrameView() : FrameView(Camera{}, 0) {}

  /// Does what append_view_frustum() does.
  void append_half_spaces(std::vector<HalfSpace>& planes) const;
  /// Whether the renderer may clip the point at its near plane, from any of the eyes. In front of `near` it may even if this
  /// says no.
  [[nodiscard]] bool may_clip(const glm::dvec3& point) const { return glm::dot(point - eye, near_normal) < near_distance; }
  /// Whether the renderer may clip something of the convex hull of the vertices at its near plane. Such a thing must not
  /// occlude.
  [[nodiscard]] bool may_clip(std::span<const kernel::Vec3> vertices) const;

  std::variant<Camera, MatrixCamera> any_camera;  ///< the camera itself
  bool is_perspective;
  double depth;       ///< at least the `reach` given, and as far as the model is from any of the eyes
  glm::dvec3 eye;     ///< with parallel rays, a point of the near plane or behind it, from which lengths are measured
  Camera::Axes axes;  ///< unit vectors, up to rounding
  kernel::Viewpoint viewpoint;
  double half_width, half_height;
  double height;           ///< of the picture, perpendicular to the line of sight: at a distance of 1, or with parallel rays
  double area;             ///< with parallel rays, of the picture
  glm::dvec3 near_normal;  ///< of the renderer's near plane, into the view; a unit vector, up to rounding
  double near_distance;    ///< from `eye` along near_normal. The renderer clips nothing that is farther, however it rounds
  /// What hides counts only from here on, along `forward`. Unless is_oblique, the renderer clips nothing of the picture that
  /// is farther, however it rounds.
  double near;
  bool is_oblique;  ///< a triangle with a corner that it may_clip() does not hide
  /// The camera sees what it would see from `eye` along `forward` if each point were moved by up to this. It is more than 0
  /// where the eye is not known exactly.
  double eye_uncertainty;
  EyeRegion eyes;  ///< the frame holds for all of them, relative to `eye`. With parallel rays, `eye` stands for all of them
  std::array<HalfSpace, 6> half_spaces;
  /// The margin that each half-space has for single precision, as a share of the depth.
  std::array<double, 6> half_space_margins;
  std::size_t half_space_count = 0;

 private:
  void add(const HalfSpace& half_space, double margin) {
    half_spaces[half_space_count] = half_space;
    half_space_margins[half_space_count++] = margin;
  }
};

}  // namespace occlude::culler
