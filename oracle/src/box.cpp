// SPDX-License-Identifier: MIT
#include "box.h"

#include "faults.h"

namespace occlude::oracle {
namespace {

bool contains_point(const Aabb& box, const Point& x) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (x[k] < box.min[k] || x[k] > box.max[k]) return false;
  }
  return true;
}

/// The determinant of the half edges. When k < 3, x - center replaces half edge `k`.
template <class N>
N determinant(const Obb& box, const Point& x, std::size_t k) {
  std::array<Vector<N>, 3> columns;
  for (std::size_t i = 0; i < 3; ++i) columns[i] = i == k ? difference<N>(box.center, x) : vector_of<N>(box.half_edges[i]);
  return CGAL::cross_product(columns[0], columns[1]) * columns[2];
}

/// For half edges that span a volume. By Cramer's rule each own coordinate of x is a ratio of determinants.
bool contains_by_ratios(const Obb& box, const Point& x) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto excess = [&]<class N>() {
      return N(CGAL::square(determinant<N>(box, x, k)) - CGAL::square(determinant<N>(box, x, 3)));
    };
    if (sign_of(excess) == CGAL::POSITIVE) return false;
  }
  return true;
}

/// For any half edges. On every axis, some point of the box must be neither above nor below x. That point is x.
bool contains_by_feasibility(const Obb& box, const Point& x) {
  return decide([&]<class N>() {
    std::vector<Inequality<N, 3>> inequalities;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const double sign : {-1., 1.}) {
        Point normal{};
        normal[axis] = sign;
        inequalities.push_back(in_own_coordinates<N>({vector_of<N>(normal), vector_of<N>(x)}, box));
      }
    }
    return is_feasible<N>(own_bounds<N>(box), std::move(inequalities));
  });
}

bool contains_point(const Obb& box, const Point& x) {
  const auto volume = [&]<class N>() { return determinant<N>(box, x, 3); };
  return sign_of(volume) == CGAL::ZERO ? contains_by_feasibility(box, x) : contains_by_ratios(box, x);
}

}  // namespace

bool contains(const Box& box, const Point& point) {
  const RoundUpward rounding;
  if (!box_fault(box).empty()) return false;
  return std::visit([&](const auto& kind) { return contains_point(kind, point); }, box);
}

}  // namespace occlude::oracle
