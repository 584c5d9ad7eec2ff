// SPDX-License-Identifier: MIT
#include "box.h"

#include <algorithm>

#include "faults.h"

namespace occlude::oracle {
namespace {

std::array<Exact, 3> exact(const Point& p) { return {Exact(p[0]), Exact(p[1]), Exact(p[2])}; }

bool contains_point(const Aabb& box, const Point& x) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (x[k] < box.min[k] || x[k] > box.max[k]) return false;
  }
  return true;
}

/// The determinant of the half edges, with x - center in the place of number `k` when k < 3.
template <class N>
N determinant(const Obb& box, const Point& x, std::size_t k) {
  std::array<Vector<N>, 3> columns;
  for (std::size_t i = 0; i < 3; ++i) columns[i] = i == k ? difference<N>(box.center, x) : vector_of<N>(box.half_edges[i]);
  return CGAL::cross_product(columns[0], columns[1]) * columns[2];
}

/// For half edges that span a volume: by Cramer's rule each own coordinate is a ratio of determinants.
bool contains_by_ratios(const Obb& box, const Point& x) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto excess = [&]<class N>() {
      return N(CGAL::square(determinant<N>(box, x, k)) - CGAL::square(determinant<N>(box, x, 3)));
    };
    if (sign_of(excess) == CGAL::POSITIVE) return false;
  }
  return true;
}

/// For any half edges: x equals a point of the box when it is neither above nor below it on any axis.
bool contains_by_feasibility(const Obb& box, const Point& x) {
  std::vector<Inequality<3>> inequalities;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1., 1.}) {
      Point normal{};
      normal[axis] = sign;
      inequalities.push_back(in_own_coordinates({vector_of<Exact>(normal), vector_of<Exact>(x)}, box));
    }
  }
  return is_feasible(own_bounds(box), std::move(inequalities));
}

bool contains_point(const Obb& box, const Point& x) {
  const auto volume = [&]<class N>() { return determinant<N>(box, x, 3); };
  return sign_of(volume) == CGAL::ZERO ? contains_by_feasibility(box, x) : contains_by_ratios(box, x);
}

}  // namespace

Bounds<3> own_bounds(const Box& box) {
  if (const Aabb* aabb = std::get_if<Aabb>(&box)) return {exact(aabb->min), exact(aabb->max)};
  return {exact({-1, -1, -1}), exact({1, 1, 1})};
}

Inequality<3> in_own_coordinates(const HalfSpace<Exact>& half_space, const Box& box) {
  const Vector<Exact>& n = half_space.normal;
  if (std::holds_alternative<Aabb>(box)) return {{Exact(-n.x()), Exact(-n.y()), Exact(-n.z())}, -(n * half_space.point)};
  const Obb& obb = std::get<Obb>(box);
  Inequality<3> row{{}, half_space.height(obb.center)};
  for (std::size_t k = 0; k < 3; ++k) row.a[k] = -(n * vector_of<Exact>(obb.half_edges[k]));
  return row;
}

bool contains(const Box& box, const Point& point) {
  const RoundUpward rounding;
  if (!box_fault(box).empty()) return false;
  return std::visit([&](const auto& kind) { return contains_point(kind, point); }, box);
}

}  // namespace occlude::oracle
