// SPDX-License-Identifier: MIT
// The rays from a viewpoint as points of a projective plane, in which all questions of visibility are linear.
//
// Let W = -(eye, 1), or (direction, 0) for an eye at infinity. The points of a ray are R + t W for all t. One coordinate k
// with W_k != 0 is dropped, so that R_k = 0. The three other numbers represent the ray, and a positive multiple of them is
// the same ray. The ray R meets a plane P, a linear form on (x, 1), at X = P(W) R - P(R) W. The side of a plane Q on which X
// lies is the sign of P(W) Q(R) - P(R) Q(W), which is again linear in R.
#pragma once

#include <array>
#include <cstddef>

#include "numbers.h"

namespace occlude::oracle {

/// A linear form on points (x, y, z, 1).
template <class N>
using Form = std::array<N, 4>;

class Rays {
 public:
  explicit Rays(const Viewpoint& view);

  /// The ray through a point. For an eye it is the point minus the eye.
  template <class N>
  [[nodiscard]] Vector<N> through(const Point& p) const {
    const std::array<N, 4> x{N(p[0]), N(p[1]), N(p[2]), N(1)};
    return kept<N>([&](std::size_t i) -> N { return N(scale_) * x[i] - x[dropped_] * N(towards_ * w_[i]); });
  }

  /// The value of the form at W.
  template <class N>
  [[nodiscard]] N at_viewpoint(const Form<N>& form) const {
    return form[0] * N(w_[0]) + form[1] * N(w_[1]) + form[2] * N(w_[2]) + form[3] * N(w_[3]);
  }

  /// A linear form on rays. It is positive for a ray that meets `plane` on the inner side of `other`. REQUIRES: plane(W) >
  /// 0.
  template <class N>
  [[nodiscard]] Vector<N> side_of_meeting(const Form<N>& plane, const Form<N>& other) const {
    const N p = at_viewpoint(plane), q = at_viewpoint(other);
    return kept<N>([&](std::size_t i) -> N { return p * other[i] - q * plane[i]; });
  }

 private:
  template <class N, class Coordinate>
  [[nodiscard]] Vector<N> kept(const Coordinate& coordinate) const {
    std::array<N, 3> result;
    for (std::size_t i = 0, k = 0; i < 4; ++i) {
      if (i != dropped_) result[k++] = coordinate(i);
    }
    return {result[0], result[1], result[2]};
  }

  std::array<double, 4> w_;
  std::size_t dropped_ = 3;
  double scale_ = 1, towards_ = -1;  ///< magnitude and sign of W_k
};

}  // namespace occlude::oracle
