// SPDX-License-Identifier: MIT
// With weights l_i >= 0 of the occluder's vertices v_i and k_j >= 0 of the region's corners e_j, x is in the penumbra when
//   x = sum l_i v_i - sum k_j e_j, sum l_i = 1 + sum k_j,   or   x = sum l_i v_i + sum k_j e_j, sum l_i = 1
// for directions of view. With one corner this is its shadow, and the umbra is what satisfies it for every corner. No plane
// is computed.
#include <CGAL/Gmpzf.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>

#include <algorithm>
#include <array>
#include <vector>

#include "occlude/oracle/second.h"
#include "points.h"

namespace occlude::oracle::second {
namespace {

using Weight = CGAL::Gmpzf;
using WeightedPoint = std::array<Weight, 3>;

/// A box as {start + sum u_k directions[k] : 0 <= u <= 1}. A point has no directions.
struct Parallelepiped {
  WeightedPoint start{};
  std::vector<WeightedPoint> directions;

  [[nodiscard]] WeightedPoint corner(unsigned bits) const {
    WeightedPoint x = start;
    for (std::size_t k = 0; k < directions.size(); ++k) {
      for (std::size_t axis = 0; axis < 3 && (bits >> k & 1U) != 0; ++axis) x[axis] += directions[k][axis];
    }
    return x;
  }
};

Parallelepiped parallelepiped(const Obb& box) {
  Parallelepiped result{{box.center[0], box.center[1], box.center[2]}, {}};
  for (const Point& half_edge : box.half_edges) {
    if (half_edge == Point{}) continue;
    WeightedPoint& direction = result.directions.emplace_back();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      result.start[axis] -= Weight(half_edge[axis]);
      direction[axis] = Weight(half_edge[axis]) + Weight(half_edge[axis]);
    }
  }
  return result;
}

Parallelepiped parallelepiped(const Aabb& box) {
  Parallelepiped result{{box.min[0], box.min[1], box.min[2]}, {}};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    WeightedPoint& direction = result.directions.emplace_back();
    direction[axis] = Weight(box.max[axis]) - Weight(box.min[axis]);
  }
  return result;
}

std::vector<WeightedPoint> all_corners(const Parallelepiped& box) {
  std::vector<WeightedPoint> corners;
  for (unsigned bits = 0; bits < 1U << box.directions.size(); ++bits) corners.push_back(box.corner(bits));
  return corners;
}

/// Which viewpoints each condition on x is about: each alone, or all together.
using Viewpoints = std::vector<std::vector<WeightedPoint>>;

/// Whether some point of the box satisfies all conditions.
bool some_point_satisfies(const Viewpoints& conditions, bool at_infinity, const std::vector<Point>& vertices,
                          const Parallelepiped& box) {
  constexpr int kRows = 4;  // of a condition: the coordinates of x, the sum of the weights
  CGAL::Quadratic_program<Weight> programme(CGAL::EQUAL, true, 0, false, 0);
  int column = 0;
  const auto set = [&](int at, int row, const WeightedPoint& p, int sign) {
    for (int axis = 0; axis < 3; ++axis) programme.set_a(at, row + axis, Weight(sign) * p[static_cast<std::size_t>(axis)]);
  };
  for (std::size_t k = 0; k < box.directions.size(); ++k) programme.set_u(column++, true, 1);
  for (std::size_t c = 0; c < conditions.size(); ++c) {
    const int row = static_cast<int>(c) * kRows;
    for (int axis = 0; axis < 3; ++axis) programme.set_b(row + axis, box.start[static_cast<std::size_t>(axis)]);
    programme.set_b(row + 3, 1);
    for (std::size_t k = 0; k < box.directions.size(); ++k) set(static_cast<int>(k), row, box.directions[k], -1);
    for (const Point& v : vertices) {
      set(column, row, {v[0], v[1], v[2]}, 1);
      programme.set_a(column++, row + 3, 1);
    }
    for (const WeightedPoint& viewpoint : conditions[c]) {
      set(column, row, viewpoint, at_infinity ? 1 : -1);
      programme.set_a(column++, row + 3, at_infinity ? 0 : -1);
    }
  }
  CGAL::Quadratic_program_options options;
  options.set_pricing_strategy(CGAL::QP_BLAND);  // Bland's rule cannot cycle, even in degenerate cases
  return !CGAL::solve_linear_program(programme, Weight(), options).is_infeasible();
}

}  // namespace

Answer relation(const ViewRegion& region, const Occluder& occluder, ShadowKind kind, const Box& box) {
  const std::vector<WeightedPoint> corners = all_corners(parallelepiped(region.box));
  Viewpoints conditions{corners};
  if (kind == ShadowKind::umbra) {
    conditions.clear();
    for (const WeightedPoint& corner : corners) conditions.push_back({corner});
  }
  const auto satisfies = [&](const Viewpoints& some, const Parallelepiped& part) {
    return some_point_satisfies(some, region.at_infinity, vertices_of(occluder), part);
  };
  const auto satisfies_each = [&](const Parallelepiped& part) {
    return std::ranges::all_of(conditions, [&](const auto& condition) { return satisfies({condition}, part); });
  };
  // A point that satisfies each condition satisfies all. Of a box this is asked first because small programs are fast.
  const auto is_within = [&](const WeightedPoint& x) { return satisfies_each({x, {}}); };
  const Parallelepiped whole = std::visit([](const auto& shape) { return parallelepiped(shape); }, box);
  const std::vector<WeightedPoint> points = all_corners(whole);
  if (std::ranges::all_of(points, is_within)) return {"", Relation::inside};
  const bool is_met = std::ranges::any_of(points, is_within) || (satisfies_each(whole) && satisfies(conditions, whole));
  return {"", is_met ? Relation::partial : Relation::outside};
}

}  // namespace occlude::oracle::second
