// SPDX-License-Identifier: MIT
#include "occlude/oracle/sight.h"

#include <algorithm>
#include <array>
#include <iterator>

#include "plane.h"

namespace occlude::oracle {
namespace {

bool has_area(const Triangle& t) {
  const auto squared = [&]<class N>() -> N {
    return CGAL::cross_product(difference<N>(t[0], t[1]), difference<N>(t[0], t[2])).squared_length();
  };
  return sign_of(squared) == CGAL::POSITIVE;
}

/// Whether the segment meets the triangle strictly between its ends, in the half-space. Throws as certain_sign() does.
template <class N>
bool meets(const Triangle& triangle, const std::optional<HalfSpaceCoefficients>& drawn, const Point& eye, const Point& end) {
  const Vector<N> along = difference<N>(eye, end);
  std::array<Vector<N>, 3> to;
  for (std::size_t i = 0; i < 3; ++i) to[i] = difference<N>(eye, triangle[i]);
  std::array<CGAL::Sign, 3> turns{};
  N speed(0);  // by which the segment goes through the plane of the triangle
  for (std::size_t i = 0; i < 3; ++i) {
    const N turn = along * CGAL::cross_product(to[i], to[(i + 1) % 3]);
    turns[i] = certain_sign(turn);
    speed += turn;
  }
  const bool is_left = std::ranges::count(turns, CGAL::POSITIVE) > 0,
             is_right = std::ranges::count(turns, CGAL::NEGATIVE) > 0;
  if (is_left && is_right) return false;
  if (!is_left && !is_right) return true;
  const CGAL::Sign sign = is_left ? CGAL::POSITIVE : CGAL::NEGATIVE;
  const N distance = to[0] * CGAL::cross_product(to[1], to[2]);  // of the plane from the eye, as a multiple of `speed`
  if (certain_sign(distance) != sign || certain_sign(N(speed - distance)) != sign) return false;
  if (!drawn) return true;
  const auto [a, b, c, d] = *drawn;
  const Vector<N> normal{N(a), N(b), N(c)};
  return certain_sign(N((normal * vector_of<N>(eye) + N(d)) * speed + distance * (normal * along))) != -sign;
}

}  // namespace

Sight::Sight(std::span<const Triangle> triangles, const std::optional<HalfSpaceCoefficients>& drawn) : drawn_(drawn) {
  const RoundUpward rounding;
  std::ranges::copy_if(triangles, std::back_inserter(triangles_), has_area);
}

bool Sight::is_clear(const Point& eye, const Point& end) {
  const RoundUpward rounding;
  const auto is_met = [&](std::size_t i) {
    return decide([&]<class N>() { return meets<N>(triangles_[i], drawn_, eye, end); });
  };
  if (last_ < triangles_.size() && is_met(last_)) return false;
  for (std::size_t i = 0; i < triangles_.size(); ++i) {
    if (i == last_ || !is_met(i)) continue;
    last_ = i;
    return false;
  }
  return true;
}

}  // namespace occlude::oracle
