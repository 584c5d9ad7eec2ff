// SPDX-License-Identifier: MIT
// Seidel's incremental linear programming. It keeps the point of lowest linear cost that satisfies the inequalities seen so
// far. If that point violates the next inequality, the new lowest point satisfies it with equality, or there is none. This
// leaves the same question with one variable fewer. Nothing is divided: an inequality may be multiplied by any positive
// number, and the coordinates of a point share a denominator.
#include "feasibility.h"

#include <algorithm>
#include <optional>
#include <random>
#include <span>

namespace occlude::oracle {
namespace {

template <class N, std::size_t D>
using Tuple = std::array<N, D>;

template <class N, std::size_t D>
N dot(const Tuple<N, D>& a, const Tuple<N, D>& b) {
  N sum = a[0] * b[0];
  for (std::size_t i = 1; i < D; ++i) sum += a[i] * b[i];
  return sum;
}

/// `tuple` without its element `k`.
template <class N, std::size_t D>
Tuple<N, D - 1> without(const Tuple<N, D>& tuple, std::size_t k) {
  Tuple<N, D - 1> rest;
  for (std::size_t i = 0; i + 1 < D; ++i) rest[i] = tuple[i < k ? i : i + 1];
  return rest;
}

/// Whether the point satisfies the inequality.
template <class N, std::size_t D>
bool satisfies(const Ratios<N, D>& point, const Inequality<N, D>& row) {
  return certain_sign(dot(row.a, point.x) - row.b * point.w) != CGAL::POSITIVE;
}

/// The plane a . x = b, solved for variable `k`, whose coefficient is not zero.
template <class N, std::size_t D>
struct Pivot {
  const Inequality<N, D>& plane;
  std::size_t k;
  N size;   ///< |a[k]|
  N other;  ///< -sign(a[k])

  Pivot(const Inequality<N, D>& equation, std::size_t variable, CGAL::Sign sign)
      : plane(equation), k(variable), size(N(int{sign}) * equation.a[variable]), other(-int{sign}) {}

  /// The coefficients of size * (row . x) in the other variables, for x on the plane. This leaves out the constant term, a
  /// multiple of b of the plane.
  [[nodiscard]] Tuple<N, D - 1> project(const Tuple<N, D>& row) const {
    const N factor = other * row[k];
    Tuple<N, D - 1> rest = without(row, k);
    const Tuple<N, D - 1> own = without(plane.a, k);
    for (std::size_t i = 0; i + 1 < D; ++i) rest[i] = size * rest[i] + factor * own[i];
    return rest;
  }

  [[nodiscard]] Inequality<N, D - 1> project(const Inequality<N, D>& row) const {
    return {project(row.a), size * row.b + other * row.a[k] * plane.b};
  }

