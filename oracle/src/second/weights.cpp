// SPDX-License-Identifier: MIT
#include "weights.h"

#include <CGAL/Gmpzf.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>

#include <array>

namespace occlude::oracle::second {
namespace {

using Number = CGAL::Gmpzf;
using Programme = CGAL::Quadratic_program<Number>;

/// The rows of a programme: the three coordinates of x, the sum of the weights, the near side.
constexpr int kSum = 3, kNear = 4;

/// A box as {start + sum u_k directions[k] : low <= u <= high}.
struct OwnCoordinates {
  Point start;
  std::array<Point, 3> directions;
  Point low, high;
};

OwnCoordinates own_coordinates(const Box& box) {
  if (const Aabb* aabb = std::get_if<Aabb>(&box)) return {{}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}, aabb->min, aabb->max};
  const auto& [center, half_edges] = std::get<Obb>(box);
  return {center, half_edges, {-1, -1, -1}, {1, 1, 1}};
}

/// (to - from) . (b - a)
Number scalar_product(const Point& from, const Point& to, const Point& a, const Point& b) {
  Number sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += (Number(to[k]) - Number(from[k])) * (Number(b[k]) - Number(a[k]));
  return sum;
}

/// Sets the coordinates in column `column` to `sign` times the point.
void set_coordinates(Programme& programme, int column, const Point& point, int sign) {
  for (int k = 0; k < 3; ++k) programme.set_a(column, k, Number(sign * point[static_cast<std::size_t>(k)]));
}

/// The equations for x, without the columns of x. Columns 0 to n - 1 are the weights, column n is t.
Programme programme_of(const Viewpoint& view, std::span<const Point> vertices) {
  Programme programme(CGAL::EQUAL, true, 0, false, 0);
  const int t = static_cast<int>(vertices.size());
  for (int i = 0; i < t; ++i) {
    set_coordinates(programme, i, vertices[static_cast<std::size_t>(i)], 1);
    programme.set_a(i, kSum, 1);
  }
  set_coordinates(programme, t, view.value, view.at_infinity ? 1 : -1);
  programme.set_a(t, kSum, view.at_infinity ? 0 : -1);
  programme.set_b(kSum, 1);
  return programme;
}

bool has_solution(const Programme& programme) {
  CGAL::Quadratic_program_options options;
  options.set_pricing_strategy(CGAL::QP_BLAND);  // Bland's rule cannot cycle, even in degenerate cases
  return !CGAL::solve_linear_program(programme, Number(), options).is_infeasible();
}

}  // namespace

bool share_a_point(const Viewpoint& view, std::span<const Point> vertices, const std::optional<NearSide>& near,
                   const Box& box) {
  Programme programme = programme_of(view, vertices);
  const int t = static_cast<int>(vertices.size());
  const OwnCoordinates own = own_coordinates(box);
  for (int k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(k);
    programme.set_b(k, Number(own.start[i]));
    set_coordinates(programme, t + 1 + k, own.directions[i], -1);
    programme.set_l(t + 1 + k, true, Number(own.low[i]));
    programme.set_u(t + 1 + k, true, Number(own.high[i]));
    if (near) programme.set_a(t + 1 + k, kNear, scalar_product(near->from, near->to, {}, own.directions[i]));
  }
  if (near) {
    programme.set_l(t, false);  // x may be in front of the occluder
    programme.set_b(kNear, scalar_product(near->from, near->to, own.start, near->point));
    programme.set_r(kNear, CGAL::LARGER);
  }
  return has_solution(programme);
}

}  // namespace occlude::oracle::second
