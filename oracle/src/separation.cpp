// SPDX-License-Identifier: MIT
// A linear programme finds a normal that has some points of each ball on the right side, rounded to doubles: at first its
// middle, then its lowest points along the normals that failed. Whether a normal, rounded too, is one for the balls is
// checked in N. Where that finds none, a programme in N decides for points.
#include "separation.h"

#include <algorithm>
#include <cmath>

#include "feasibility.h"

namespace occlude::oracle {
namespace {

/// Each normal that fails leaves a fraction of the directions that were left. After this many that is no more than rounding.
constexpr int kMostNormals = 64;

/// Of the normals with coordinates between -1 and 1, the one that leaves the largest gap.
template <class N>
std::optional<Ratios<N, 3>> normal_below(const std::vector<Vector<N>>& points) {
  std::vector<Inequality<N, 3>> strict;
  for (const Vector<N>& x : points) strict.push_back({{-x.x(), -x.y(), -x.z()}, N(0)});
  return feasible_point<N>({{N(-1), N(-1), N(-1)}, {N(1), N(1), N(1)}}, {}, strict);
}

std::optional<Point> rounded_normal_below(const std::vector<Point>& points) {
  return decide([&]<class N>() -> std::optional<Point> {
    std::vector<Vector<N>> vectors;
    for (const Point& x : points) vectors.push_back(vector_of<N>(x));
    const auto found = normal_below<N>(vectors);
    if (!found) return std::nullopt;
    const auto coordinate = [&](std::size_t k) { return CGAL::to_double(found->x[k]) / CGAL::to_double(found->w); };
    const Point normal{coordinate(0), coordinate(1), coordinate(2)};
    return std::isfinite(normal[0] + normal[1] + normal[2]) ? std::optional(normal) : std::nullopt;
  });
}

template <class N>
bool is_below(const Point& normal, const Around<N>& ball) {
  const Vector<N> n = vector_of<N>(normal);
  const N height = n * ball.center;
  return certain_sign(height) == CGAL::POSITIVE &&
         certain_sign(N(height * height - ball.radius * ball.radius * (n * n))) == CGAL::POSITIVE;
}

template <class N>
bool is_round(const Around<N>& ball) {
  return CGAL::to_double(ball.radius) > 0;
}

/// The lowest point of the ball along the normal, or its middle for a normal of zero, scaled to numbers that neither
/// overflow nor vanish.
template <class N>
Point lowest(const Around<N>& ball, const Point& normal) {
  const double length = std::hypot(normal[0], normal[1], normal[2]);
  const double share = length > 0 ? CGAL::to_double(ball.radius) / length : 0;
  Point x{};
  for (std::size_t k = 0; k < 3; ++k) x[k] = CGAL::to_double(ball.center[static_cast<int>(k)]) - share * normal[k];
  const double size = std::max({std::abs(x[0]), std::abs(x[1]), std::abs(x[2])});
  return size > 0 && std::isfinite(size) ? Point{x[0] / size, x[1] / size, x[2] / size} : Point{};
}

}  // namespace

template <class N>
Separation separate(const std::vector<Around<N>>& balls) {
  std::vector<Point> points;
  for (const Around<N>& ball : balls) points.push_back(lowest(ball, {}));
  for (int i = 0; i < kMostNormals; ++i) {
    const std::optional<Point> normal = rounded_normal_below(points);
    if (!normal) break;
    const std::size_t before = points.size();
    bool is_below_all = true;
    for (const Around<N>& ball : balls) {
      if (is_below(*normal, ball)) continue;
      is_below_all = false;
      if (is_round(ball)) points.push_back(lowest(ball, *normal));
    }
    if (is_below_all) return {true, normal};
    if (points.size() == before) break;
  }
  if (std::ranges::any_of(balls, is_round<N>)) return {};
  std::vector<Vector<N>> centers;
  for (const Around<N>& ball : balls) centers.push_back(ball.center);
  return {normal_below<N>(centers).has_value(), std::nullopt};
}

template Separation separate<Interval>(const std::vector<Around<Interval>>&);
template Separation separate<Exact>(const std::vector<Around<Exact>>&);

}  // namespace occlude::oracle
