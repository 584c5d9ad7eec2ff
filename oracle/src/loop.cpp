// SPDX-License-Identifier: MIT
#include "loop.h"

#include <algorithm>
#include <span>
#include <vector>

#include "half_spaces.h"

namespace occlude::oracle {
namespace {

bool has_three_distinct(const Loop& loop) {
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

/// On which side of the plane of the edge each vertex lies.
void find_sides(const SidePlane& edge, const Loop& loop, std::span<CGAL::Sign> sides) {
  Plane plane(edge);
  std::ranges::transform(loop, sides.begin(), [&](const Point& vertex) { return plane.side(vertex); });
}

/// Whether every vertex lies strictly ahead of the eye, so that the eye is not in the hull of the polygon. (A convex loop
/// for which this fails is folded around a line through the eye.)
bool lies_ahead(const Point& eye, const Loop& loop, CGAL::Sign turn) {
  Plane across(MeanPlane{loop, eye});
  return std::ranges::all_of(loop, [&](const Point& vertex) { return across.side(vertex) == turn; });
}

}  // namespace

std::optional<CGAL::Sign> turn_of(const Viewpoint& view, const Loop& loop) {
  std::vector<CGAL::Sign> sides(loop.size());
  CGAL::Sign turn = CGAL::ZERO;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    find_sides({view, loop[i], loop[(i + 1) % loop.size()]}, loop, sides);
    if (turn == CGAL::ZERO) {
      const auto off = std::ranges::find_if(sides, [](CGAL::Sign side) { return side != CGAL::ZERO; });
      if (off != sides.end()) turn = *off;
    }
    if (turn != CGAL::ZERO && !supports(sides, turn)) return std::nullopt;
  }
  return turn;
}

bool is_coplanar(const Loop& loop) {
  if (loop.size() == 3) return true;
  // By its numbers alone: a LoopPlane takes for granted what is asked here.
  Plane plane([&]<class N>() { return LoopPlane{loop}.operator()<N>(); });
  return std::ranges::all_of(loop, [&](const Point& vertex) { return plane.side(vertex) == CGAL::ZERO; });
}

Seen see(const Viewpoint& view, const Loop& loop) {
  if (!has_three_distinct(loop)) return {"fewer than 3 distinct vertices", CGAL::ZERO};
  const std::optional<CGAL::Sign> turn = turn_of(view, loop);
  if (!turn) return {"the loop is not convex seen from the eye", CGAL::ZERO};
  if (*turn == CGAL::ZERO) return {"the eye lies in the polygon's plane", CGAL::ZERO};
  if (!view.at_infinity && !lies_ahead(view.value, loop, *turn)) return {"the eye lies in the polygon", CGAL::ZERO};
  return {"", *turn};
}

}  // namespace occlude::oracle
