// SPDX-License-Identifier: MIT
#include "camera/matrix_eye.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>

#include "camera/eye_region.h"
#include "camera/legal_half_space.h"
#include "camera/legal_numbers.h"
#include "camera/negligible.h"
#include "camera/single_precision.h"
#include "model/bounds.h"
#include "occlude/kernel/validity.h"

namespace occlude::culler {
namespace {

/// Three unit vectors are refused if their determinant is smaller. It takes less than 2^-49 of rounding, so that its
/// relative error, and that of cross products, which are no shorter, is below 2^-17.
constexpr double kLeastDeterminant = 0x1p-32;
/// The squares of shorter vectors may be subnormal numbers, which are less precise. Such a row counts as 0.
constexpr double kLeastLength = 0x1p-400;
/// A bound that is computed with such numbers is multiplied by this.
constexpr double kErrorRounded = 1 + 0x1p-10;

/// Half of a picture's width or height at a distance of 1. These are the limits of Camera: a tangent of half of 0.001 or of
/// 179 degrees, times or divided by 65536; rounded outwards.
constexpr double kLeastSlope = 0x1p-34, kMostSlope = 0x1p24;

/// With parallel rays the normal of w may be so much of w. All points together then change w by no more than a twentieth.
constexpr double kParallel = 0x1p-106;

/// A plane is everywhere if its normal is so small a share of the rows that it is the sum of. It has an error in single
/// precision of 2^20 times the depth, and cuts off nothing.
constexpr double kVanishing = 0x1p-40;

double sum_of(const glm::dvec3& v) { return std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z); }

MatrixRow row_of(const glm::dmat4& matrix, int row) {
  return {{matrix[0][row], matrix[1][row], matrix[2][row]}, matrix[3][row]};
}

/// Three vectors, and three that give 1 times one of them and 0 times the other two.
struct Basis {
  std::array<glm::dvec3, 3> dual{};
  double determinant = 0;

  Basis(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c)
      : dual{glm::cross(b, c), glm::cross(c, a), glm::cross(a, b)}, determinant(glm::dot(a, dual[0])) {
    for (glm::dvec3& d : dual) d /= determinant;
  }
  [[nodiscard]] bool is_singular() const { return !(std::fabs(determinant) >= kLeastDeterminant); }
  [[nodiscard]] glm::dvec3 combine(double a, double b, double c) const { return a * dual[0] + b * dual[1] + c * dual[2]; }
};

glm::dvec3 unit(const glm::dvec3& v) { return v / glm::length(v); }

/// The point where the three functions are 0, as good as doubles hold it: the residuals, which have small errors, correct
/// the first solution.
glm::dvec3 meeting_point(const std::array<MatrixRow, 3>& rows, const Basis& basis) {
  glm::dvec3 point{0, 0, 0};
  for (int turn = 0; turn < 3; ++turn) {
    std::array<double, 3> off{};
    for (std::size_t i = 0; i < 3; ++i) off[i] = -rows[i].at(point) / glm::length(rows[i].normal);
    point += basis.combine(off[0], off[1], off[2]);
  }
  for (int axis = 0; axis < 3; ++axis) {
    point[axis] = kernel::flushed(point[axis]);
  }
  return point;
}

/// Bounds how far a point is from where the three functions are 0: that is the sum of dual vectors times residuals.
double distance_bound(const std::array<MatrixRow, 3>& rows, const Basis& basis, const glm::dvec3& point) {
  double bound = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    const double residual = std::fabs(rows[i].at(point)) + rows[i].error_at(point);
    bound += residual / glm::length(rows[i].normal) * glm::length(basis.dual[i]);
  }
  return kErrorRounded * bound;
}

}  // namespace

double MatrixRow::error_at(const glm::dvec3& p) const {
  return 0x1p-50 * (glm::dot(glm::abs(normal), glm::abs(p)) + std::fabs(constant));
}

MatrixEye::MatrixEye(const MatrixCamera& camera)
    : x_(row_of(camera.matrix, 0)),
      y_(row_of(camera.matrix, 1)),
      z_(row_of(camera.matrix, 2)),
      w_(row_of(camera.matrix, 3)),
      depth_(camera.depth) {
  fault_ = find(camera);
}

