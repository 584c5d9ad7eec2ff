// SPDX-License-Identifier: MIT
//
// Seidel's incremental linear programming. Keep the lowest point (by a linear cost) of the inequalities seen so far; one
// that the point violates holds with equality at the new lowest point, if there is any, which leaves the same question in
// one variable fewer.
#include "feasibility.h"

#include <algorithm>
#include <optional>
#include <random>
#include <span>

namespace occlude::oracle {
namespace {

template <std::size_t D>
using Tuple = std::array<Exact, D>;

template <std::size_t D>
Exact dot(const Tuple<D>& a, const Tuple<D>& b) {
  Exact sum = 0;
  for (std::size_t i = 0; i < D; ++i) sum += a[i] * b[i];
  return sum;
}

/// `tuple` without its element `k`.
template <std::size_t D>
Tuple<D - 1> without(const Tuple<D>& tuple, std::size_t k) {
  Tuple<D - 1> rest;
  for (std::size_t i = 0; i + 1 < D; ++i) rest[i] = tuple[i < k ? i : i + 1];
  return rest;
}

/// The plane a . x = b, solved for the variable `k` in which a is not zero.
template <std::size_t D>
struct Plane {
  const Inequality<D>& equation;
  std::size_t k;

  /// `row` . x written in the other variables; what is left over times b of the plane is the constant.
  [[nodiscard]] Tuple<D - 1> project(const Tuple<D>& row) const {
    const Exact factor = row[k] / equation.a[k];
    Tuple<D - 1> rest = without<D>(row, k);
    const Tuple<D - 1> own = without<D>(equation.a, k);
    for (std::size_t i = 0; i + 1 < D; ++i) rest[i] -= factor * own[i];
    return rest;
  }

  [[nodiscard]] Inequality<D - 1> project(const Inequality<D>& row) const {
    return {project(row.a), row.b - row.a[k] / equation.a[k] * equation.b};
  }

  /// The point of the plane with the other variables `rest`.
  [[nodiscard]] Tuple<D> lift(const Tuple<D - 1>& rest) const {
    const Exact left = equation.b - dot<D - 1>(without<D>(equation.a, k), rest);
    Tuple<D> x;
    for (std::size_t i = 0; i < D; ++i) x[i] = i == k ? Exact(left / equation.a[k]) : rest[i < k ? i : i - 1];
    return x;
  }
};

template <std::size_t D>
Inequality<D> axis_bound(std::size_t k, int sign, const Exact& bound) {
  Inequality<D> row{{}, sign * bound};
  row.a[k] = sign;
  return row;
}

std::optional<Tuple<1>> lowest(const Bounds<1>& bounds, std::span<const Inequality<1>> rows, const Tuple<1>& cost) {
  Exact low = bounds.low[0], high = bounds.high[0];
  for (const Inequality<1>& row : rows) {
    if (row.a[0] > 0) high = std::min(high, Exact(row.b / row.a[0]));
    if (row.a[0] < 0) low = std::max(low, Exact(row.b / row.a[0]));
    if (row.a[0] == 0 && row.b < 0) return std::nullopt;
  }
  if (low > high) return std::nullopt;
  return Tuple<1>{cost[0] >= 0 ? low : high};
}

template <std::size_t D>
std::optional<Tuple<D>> lowest(const Bounds<D>& bounds, std::span<const Inequality<D>> rows, const Tuple<D>& cost);

/// The lowest point of the plane of `rows[last]` within the bounds and the rows before it.
template <std::size_t D>
std::optional<Tuple<D>> lowest_on_plane(const Bounds<D>& bounds, std::span<const Inequality<D>> rows, std::size_t last,
                                        const Tuple<D>& cost) {
  const auto& a = rows[last].a;
  const auto pivot = std::ranges::find_if(a, [](const Exact& value) { return value != 0; });
  if (pivot == a.end()) return std::nullopt;  // 0 <= b, and it was violated
  const Plane<D> plane{rows[last], static_cast<std::size_t>(pivot - a.begin())};

  std::vector<Inequality<D - 1>> projected;
  projected.push_back(plane.project(axis_bound<D>(plane.k, 1, bounds.high[plane.k])));
  projected.push_back(plane.project(axis_bound<D>(plane.k, -1, bounds.low[plane.k])));
  for (const Inequality<D>& row : rows.first(last)) projected.push_back(plane.project(row));

  const Bounds<D - 1> rest{without<D>(bounds.low, plane.k), without<D>(bounds.high, plane.k)};
  const auto point = lowest(rest, std::span<const Inequality<D - 1>>(projected), plane.project(cost));
  return point ? std::optional(plane.lift(*point)) : std::nullopt;
}

template <std::size_t D>
std::optional<Tuple<D>> lowest(const Bounds<D>& bounds, std::span<const Inequality<D>> rows, const Tuple<D>& cost) {
  std::optional<Tuple<D>> x = Tuple<D>{};
  for (std::size_t i = 0; i < D; ++i) (*x)[i] = cost[i] >= 0 ? bounds.low[i] : bounds.high[i];
  for (std::size_t i = 0; i < rows.size() && x; ++i) {
    if (dot<D>(rows[i].a, *x) > rows[i].b) x = lowest_on_plane(bounds, rows, i, cost);
  }
  return x;
}

}  // namespace

bool is_feasible(const Bounds<3>& bounds, std::vector<Inequality<3>> inequalities) {
  // A random order makes the expected time linear; a fixed seed makes it the same every time.
  std::shuffle(inequalities.begin(), inequalities.end(), std::minstd_rand(1));
  return lowest<3>(bounds, inequalities, {1, 1, 1}).has_value();
}

}  // namespace occlude::oracle
