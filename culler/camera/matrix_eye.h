// SPDX-License-Identifier: MIT
// The eye, the axes and the planes of a camera that is a matrix, and bounds of their errors.
#pragma once

#include <array>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <string_view>

#include "occlude/culler/camera.h"

namespace occlude::culler {

/// A row of a matrix: the function normal . p + constant of points p.
struct MatrixRow {
  glm::dvec3 normal{0, 0, 0};
  double constant = 0;

  [[nodiscard]] double at(const glm::dvec3& p) const { return glm::dot(normal, p) + constant; }
  /// Bounds the rounding of at(): four roundings of each term, 2^-53 each, with room.
  [[nodiscard]] double error_at(const glm::dvec3& p) const;
};

/// A half-space of the clip volume, divided by the length of its normal. A renderer in single precision, and this program in
/// double precision, may take normal . p + offset for up to `error` more or less than it is, for every point p of the model.
struct ClipPlane {
  glm::dvec3 normal{0, 0, 0};  ///< legal for the kernel; length 1, up to rounding
  double offset = 0;
  double error = 0;
  double margin = 0;           ///< of the error, the part for each unit of depth that is for single precision
  bool is_everywhere = false;  ///< cuts off nothing of any model; the other members are not set
};

/// What follows from a matrix. If fault() is not empty, the other members mean nothing.
class MatrixEye {
 public:
  explicit MatrixEye(const MatrixCamera& camera);

  [[nodiscard]] std::string_view fault() const { return fault_; }

  [[nodiscard]] bool is_perspective() const { return is_perspective_; }
  [[nodiscard]] const glm::dvec3& eye() const { return eye_; }
  [[nodiscard]] const Camera::Axes& axes() const { return axes_; }
  /// As in FrameView.
  [[nodiscard]] double half_width() const { return half_width_; }
  [[nodiscard]] double half_height() const { return half_height_; }
  [[nodiscard]] double height() const { return height_; }
  /// Bounds how far points within `depth` of the eye would have to be moved for the eye and the direction to be exact.
  [[nodiscard]] double moved(double depth) const;

  /// Left, right, bottom, top, near, far, for a model within `depth` of the eye. The near plane is not everywhere.
  [[nodiscard]] std::array<ClipPlane, 6> planes(double depth) const;
  static constexpr std::size_t kNear = 4;

  /// A vector with these coordinates along the axes, and a bound of its error.
  struct Vector {
    glm::dvec3 value;
    double error;
  };
  [[nodiscard]] Vector vector(double right, double up, double forward) const;

 private:
  [[nodiscard]] std::string_view find(const MatrixCamera& camera);
  [[nodiscard]] std::string_view find_perspective();
  [[nodiscard]] std::string_view find_parallel(Nearer nearer);
  /// sign * row, or w + sign * row.
  struct Sum {
    const MatrixRow& row;
    double sign;
    bool with_w;
  };
  [[nodiscard]] Sum near_row() const;
  [[nodiscard]] Sum far_row() const;
  [[nodiscard]] ClipPlane plane(const Sum& sum, double depth) const;

  MatrixRow x_, y_, z_, w_;
  ClipDepth depth_;
  std::string_view fault_;
  bool is_perspective_ = true;
  bool is_reversed_ = false;
  glm::dvec3 eye_{0, 0, 0};
  Camera::Axes axes_{};
  double half_width_ = 1, half_height_ = 1, height_ = 2;
  double eye_error_ = 0;        ///< a length
  double direction_error_ = 0;  ///< a tangent
  double bend_ = 0;             ///< with parallel rays, the relative change of w for each unit of length
};

}  // namespace occlude::culler
