// SPDX-License-Identifier: MIT
// Whether an intersection of half-spaces, which is not empty, misses a box. Nothing is known of its edges and corners.
//
// In the box's own coordinates u, |u_k| <= 1, plane i is m_i + a_i . u >= 0. By Farkas' lemma the two sets are disjoint
// exactly when some sum of the planes with weights >= 0 is negative on the whole box. The largest value on the box is
// m + sum_k |a_k|. It is linear in the weights as long as no a_k changes its sign. So it is enough to try the weights at the
// corners of these ranges: one plane, which is stage 1 (box_plane.h); two planes, whose a_k cancel on one axis; three
// planes, which do so on two axes. Four planes that cancel on all three axes would have a negative sum everywhere, and the
// intersection would be empty. Planes that do not cut the box are left out first: without them the intersection is larger,
// but has the same points of the box.
#pragma once

#include <array>
#include <cstddef>
#include <memory_resource>
#include <vector>

#include "plane_coefficients.h"
#include "scratch.h"

namespace occlude::kernel {

/// A plane over a box: its value at the middle, and the most that it changes along each of the box's own axes.
template <class Number>
struct PlaneOverBox {
  Number middle;
  Vector3<Number> along;
};

template <class A>
[[nodiscard]] PlaneOverBox<typename A::Number> over_box(const PlaneCoefficients<A>& plane, const Vec3& origin,
                                                        const Obb& box) {
  const auto along = [&](std::size_t k) { return dot(plane.normal, constants<A>(box.half_edges[k])); };
  return {dot(plane.normal, difference<A>(box.center, origin)) + plane.offset, {along(0), along(1), along(2)}};
}
/// Twice the values, because the middle of the box need not be a double.
template <class A>
[[nodiscard]] PlaneOverBox<typename A::Number> over_box(const PlaneCoefficients<A>& plane, const Vec3& origin,
                                                        const Aabb& box) {
  const auto along = [&](int k) { return plane.normal[k] * A::difference(box.max[k], box.min[k]); };
  const auto twice_middle = difference<A>(box.min, origin) + difference<A>(box.max, origin);
  return {dot(plane.normal, twice_middle) + (plane.offset + plane.offset), {along(0), along(1), along(2)}};
}

/// Whether two or three planes together separate the box. `arithmetic` may not be able to tell some signs: then `true` is
/// certain, and `false` is not.
template <class A>
class Separation {
 public:
  using Number = typename A::Number;

  template <class Box>
  Separation(A& arithmetic, const StoredFrustum& planes, const Box& box) : arithmetic_(arithmetic) {
    for (std::size_t i = 0; i < planes.plane_count; ++i) {
      const auto plane = over_box(coefficients<A>(planes, planes.recipes[i]), planes.origin, box);
      const Number spread = magnitude(plane.along.x) + magnitude(plane.along.y) + magnitude(plane.along.z);
      if (arithmetic_.sign(plane.middle - spread) > 0) continue;  // it cuts off nothing of the box
      planes_.push_back(plane);
      const auto sign = [&](int k) { return arithmetic_.sign(plane.along[k]); };
      signs_.push_back({sign(0), sign(1), sign(2)});
    }
  }

  [[nodiscard]] bool exists() {
    for (int k = 0; k < 3; ++k) {
      if (is_by_two(k) || is_by_three(k, (k + 1) % 3)) return true;
    }
    return false;
  }

 private:
  [[nodiscard]] bool is_by_two(int k) {
    for (std::size_t i = 1; i < planes_.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        if (sign(i, k) * sign(j, k) >= 0) continue;
        const Number of_i = magnitude(planes_[j].along[k]), of_j = magnitude(planes_[i].along[k]);
        const auto sum = [&](const Number& a, const Number& b) { return of_i * a + of_j * b; };
        const auto spread = [&](int axis) { return magnitude(sum(planes_[i].along[axis], planes_[j].along[axis])); };
        const Number high = sum(planes_[i].middle, planes_[j].middle) + (spread((k + 1) % 3) + spread((k + 2) % 3));
        if (arithmetic_.sign(high) < 0) return true;
      }
    }
    return false;
  }

  /// The weights of three planes whose sum changes along neither k nor l are minors. They have one sign, or there are none.
  [[nodiscard]] bool is_by_three(int k, int l) {
    const int rest = 3 - k - l;
    const auto minor = [&](std::size_t i, std::size_t j) {
      return planes_[i].along[k] * planes_[j].along[l] - planes_[j].along[k] * planes_[i].along[l];
    };
    for (std::size_t i = 2; i < planes_.size(); ++i) {
      for (std::size_t j = 1; j < i; ++j) {
        const Number of_rest = minor(i, j);
        const int turn = arithmetic_.sign(of_rest);
        for (std::size_t m = 0; turn != 0 && m < j; ++m) {
          const Number of_i = minor(j, m), of_j = minor(m, i);
          if (arithmetic_.sign(of_i) != turn || arithmetic_.sign(of_j) != turn) continue;
          const Number middle = of_i * planes_[i].middle + of_j * planes_[j].middle + of_rest * planes_[m].middle;
          const Number along =
              of_i * planes_[i].along[rest] + of_j * planes_[j].along[rest] + of_rest * planes_[m].along[rest];
          if (arithmetic_.sign((turn > 0 ? middle : -middle) + magnitude(along)) < 0) return true;
        }
      }
    }
    return false;
  }

  [[nodiscard]] int sign(std::size_t i, int k) const { return signs_[i][static_cast<std::size_t>(k)]; }
  static Number magnitude(const Number& x) { return A::magnitude(x); }

  A& arithmetic_;
  Scratch scratch_;
  std::pmr::vector<PlaneOverBox<Number>> planes_{&scratch_.memory()};
  std::pmr::vector<std::array<int, 3>> signs_{&scratch_.memory()};
};

}  // namespace occlude::kernel