std::string_view MatrixEye::find(const MatrixCamera& camera) {
  for (int i = 0; i < 16; ++i) {
    if (!(std::fabs(camera.matrix[i / 4][i % 4]) <= kernel::kMaxMagnitude)) return "a number is not finite or out of range";
  }
  if (const std::string_view of_eyes = culler::fault(camera.eyes); !of_eyes.empty()) return of_eyes;
  const glm::dvec3& w = w_.normal;
  is_perspective_ = std::max({std::fabs(w.x), std::fabs(w.y), std::fabs(w.z)}) > kParallel * std::fabs(w_.constant);
  if (const auto fault = is_perspective_ ? find_perspective() : find_parallel(camera.nearer); !fault.empty()) return fault;
  if (camera.nearer != Nearer::unsaid && is_reversed_ != (camera.nearer == Nearer::greater))
    return "the matrix says otherwise of what is nearer";
  if (plane(near_row(), 0).is_everywhere) return "the matrix is singular: it has no near plane";
  return "";
}

std::string_view MatrixEye::find_perspective() {
  const double of_x = glm::length(x_.normal), of_y = glm::length(y_.normal), of_w = glm::length(w_.normal);
  const Basis basis(x_.normal / of_x, y_.normal / of_y, w_.normal / of_w);
  if (std::min({of_x, of_y, of_w}) < kLeastLength || basis.is_singular()) return "the matrix is singular: it has no eye";
  const std::array<MatrixRow, 3> rows{x_, y_, w_};
  eye_ = meeting_point(rows, basis);
  if (!is_legal(eye_)) return "the eye is out of range";
  eye_error_ = distance_bound(rows, basis, eye_);
  axes_ = {x_.normal / of_x, y_.normal / of_y, without_negligible(w_.normal / of_w)};
  half_width_ = of_w / of_x;
  half_height_ = of_w / of_y;
  height_ = 2 * half_height_ / glm::length(glm::cross(axes_.up, axes_.forward));
  if (!(std::min(half_width_, half_height_) >= kLeastSlope && std::max(half_width_, half_height_) <= kMostSlope))
    return "the picture must have an extent, and a bound";
  const double depth = z_.at(eye_);
  if (!(std::fabs(depth) > z_.error_at(eye_) + kErrorRounded * glm::length(z_.normal) * eye_error_))
    return "the matrix is singular: it has no depth";
  is_reversed_ = depth > 0;  // z / w falls along the line of sight
  return "";
}

std::string_view MatrixEye::find_parallel(Nearer nearer) {
  if (!(w_.constant > 0)) return "w is nowhere positive";
  const double of_x = glm::length(x_.normal), of_y = glm::length(y_.normal), of_z = glm::length(z_.normal);
  const Basis basis(x_.normal / of_x, y_.normal / of_y, z_.normal / of_z);
  if (std::min({of_x, of_y, of_z}) < kLeastLength || basis.is_singular())
    return "the matrix is singular: it has no direction";
  if (nearer == Nearer::unsaid) return "with parallel rays it must be said whether nearer is less or greater";
  is_reversed_ = nearer == Nearer::greater;
  const double sign = is_reversed_ ? -1 : 1;
  axes_.right = x_.normal / of_x;
  axes_.up = y_.normal / of_y;
  axes_.forward = without_negligible(unit(sign * basis.dual[2]));  // along which x and y do not change, and z does so
  // What is left of x and y along it tells how much it is turned.
  const double turned =
      std::fabs(glm::dot(axes_.right, axes_.forward)) + std::fabs(glm::dot(axes_.up, axes_.forward)) + 0x1p-49;
  direction_error_ = kErrorRounded * turned / glm::length(glm::cross(axes_.right, axes_.up));
  bend_ = sum_of(w_.normal) / w_.constant;
  MatrixRow depth = z_;
  depth.constant -= is_reversed_ ? w_.constant : depth_ == ClipDepth::zero_to_w ? 0 : -w_.constant;
  eye_ = meeting_point({x_, y_, depth}, basis);
  if (!is_legal(eye_)) return "the eye is out of range";
  half_width_ = w_.constant / of_x;
  half_height_ = w_.constant / of_y;
  height_ = 2 * half_height_;
  for (const double half : {half_width_, half_height_}) {
    if (kernel::check(half) != kernel::Refusal::none) return "the picture must have an extent, and a bound";
  }
  return "";
}

