// SPDX-License-Identifier: MIT
#include "faults.h"

#include <algorithm>
#include <cmath>

namespace occlude::oracle {
namespace {

constexpr double kSmallest = 0x1p-100, kLargest = 0x1p100;

bool is_finite(double value) { return std::isfinite(value); }

bool in_range(double value) { return value == 0 || (std::abs(value) >= kSmallest && std::abs(value) <= kLargest); }

bool all_finite(std::span<const double> numbers) { return std::ranges::all_of(numbers, is_finite); }

bool has_three_distinct(std::span<const Point> loop) {
  if (loop.empty()) return false;
  const auto second = std::ranges::find_if(loop, [&](const Point& p) { return p != loop[0]; });
  return std::any_of(second, loop.end(), [&](const Point& p) { return p != loop[0] && p != *second; });
}

/// Whether the sides on which one edge has the vertices, `sides`, are those of a once-wound convex loop: one sign beside
/// zeros, and the edge's own line left only once in the whole turn.
bool supports(std::span<const CGAL::Sign> sides, CGAL::Sign turn) {
  int departures = 0;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (sides[i] == -turn) return false;
    if (sides[i] == CGAL::ZERO && sides[(i + 1) % sides.size()] != CGAL::ZERO) ++departures;
  }
  return departures <= 1;
}

/// On which side of the plane of `edge` each vertex lies. Its own two ends are on it by definition.
void find_sides(const Scene& scene, std::size_t edge, std::span<CGAL::Sign> sides) {
  Plane plane([&]<class N>() { return side_plane<N>(scene, edge); });
  for (std::size_t k = 0; k < scene.loop.size(); ++k) {
    const Point& vertex = scene.loop[k];
    const bool is_end = vertex == scene.loop[edge] || vertex == scene.next(edge);
    sides[k] = is_end ? CGAL::ZERO : plane.side(vertex);
  }
}

/// Whether every vertex lies strictly ahead of the eye, so that the eye is not in the hull of the polygon. (A convex loop
/// for which this fails is folded around a line through the eye.)
bool lies_ahead(const Scene& scene, CGAL::Sign turn) {
  Plane across([&]<class N>() { return HalfSpace<N>{vector_area<N>(scene), vector_of<N>(scene.view.value)}; });
  return std::ranges::all_of(scene.loop, [&](const Point& vertex) { return across.side(vertex) == turn; });
}

bool is_coplanar(const Scene& scene) {
  if (scene.loop.size() == 3) return true;
  Plane plane([&]<class N>() { return HalfSpace<N>{vector_area<N>(scene), vector_of<N>(scene.loop[0])}; });
  return std::ranges::all_of(scene.loop, [&](const Point& vertex) { return plane.side(vertex) == CGAL::ZERO; });
}

bool faces_viewpoint(const Scene& scene) {
  const auto ahead = [&]<class N>() -> N {
    const Vector<N> eye = vector_of<N>(scene.view.value);
    return vector_of<N>(scene.near.normal) * (scene.view.at_infinity ? eye : vector_of<N>(scene.near.point) - eye);
  };
  return sign_of(ahead) == CGAL::POSITIVE;
}

std::string plane_fault(const Scene& scene) {
  Plane plane([&]<class N>() { return HalfSpace<N>{vector_of<N>(scene.near.normal), vector_of<N>(scene.near.point)}; });
  const auto covers = [&](const Point& vertex) { return plane.side(vertex) != CGAL::POSITIVE; };
  if (!std::ranges::all_of(scene.loop, covers)) return "part of the polygon lies behind the near plane";
  return faces_viewpoint(scene) ? "" : "the near plane does not face the eye";
}

}  // namespace

std::string range_fault(std::span<const double> numbers) {
  if (!all_finite(numbers)) return "a number is not finite";
  return std::ranges::all_of(numbers, in_range) ? "" : "a coordinate is out of range";
}

std::string box_fault(const Box& box) {
  if (!all_finite(box.min) || !all_finite(box.max)) return "a number is not finite";
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (box.min[axis] > box.max[axis]) return "the box has min > max";
  }
  return "";
}

std::string number_fault(const Scene& scene, const Box& box) {
  std::string fault = range_fault(scene.view.value);
  for (const Point& vertex : scene.loop) {
    if (fault.empty()) fault = range_fault(vertex);
  }
  if (fault.empty()) fault = range_fault(box.min);
  if (fault.empty()) fault = range_fault(box.max);
  if (fault.empty()) fault = box_fault(box);
  if (fault.empty() && !(all_finite(scene.near.normal) && all_finite(scene.near.point))) fault = "a number is not finite";
  return fault;
}

Seen see_loop(const Scene& scene) {
  if (scene.view.at_infinity && scene.view.value == Point{}) return {"the direction of view is zero", CGAL::ZERO};
  if (!has_three_distinct(scene.loop)) return {"fewer than 3 distinct vertices", CGAL::ZERO};
  const std::size_t count = scene.loop.size();
  std::vector<CGAL::Sign> sides(count);
  CGAL::Sign turn = CGAL::ZERO;
  for (std::size_t edge = 0; edge < count; ++edge) {
    find_sides(scene, edge, sides);
    if (turn == CGAL::ZERO) {
      const auto off = std::ranges::find_if(sides, [](CGAL::Sign side) { return side != CGAL::ZERO; });
      if (off != sides.end()) turn = *off;
    }
    if (turn != CGAL::ZERO && !supports(sides, turn)) return {"the loop is not convex seen from the eye", CGAL::ZERO};
  }
  if (turn == CGAL::ZERO) return {"the eye lies in the polygon's plane", CGAL::ZERO};
  if (!scene.view.at_infinity && !lies_ahead(scene, turn)) return {"the eye lies in the polygon", CGAL::ZERO};
  return {"", turn};
}

std::string near_fault(const Scene& scene) {
  switch (scene.near.kind) {
    case Near::Kind::farthest:
      return "";
    case Near::Kind::surface:
      return is_coplanar(scene) ? "" : "the vertices are not coplanar: give a support plane as near";
    case Near::Kind::plane:
      return plane_fault(scene);
  }
  return "";
}

}  // namespace occlude::oracle
