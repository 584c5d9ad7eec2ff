// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <optional>
#include <vector>

#include "camera/frame_view.h"
#include "camera/matrix_eye.h"
#include "camera/single_precision.h"
#include "measure_culler.h"
#include "true_plane.h"

namespace occlude::bound_check {
namespace {

using culler::MatrixCamera;
using culler::MatrixEye;
using culler::MatrixRow;
using Share = std::optional<double>;

double sum_of(const glm::dvec3& v) { return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z); }

/// A function normal . p + constant in exact numbers.
TruePlane exact_row(const MatrixRow& row) { return {bound_check::vector_of(row.normal), Exact(row.constant)}; }
Exact at(const TruePlane& plane, const Vector& p) { return plane.normal * p + plane.offset; }

/// The point where three functions are 0.
Vector meeting_point(const TruePlane& a, const TruePlane& b, const TruePlane& c) {
  const Vector bc = CGAL::cross_product(b.normal, c.normal), ca = CGAL::cross_product(c.normal, a.normal),
               ab = CGAL::cross_product(a.normal, b.normal);
  return (a.offset * bc + b.offset * ca + c.offset * ab) / -(a.normal * bc);
}

Exact length(const Vector& v) { return root(v * v); }

MatrixRow any_row(Choices& choices) {
  const glm::dvec3 normal = choices.scale(-10, 10) * choices.point();
  return {normal, glm::dot(normal, choices.scale(-10, 10) * choices.point())};
}

Share rows_at_points(Choices& choices) {
  const MatrixRow row = any_row(choices);
  const glm::dvec3 p = choices.scale(-10, 10) * choices.point();
  return share(CGAL::abs(Exact(row.at(p)) - at(exact_row(row), bound_check::vector_of(p))), row.error_at(p));
}

/// A matrix by its rows.
struct Rows {
  MatrixRow x, y, z, w;
  culler::ClipDepth depth;
  culler::Nearer nearer;

  [[nodiscard]] MatrixCamera camera() const {
    MatrixCamera camera;
    const std::array<const MatrixRow*, 4> rows{&x, &y, &z, &w};
    for (int row = 0; row < 4; ++row) {
      const MatrixRow& from = *rows[static_cast<std::size_t>(row)];
      for (int axis = 0; axis < 3; ++axis) camera.matrix[axis][row] = from.normal[axis];
      camera.matrix[3][row] = from.constant;
    }
    camera.depth = depth;
    camera.nearer = nearer;
    return camera;
  }
};

/// A matrix with any eye. Its axes are nearly dependent in some. With parallel rays w may change a little.
Rows any_rows(Choices& choices, bool is_parallel) {
  const glm::dvec3 eye = choices.scale(-10, is_parallel ? 90 : 30) * choices.point();
  const double skew = choices.chance(0.3) ? choices.scale(-28, 0) : 1;
  const auto row = [&](const glm::dvec3& normal, double constant) {
    return MatrixRow{normal, constant - glm::dot(normal, eye)};
  };
  const glm::dvec3 along = choices.point();
  Rows rows;
  rows.x = row(choices.scale(-10, 10) * (choices.chance(0.5) ? along + skew * choices.point() : choices.point()), 0);
  rows.y = row(choices.scale(-10, 10) * choices.point(), 0);
  if (is_parallel) {
    rows.z = row(choices.scale(-10, 10) * along, choices.real(-1, 1));
    rows.w.constant = choices.scale(-10, 10);
    if (choices.chance(0.5)) rows.w.normal = rows.w.constant * 0x1p-106 * choices.point();
    rows.nearer = choices.chance(0.5) ? culler::Nearer::less : culler::Nearer::greater;
  } else {
    rows.w = row(choices.scale(-10, 10) * along, 0);
    const double share = choices.real(-2, 2);
    const glm::dvec3 oblique = choices.chance(0.5) ? choices.scale(-20, 1) * choices.point() : glm::dvec3(0, 0, 0);
    rows.z = row(share * rows.w.normal + oblique, choices.sign() * choices.scale(-30, 10));
    rows.nearer = culler::Nearer::unsaid;
  }
  rows.depth = choices.chance(0.5) ? culler::ClipDepth::zero_to_w : culler::ClipDepth::minus_w_to_w;
  return rows;
}

Share eyes_of_matrices(Choices& choices) {
  const Rows rows = any_rows(choices, false);
  const MatrixEye eye(rows.camera());
  if (!eye.fault().empty() || !eye.is_perspective()) return std::nullopt;
  const Vector truth = meeting_point(exact_row(rows.x), exact_row(rows.y), exact_row(rows.w));
  return share(length(truth - bound_check::vector_of(eye.eye())), eye.moved(1));
}

/// How far a point would have to be moved: MatrixEye::moved() has both reasons.
Share moves_of_parallel_rays(Choices& choices) {
  const Rows rows = any_rows(choices, true);
  const MatrixEye of(rows.camera());
  if (!of.fault().empty() || of.is_perspective()) return std::nullopt;
  const double depth = choices.scale(-10, 90);
  const glm::dvec3 p = of.eye() + depth * choices.point() / 3.0;
  const Vector point = bound_check::vector_of(p), forward = bound_check::vector_of(of.axes().forward);
  const TruePlane x = exact_row(rows.x), y = exact_row(rows.y), w = exact_row(rows.w);
  const Vector direction = CGAL::cross_product(x.normal, y.normal);
  const Exact turned = length(CGAL::cross_product(direction, forward)) / CGAL::abs(direction * forward);
  TruePlane near = exact_row(rows.z);
  near.offset -= rows.nearer == culler::Nearer::greater          ? w.offset
                 : rows.depth == culler::ClipDepth::minus_w_to_w ? Exact(-w.offset)
                                                                 : Exact(0);
  const Vector middle = meeting_point(x, y, near);
  const Exact changed = at(w, point) / at(w, middle);
  const Exact off =
      turned * length(point - bound_check::vector_of(of.eye())) + length(point - middle) * CGAL::abs(1 - 1 / changed);
  return share(off, of.moved(depth));
}

/// A plane of a matrix, and what it is exactly.
struct AnyPlane {
  culler::ClipPlane plane;
  const MatrixRow* row;
  double sign;
  bool with_w;
  Rows rows;
  glm::dvec3 eye;
  double depth;
  glm::dvec3 point;