/// With parallel rays, two errors add up along the depth:
/// 1. Rays have a direction with an error of a tangent t. If every point is moved across by t times its distance along the
///    direction, rays become parallel to the exact one.
/// 2. Let w be 1 + q(p) times what it is at the eye, q less than a twentieth. If every point y, relative to where x = y = 0
///    on the near plane, is moved to y / (1 + q), rays become those of constant w. That is a move of at most 2 q |y|. The
///    eye is less than its coordinates away from that place.
double MatrixEye::moved(double depth) const {
  if (is_perspective_) return eye_error_;
  const double reach = sum_of(eye_) + depth;
  return kErrorRounded * (direction_error_ * depth + 2 * bend_ * reach * reach);
}

MatrixEye::Vector MatrixEye::vector(double right, double up, double forward) const {
  const Basis basis(axes_.right, axes_.up, axes_.forward);
  // Cross products have errors below 2^-51, the determinant below 2^-50. The dual vectors are no longer than 1 /
  // determinant.
  const double size = std::fabs(right) + std::fabs(up) + std::fabs(forward);
  return {basis.combine(right, up, forward), 0x1p-48 * size / (basis.determinant * basis.determinant)};
}

/// What the renderer's near plane keeps, and below its far plane. The near plane is the one that the eye is beyond, or that
/// is nearer along parallel rays.
MatrixEye::Sum MatrixEye::near_row() const {
  if (is_reversed_) return {z_, -1, true};
  return {z_, 1, depth_ == ClipDepth::minus_w_to_w};
}
MatrixEye::Sum MatrixEye::far_row() const {
  if (!is_reversed_) return {z_, -1, true};
  return {z_, 1, depth_ == ClipDepth::minus_w_to_w};
}

/// Sums of two numbers of the matrix round once, quotients once, and components below 2^-60 are dropped. So a coordinate p
/// is multiplied by a number that is off by less than 2^-51, and the offset is off by as much of itself. 2^-48 leaves room
/// for the sums in which these numbers are used.
///
/// A renderer computes each of the two functions with errors of kDepthMargin, or less, of their terms, and these errors are
/// divided by the length of the sum. That is more than the terms if they nearly cancel.
ClipPlane MatrixEye::plane(const Sum& sum, double depth) const {
  glm::dvec3 normal = sum.sign * sum.row.normal;
  double constant = sum.sign * sum.row.constant;
  double size = glm::length(sum.row.normal), at_eye = std::fabs(sum.row.at(eye_));
  if (sum.with_w) {
    normal += w_.normal;
    constant += w_.constant;
    size += glm::length(w_.normal);
    at_eye += std::fabs(w_.at(eye_));
  }
  const double length = glm::length(normal);
  ClipPlane plane;
  plane.is_everywhere =
      !(length >= kLeastLength && length > kVanishing * size && std::fabs(constant) <= kFarthestPlane * length);
  if (plane.is_everywhere) return plane;
  plane.normal = without_negligible(normal / length);
  plane.offset = constant / length;
  plane.margin = kDepthMargin * (size / length);
  plane.error =
      0x1p-48 * (sum_of(eye_) + depth + std::fabs(plane.offset)) + kDepthMargin * ((size * depth + at_eye) / length);
  return plane;
}

std::array<ClipPlane, 6> MatrixEye::planes(double depth) const {
  return {plane({x_, 1, true}, depth),  plane({x_, -1, true}, depth), plane({y_, 1, true}, depth),
          plane({y_, -1, true}, depth), plane(near_row(), depth),     plane(far_row(), depth)};
}

}  // namespace occlude::culler
