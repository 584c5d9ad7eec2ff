// SPDX-License-Identifier: MIT
#include "occlude/oracle/ray.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>

#include "numbers.h"

namespace occlude::oracle {
namespace {

/// Origin and direction in N. Nothing but the difference of doubles is computed for them.
template <class N>
struct Line {
  Vector<N> from, along;
  bool is_eye;  ///< only what is ahead counts
};

template <class N>
Vector<N> normal_of(const Triangle& t) {
  return CGAL::cross_product(difference<N>(t[0], t[1]), difference<N>(t[0], t[2]));
}

bool has_area(const Triangle& t) {
  return sign_of([&]<class N>() -> N { return normal_of<N>(t).squared_length(); }) == CGAL::POSITIVE;
}

/// The line meets a plane at from + (distance / speed) along, speed > 0.
template <class N>
struct Crossing {
  N distance, speed;
  bool is_within;  ///< the borders of the triangle
};

/// Where the line crosses the triangle, its borders counted; none if it does not. A line in the plane of the triangle
/// crosses it nowhere, and sets `is_in_plane`. Throws as certain_sign() does.
template <class N>
std::optional<Crossing<N>> crossing(const Line<N>& line, const Triangle& triangle, bool& is_in_plane) {
  std::array<Vector<N>, 3> to;
  for (std::size_t i = 0; i < 3; ++i) to[i] = vector_of<N>(triangle[i]) - line.from;
  std::array<CGAL::Sign, 3> turns{};
  N speed(0);
  for (std::size_t i = 0; i < 3; ++i) {
    const N turn = line.along * CGAL::cross_product(to[i], to[(i + 1) % 3]);
    turns[i] = certain_sign(turn);
    speed += turn;
  }
  const bool is_left = std::ranges::count(turns, CGAL::POSITIVE) > 0,
             is_right = std::ranges::count(turns, CGAL::NEGATIVE) > 0;
  is_in_plane = !is_left && !is_right;
  if (is_left == is_right) return std::nullopt;
  N distance = to[0] * CGAL::cross_product(to[1], to[2]);
  if (is_right) {
    distance = -distance;
    speed = -speed;
  }
  if (line.is_eye && certain_sign(distance) != CGAL::POSITIVE) return std::nullopt;
  return Crossing<N>{distance, speed, std::ranges::count(turns, CGAL::ZERO) == 0};
}

/// The side of a half-space on which a crossing is.
template <class N>
CGAL::Sign side(const HalfSpaceCoefficients& half_space, const Line<N>& line, const Crossing<N>& at) {
  const Vector<N> normal{N(half_space[0]), N(half_space[1]), N(half_space[2])};
  return certain_sign(N((normal * line.from + N(half_space[3])) * at.speed + at.distance * (normal * line.along)));
}

template <class N>
Line<N> line_of(const Point& from, const Point& to, bool is_eye) {
  return {vector_of<N>(from), is_eye ? difference<N>(from, to) : vector_of<N>(to), is_eye};
}

}  // namespace

Ray::Ray(const Viewpoint& view, const Point& through)
    : from_(view.at_infinity ? through : view.value),
      to_(view.at_infinity ? view.value : through),
      is_eye_(!view.at_infinity) {}

bool Ray::enters(const Triangle& triangle, std::span<const HalfSpaceCoefficients> within) const {
  const RoundUpward rounding;
  return decide([&]<class N>() {
    const Line<N> line = line_of<N>(from_, to_, is_eye_);
    bool is_in_plane = false;
    const std::optional<Crossing<N>> at = crossing(line, triangle, is_in_plane);
    return at && at->is_within && std::ranges::all_of(within, [&](const HalfSpaceCoefficients& half_space) {
             return side(half_space, line, *at) == CGAL::POSITIVE;
           });
  });
}

Ray::Order Ray::order(const Triangle& triangle, const Triangle& other, const HalfSpaceCoefficients& drawn) const {
  const RoundUpward rounding;
  if (!has_area(other)) return Order::apart;
  return decide([&]<class N>() {
    const Line<N> line = line_of<N>(from_, to_, is_eye_);
    bool is_in_plane = false;
    const std::optional<Crossing<N>> at = crossing(line, other, is_in_plane);
    if (is_in_plane) return Order::nearer;
    if (!at || side(drawn, line, *at) == CGAL::NEGATIVE) return Order::apart;
    const std::optional<Crossing<N>> end = crossing(line, triangle, is_in_plane);
    switch (certain_sign(N(at->distance * end->speed - end->distance * at->speed))) {
      case CGAL::NEGATIVE:
        return Order::nearer;
      case CGAL::ZERO:
        return Order::same;
      default:
        return Order::farther;
    }
  });
}

}  // namespace occlude::oracle