  /// The height of the point over the plane, from the values of the two functions.
  [[nodiscard]] Exact height(const Exact& value, const Exact& w) const {
    const Vector own = Exact(sign) * bound_check::vector_of(row->normal);
    const Vector normal = with_w ? Vector(own + bound_check::vector_of(rows.w.normal)) : own;
    return (Exact(sign) * value + (with_w ? w : Exact(0))) / length(normal);
  }
  [[nodiscard]] Exact height() const {
    const Vector p = bound_check::vector_of(point);
    return height(at(exact_row(*row), p), at(exact_row(rows.w), p));
  }
};

template <class Use>
Share of_any_plane(Choices& choices, const Use& use) {
  AnyPlane any;
  any.rows = any_rows(choices, choices.chance(0.2));
  const MatrixEye of(any.rows.camera());
  if (!of.fault().empty()) return std::nullopt;
  any.eye = of.eye();
  any.depth = choices.scale(-10, 10);
  any.point = any.eye + any.depth * choices.point() / 3.0;
  const std::size_t i = choices.index(6);
  any.plane = of.planes(any.depth)[i];
  if (any.plane.is_everywhere) return std::nullopt;
  const bool is_reversed = of.is_perspective() ? any.rows.z.at(any.eye) > 0 : any.rows.nearer == culler::Nearer::greater;
  const bool is_below_w = (i == MatrixEye::kNear) == is_reversed;
  any.row = i < 2 ? &any.rows.x : i < 4 ? &any.rows.y : &any.rows.z;
  any.sign = (i < 4 ? i % 2 == 1 : is_below_w) ? -1 : 1;
  any.with_w = i < 4 || is_below_w || any.rows.depth == culler::ClipDepth::minus_w_to_w;
  return use(any);
}

Share planes_of_matrices(Choices& choices) {
  return of_any_plane(choices, [](const AnyPlane& any) -> Share {
    const culler::ClipPlane& plane = any.plane;
    const Exact computed = bound_check::vector_of(plane.normal) * bound_check::vector_of(any.point) + Exact(plane.offset);
    const double bound = 0x1p-48 * (sum_of(any.eye) + any.depth + std::fabs(plane.offset));
    return share(CGAL::abs(computed - any.height()), bound);
  });
}

float rounded(double x) { return static_cast<float>(x); }

/// A function of points as a renderer in floats computes it, relative to the eye.
float in_floats(const MatrixRow& row, const glm::dvec3& eye, const glm::dvec3& p) {
  const float x = rounded(p.x - eye.x), y = rounded(p.y - eye.y), z = rounded(p.z - eye.z);
  return rounded(row.normal.x) * x + rounded(row.normal.y) * y + rounded(row.normal.z) * z + rounded(row.at(eye));
}

Share planes_in_floats(Choices& choices) {
  return of_any_plane(choices, [](const AnyPlane& any) -> Share {
    const float value = in_floats(*any.row, any.eye, any.point), w = in_floats(any.rows.w, any.eye, any.point);
    if (!std::isfinite(value) || !std::isfinite(w)) return std::nullopt;
    return share(CGAL::abs(any.height(value, w) - any.height()), any.plane.error);
  });
}

Share vectors_along_axes(Choices& choices) {
  const MatrixEye of(any_rows(choices, choices.chance(0.3)).camera());
  if (!of.fault().empty()) return std::nullopt;
  const double right = choices.real(-1, 1), up = choices.real(-1, 1), forward = choices.real(-1, 1);
  const MatrixEye::Vector vector = of.vector(right, up, forward);
  const auto plane = [](const glm::dvec3& axis, double value) {
    return TruePlane{bound_check::vector_of(axis), Exact(-value)};
  };
  const auto& axes = of.axes();
  const Vector truth = meeting_point(plane(axes.right, right), plane(axes.up, up), plane(axes.forward, forward));
  return share(length(truth - bound_check::vector_of(vector.value)), vector.error);
}

culler::Camera any_camera(Choices& choices) {
  culler::Camera camera;
  camera.eye = choices.scale(-10, 20) * choices.point();
  camera.target = camera.eye + choices.scale(-10, 10) * choices.point();
  camera.up = choices.point();
  if (choices.chance(0.3)) camera.projection = culler::Projection::orthographic;
  camera.fov_y_deg = choices.chance(0.3) ? 0.001 + choices.scale(-10, 0) : choices.real(0.01, 179);
  camera.height = choices.scale(-10, 10);
  camera.aspect = choices.scale(-16, 16);
  camera.near_plane = choices.scale(-20, 5);
  camera.far_plane =
      choices.chance(0.5) ? camera.near_plane * choices.scale(1, 20) : std::numeric_limits<double>::infinity();
  return camera;
}

/// What a half-space of a camera is off by, beside the distance that it is moved outwards. The bound is what it is moved for
/// the rounding of its offset, and what its margin has beside half as much again as a renderer in single precision needs.
Share planes_of_cameras(Choices& choices) {
  const culler::Camera camera = any_camera(choices);
  if (!fault(camera).empty()) return std::nullopt;
  const double depth = choices.scale(-10, 10);
  const culler::FrameView view(camera, depth);
  const std::size_t i = choices.index(view.half_space_count);
  const Vector eye = bound_check::vector_of(camera.eye), forward = bound_check::vector_of(view.axes.forward);
  const Vector across = Exact(i % 2 == 0 ? 1 : -1) * bound_check::vector_of(i < 2 ? view.axes.right : view.axes.up);
  const Exact half(i < 2 ? view.half_width : view.half_height);
  const Vector inward = i == 4                ? forward
                        : i == 5              ? Vector(-forward)
                        : view.is_perspective ? Vector(half * forward + across)
                                              : across;
  const Vector through = i == 4                ? Vector(eye + Exact(camera.near_plane) * forward)
                         : i == 5              ? Vector(eye + Exact(camera.far_plane) * forward)
                         : view.is_perspective ? eye
                                               : Vector(eye - half * across);
  const Vector p = bound_check::vector_of(camera.eye + depth * choices.point() / 3.0);
  const culler::HalfSpace& plane = view.half_spaces[i];
  const Exact computed = bound_check::vector_of(plane.normal) * p + Exact(plane.offset);
  const Exact truth = inward * (p - through) / length(inward);
  const Exact size = CGAL::abs(through.x()) + CGAL::abs(through.y()) + CGAL::abs(through.z());
  const Exact outwards = Exact(0x1p-48) * size + Exact(culler::kDepthMargin) * Exact(depth);
  return share(CGAL::abs(truth + outwards - computed), outwards - Exact(1.5 * culler::kSinglePrecision) * Exact(depth));
}

/// The height of a point over a near plane as a renderer in floats computes it: with coordinates relative to the middle of
/// the model, and the eye in two parts (single_precision.h).
Share points_in_floats(Choices& choices) {
  const glm::dvec3 middle = choices.scale(-10, 20) * choices.point(), half = glm::abs(choices.point());
  const glm::dvec3 eye = middle + choices.scale(-10, 3) * choices.point(), p = middle + half * choices.point();
  const glm::dvec3 normal = glm::normalize(choices.point());
  glm::vec3 y;
  double depth = 0;
  for (int k = 0; k < 3; ++k) {
    const double from = eye[k] - middle[k];
    const float high = rounded(from), low = rounded(from - high);
    y[k] = rounded(p[k] - middle[k]) - high - low;
    depth += std::fabs(from) + half[k];
  }
  const double near = depth * choices.real(0, 1);
  const float computed = rounded(normal.x) * y.x + rounded(normal.y) * y.y + rounded(normal.z) * y.z + rounded(-near);
  const Exact truth =
      bound_check::vector_of(normal) * (bound_check::vector_of(p) - bound_check::vector_of(eye)) - Exact(near);
  return share(CGAL::abs(Exact(computed) - truth), culler::kSinglePrecision * depth);
}

}  // namespace

std::vector<Measured> measure_cameras(int cases, std::uint64_t seed) {
  return {
      search("rows of a matrix at points", "matrix_eye", cases, seed, rows_at_points),
      search("the eye of a matrix", "matrix_eye", cases, seed, eyes_of_matrices),
      search("moves that make rays parallel", "matrix_eye", cases, seed, moves_of_parallel_rays),
      search("vectors along the axes of a matrix", "matrix_eye", cases, seed, vectors_along_axes),
      search("planes of a matrix", "matrix_eye", cases, seed, planes_of_matrices),
      search("planes of a matrix in a renderer's floats", "matrix_eye", cases, seed, planes_in_floats),
      search("planes of a camera", "frame_view", cases, seed, planes_of_cameras),
      search("points in a renderer's floats", "single_precision", cases, seed, points_in_floats),
  };
}

}  // namespace occlude::bound_check
