// SPDX-License-Identifier: MIT
#include "cameras.h"

#include <array>
#include <cstddef>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "status.h"
#include "structs.h"

namespace occlude::c {
namespace {

glm::dvec3 dvec3(const double* v) { return {v[0], v[1], v[2]}; }

void write3(const glm::dvec3& v, double* to) {
  for (int axis = 0; axis < 3; ++axis) to[axis] = v[axis];
}

culler::EyeRegion to_region(const occlude_eye_region& eyes) {
  return {eyes.radius, {dvec3(eyes.half_edges[0]), dvec3(eyes.half_edges[1]), dvec3(eyes.half_edges[2])}};
}

template <class Number>
culler::MatrixCamera from_matrix(const occlude_matrix_camera& camera, culler::ClipDepth depth, culler::Nearer nearer) {
  std::array<Number, 16> numbers{};
  std::memcpy(numbers.data(), camera.matrix, sizeof numbers);
  if (camera.order == OCCLUDE_ROWS) return culler::MatrixCamera::from_rows(numbers.data(), depth, nearer);
  return culler::MatrixCamera::from_columns(numbers.data(), depth, nearer);
}

culler::ClipDepth to_depth(occlude_clip_depth depth) {
  switch (depth) {
    case OCCLUDE_DEPTH_MINUS_W_TO_W:
      return culler::ClipDepth::minus_w_to_w;
    case OCCLUDE_DEPTH_ZERO_TO_W:
      return culler::ClipDepth::zero_to_w;
    case OCCLUDE_DEPTH_UNSAID:
      throw std::invalid_argument("depth of the camera is not said");
    default:
      refuse_enumerator("depth of the camera", depth);
  }
}

culler::Nearer to_nearer(occlude_nearer nearer) {
  switch (nearer) {
    case OCCLUDE_NEARER_UNSAID:
      return culler::Nearer::unsaid;
    case OCCLUDE_NEARER_LESS:
      return culler::Nearer::less;
    case OCCLUDE_NEARER_GREATER:
      return culler::Nearer::greater;
    default:
      refuse_enumerator("nearer", nearer);
  }
}

occlude_look_at_camera from_camera(const culler::Camera& camera) {
  occlude_look_at_camera result = OCCLUDE_LOOK_AT_CAMERA_INIT;
  write3(camera.eye, result.eye);
  write3(camera.target, result.target);
  write3(camera.up, result.up);
  result.fov_y_deg = camera.fov_y_deg;
  result.height = camera.height;
  result.aspect = camera.aspect;
  result.near_plane = camera.near_plane;
  result.far_plane = camera.far_plane;
  result.projection = camera.projection == culler::Projection::orthographic ? OCCLUDE_ORTHOGRAPHIC : OCCLUDE_PERSPECTIVE;
  result.eyes.radius = camera.eyes.radius;
  for (std::size_t i = 0; i < camera.eyes.half_edges.size(); ++i)
    write3(camera.eyes.half_edges[i], result.eyes.half_edges[i]);
  return result;
}

/// A way ahead, of a camera of either kind.
template <class Camera>
occlude_status write_ahead(const Camera* camera, const double* velocity, double seconds,
                           const occlude_ahead_options* options, occlude_look_at_camera* to) {
  return guarded([&] {
    require(velocity, "velocity");
    write(from_camera(ahead(to_camera(camera), dvec3(velocity), seconds, to_way(options))), to, "ahead");
  });
}

}  // namespace

culler::Camera to_camera(const occlude_look_at_camera* given) {
  require(given, "camera");
  const auto camera = read_options(given, occlude_look_at_camera OCCLUDE_LOOK_AT_CAMERA_INIT, "camera");
  if (camera.projection != OCCLUDE_PERSPECTIVE && camera.projection != OCCLUDE_ORTHOGRAPHIC) {
    refuse_enumerator("projection", camera.projection);
  }
  const bool is_orthographic = camera.projection == OCCLUDE_ORTHOGRAPHIC;
  return {.eye = dvec3(camera.eye),
          .target = dvec3(camera.target),
          .up = dvec3(camera.up),
          .projection = is_orthographic ? culler::Projection::orthographic : culler::Projection::perspective,
          .fov_y_deg = camera.fov_y_deg,
          .height = camera.height,
          .aspect = camera.aspect,
          .near_plane = camera.near_plane,
          .far_plane = camera.far_plane == 0 ? std::numeric_limits<double>::infinity() : camera.far_plane,
          .eyes = to_region(camera.eyes)};
}

culler::MatrixCamera to_camera(const occlude_matrix_camera* given) {
  const auto camera = read(given, occlude_matrix_camera OCCLUDE_MATRIX_CAMERA_INIT, "camera");
  require(camera.matrix, "matrix");
  if (camera.order != OCCLUDE_COLUMNS && camera.order != OCCLUDE_ROWS) refuse_enumerator("matrix order", camera.order);
  if (camera.type != OCCLUDE_DOUBLE && camera.type != OCCLUDE_FLOAT) refuse_enumerator("number type", camera.type);
  const culler::ClipDepth depth = to_depth(camera.depth);
  const culler::Nearer nearer = to_nearer(camera.nearer);
  culler::MatrixCamera result =
      camera.type == OCCLUDE_FLOAT ? from_matrix<float>(camera, depth, nearer) : from_matrix<double>(camera, depth, nearer);
  result.eyes = to_region(camera.eyes);
  return result;
}

culler::AheadOptions to_way(const occlude_ahead_options* given) {
  const auto options = read_options(given, occlude_ahead_options OCCLUDE_AHEAD_OPTIONS_INIT, "options");
  return {.aside = options.aside, .up = options.up, .turn_degrees = options.turn_degrees};
}

}  // namespace occlude::c

using namespace occlude::c;

occlude_status occlude_look_at_matrix(const occlude_look_at_camera* camera, occlude_clip_depth depth, occlude_nearer nearer,
                                      double* matrix) noexcept {
  return guarded([&] {
    require(matrix, "matrix");
    const auto made = occlude::culler::MatrixCamera::from_camera(to_camera(camera), to_depth(depth), to_nearer(nearer));
    for (int i = 0; i < 16; ++i) matrix[i] = made.matrix[i / 4][i % 4];
  });
}

double occlude_margin_for(uint32_t rows) noexcept { return occlude::culler::margin_for(rows); }

occlude_status occlude_ahead(const occlude_matrix_camera* camera, const double* velocity, double seconds,
                             const occlude_ahead_options* options, occlude_look_at_camera* ahead) noexcept {
  return write_ahead(camera, velocity, seconds, options, ahead);
}

occlude_status occlude_ahead_look_at(const occlude_look_at_camera* camera, const double* velocity, double seconds,
                                     const occlude_ahead_options* options, occlude_look_at_camera* ahead) noexcept {
  return write_ahead(camera, velocity, seconds, options, ahead);
}