  /// The point on the plane whose other variables are `rest`.
  [[nodiscard]] Ratios<N, D> lift(const Ratios<N, D - 1>& rest) const {
    const N left = other * (dot(without(plane.a, k), rest.x) - plane.b * rest.w);
    Ratios<N, D> point{{}, size * rest.w};
    for (std::size_t i = 0; i < D; ++i) point.x[i] = i == k ? left : N(size * rest.x[i < k ? i : i - 1]);
    return point;
  }
};

template <class N, std::size_t D>
Inequality<N, D> axis_bound(std::size_t k, int sign, const N& bound) {
  Inequality<N, D> row{{}, N(sign) * bound};
  row.a.fill(N(0));
  row.a[k] = N(sign);
  return row;
}

template <class N>
bool is_less(const Ratios<N, 1>& p, const Ratios<N, 1>& q) {
  return certain_sign(p.x[0] * q.w - q.x[0] * p.w) == CGAL::NEGATIVE;
}

template <class N>
std::optional<Ratios<N, 1>> lowest(const Bounds<N, 1>& bounds, std::span<const Inequality<N, 1>> rows,
                                   const Tuple<N, 1>& cost) {
  Ratios<N, 1> low{bounds.low, N(1)}, high{bounds.high, N(1)};
  for (const auto& [a, b] : rows) {
    const CGAL::Sign sign = certain_sign(a[0]);
    if (sign == CGAL::ZERO && certain_sign(b) == CGAL::NEGATIVE) return std::nullopt;
    if (sign == CGAL::POSITIVE) high = std::min(high, {{b}, a[0]}, is_less<N>);
    if (sign == CGAL::NEGATIVE) low = std::max(low, {{-b}, -a[0]}, is_less<N>);
  }
  if (is_less(high, low)) return std::nullopt;
  return certain_sign(cost[0]) == CGAL::NEGATIVE ? high : low;
}

template <class N, std::size_t D>
std::optional<Ratios<N, D>> lowest(const Bounds<N, D>& bounds, std::span<const Inequality<N, D>> rows,
                                   const Tuple<N, D>& cost);

/// The lowest point on the plane of `rows[last]` within the bounds and the rows before it. Empty when there is none.
template <class N, std::size_t D>
std::optional<Ratios<N, D>> lowest_on_plane(const Bounds<N, D>& bounds, std::span<const Inequality<N, D>> rows,
                                            std::size_t last, const Tuple<N, D>& cost) {
  std::size_t k = 0;
  while (k < D && certain_sign(rows[last].a[k]) == CGAL::ZERO) ++k;
  if (k == D) return std::nullopt;  // the row is 0 <= b, and it is violated, so b < 0
  const Pivot<N, D> pivot(rows[last], k, certain_sign(rows[last].a[k]));

  std::vector<Inequality<N, D - 1>> projected;
  projected.reserve(last + 2);
  projected.push_back(pivot.project(axis_bound<N, D>(k, 1, bounds.high[k])));
  projected.push_back(pivot.project(axis_bound<N, D>(k, -1, bounds.low[k])));
  for (const Inequality<N, D>& row : rows.first(last)) projected.push_back(pivot.project(row));

  const Bounds<N, D - 1> rest{without(bounds.low, k), without(bounds.high, k)};
  const auto point = lowest(rest, std::span<const Inequality<N, D - 1>>(projected), pivot.project(cost));
  return point ? std::optional(pivot.lift(*point)) : std::nullopt;
}

template <class N, std::size_t D>
std::optional<Ratios<N, D>> lowest(const Bounds<N, D>& bounds, std::span<const Inequality<N, D>> rows,
                                   const Tuple<N, D>& cost) {
  std::optional point = Ratios<N, D>{{}, N(1)};
  for (std::size_t i = 0; i < D; ++i) {
    point->x[i] = certain_sign(cost[i]) == CGAL::NEGATIVE ? bounds.high[i] : bounds.low[i];
  }
  for (std::size_t i = 0; i < rows.size() && point; ++i) {
    if (!satisfies(*point, rows[i])) point = lowest_on_plane(bounds, rows, i, cost);
  }
  return point;
}

}  // namespace

template <class N>
bool is_feasible(const Bounds<N, 3>& bounds, std::vector<Inequality<N, 3>> inequalities) {
  // A random order makes the expected time linear. A fixed seed makes every run the same.
  std::shuffle(inequalities.begin(), inequalities.end(), std::minstd_rand(1));
  const Tuple<N, 3> cost{N(1), N(1), N(1)};
  return lowest(bounds, std::span<const Inequality<N, 3>>(inequalities), cost).has_value();
}

template <class N>
std::optional<Ratios<N, 3>> feasible_point(const Bounds<N, 3>& bounds, const std::vector<Inequality<N, 3>>& inequalities,
                                           const std::vector<Inequality<N, 3>>& strict) {
  // A fourth variable between 0 and 1 is the gap that every strict inequality must keep: a . x + gap <= b. The cost makes
  // the gap as large as possible. It is positive exactly when some point satisfies all strict inequalities.
  std::vector<Inequality<N, 4>> rows;
  const auto append = [&](const Inequality<N, 3>& row, int gap) {
    rows.push_back({{row.a[0], row.a[1], row.a[2], N(gap)}, row.b});
  };
  for (const Inequality<N, 3>& row : inequalities) append(row, 0);
  for (const Inequality<N, 3>& row : strict) append(row, 1);
  std::shuffle(rows.begin(), rows.end(), std::minstd_rand(1));
  const Bounds<N, 4> with_gap{{bounds.low[0], bounds.low[1], bounds.low[2], N(0)},
                              {bounds.high[0], bounds.high[1], bounds.high[2], N(1)}};
  const Tuple<N, 4> cost{N(0), N(0), N(0), N(-1)};
  const auto point = lowest(with_gap, std::span<const Inequality<N, 4>>(rows), cost);
  if (!point || (!strict.empty() && certain_sign(point->x[3]) != CGAL::POSITIVE)) return std::nullopt;
  return Ratios<N, 3>{{point->x[0], point->x[1], point->x[2]}, point->w};
}

template bool is_feasible<Interval>(const Bounds<Interval, 3>&, std::vector<Inequality<Interval, 3>>);
template bool is_feasible<Exact>(const Bounds<Exact, 3>&, std::vector<Inequality<Exact, 3>>);
template std::optional<Ratios<Interval, 3>> feasible_point<Interval>(const Bounds<Interval, 3>&,
                                                                     const std::vector<Inequality<Interval, 3>>&,
                                                                     const std::vector<Inequality<Interval, 3>>&);
template std::optional<Ratios<Exact, 3>> feasible_point<Exact>(const Bounds<Exact, 3>&,
                                                               const std::vector<Inequality<Exact, 3>>&,
                                                               const std::vector<Inequality<Exact, 3>>&);

}  // namespace occlude::oracle
