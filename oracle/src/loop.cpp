// SPDX-License-Identifier: MIT
#include "loop.h"

#include <algorithm>

#include "half_spaces.h"

namespace occlude::oracle {
namespace {

bool has_three_distinct(const Loop& loop) {
  if (loop.empty()) return false;
  const auto second = std::ranges::find_if(loop, [&](const Point& p) { return p != loop[0]; });
  return std::any_of(second, loop.end(), [&](const Point& p) { return p != loop[0] && p != *second; });
}

/// Whether a and b are on one line through the viewpoint: an eye may also see them in opposite directions.
bool are_in_one_sight(const Viewpoint& view, const Point& a, const Point& b) {
  for (int axis = 0; axis < 3; ++axis) {
    if (sign_of([&]<class N>() { return N(SidePlane{view, a, b}.operator()<N>().normal[axis]); }) != CGAL::ZERO)
      return false;
  }
  return true;
}

/// The loop without the vertices that are on the same line of sight as the vertex before.
Loop without_repeats(const Viewpoint& view, const Loop& loop) {
  Loop result;
  for (const Point& vertex : loop) {
    if (result.empty() || !are_in_one_sight(view, result.back(), vertex)) result.push_back(vertex);
  }
  while (result.size() > 1 && are_in_one_sight(view, result.back(), result.front())) result.pop_back();
  return result;
}

/// Whether the path from a over b to c turns to the side `turn` at b or goes straight on.
bool turns(const Viewpoint& view, const Point& a, const Point& b, const Point& c, CGAL::Sign turn) {
  const SidePlane first{view, a, b}, second{view, b, c};
  const CGAL::Sign side = Plane(first).side(c);
  if (side != CGAL::ZERO) return side == turn;
  return sign_of([&]<class N>() { return N(first.operator()<N>().normal * second.operator()<N>().normal); }) ==
         CGAL::POSITIVE;
}

/// The side of the first edge on which the other vertices lie, when the loop turns to that side or goes straight on at every
/// vertex. ZERO when all vertices are on the line of the first edge. Empty when the loop does neither.
std::optional<CGAL::Sign> turn_everywhere(const Viewpoint& view, const Loop& seen) {
  if (seen.size() < 3) return CGAL::ZERO;
  CGAL::Sign turn = CGAL::ZERO;
  Plane first(SidePlane{view, seen[0], seen[1]});
  for (const Point& vertex : seen) {
    const CGAL::Sign side = first.side(vertex);
    if (side == CGAL::ZERO) continue;
    if (side == -turn) return std::nullopt;
    turn = side;
  }
  const std::size_t n = seen.size();
  for (std::size_t i = 0; i < n && turn != CGAL::ZERO; ++i) {
    if (!turns(view, seen[i], seen[(i + 1) % n], seen[(i + 2) % n], turn)) return std::nullopt;
  }
  return turn;
}

/// Whether a loop that turns to one side everywhere is wound once. In each turn it goes away from the line of its first edge
/// once and comes back once. Seen from an eye, the loop is projected onto a plane parallel to `across`. There the distance
/// of a vertex from that line is proportional to its height over the plane of the line divided by its height over `across`.
/// REQUIRES: for an eye, all vertices have heights of one sign over `across`.
bool winds_once(const Viewpoint& view, const Loop& seen, Plane<MeanPlane>& across) {
  Plane line(SidePlane{view, seen[0], seen[1]});
  const auto lead = [&](const Point& a, const Point& b) {
    return sign_of([&]<class N>() -> N {
      const N of_a = line.template in<N>().height(a), of_b = line.template in<N>().height(b);
      if (view.at_infinity) return of_b - of_a;
      return of_b * across.template in<N>().height(a) - of_a * across.template in<N>().height(b);
    });
  };
  CGAL::Sign away = CGAL::ZERO;
  bool comes_back = false;
  for (std::size_t i = 1; i < seen.size(); ++i) {
    const CGAL::Sign sign = lead(seen[i], seen[(i + 1) % seen.size()]);
    if (sign == CGAL::ZERO) continue;
    if (away == CGAL::ZERO) away = sign;
    if (sign == away && comes_back) return false;
    comes_back = sign != away;
  }
  return true;
}

/// Whether every vertex lies strictly ahead of the eye. If so, the eye is not in the hull of the polygon. If not, the convex
/// loop is folded around a line through the eye.
bool lies_ahead(Plane<MeanPlane>& across, const Loop& loop, CGAL::Sign turn) {
  return std::ranges::all_of(loop, [&](const Point& vertex) { return across.side(vertex) == turn; });
}

}  // namespace

std::optional<CGAL::Sign> turn_along(const Point& direction, const Loop& loop) {
  const Viewpoint view{direction, true};
  const Loop seen = without_repeats(view, loop);
  const std::optional<CGAL::Sign> turn = turn_everywhere(view, seen);
  if (!turn || *turn == CGAL::ZERO) return turn;
  Plane across(MeanPlane{loop, direction});
  return winds_once(view, seen, across) ? turn : std::nullopt;
}

bool is_coplanar(const Loop& loop) {
  if (loop.size() == 3) return true;
  // Only the computed heights may decide. LoopPlane::passes_through() takes it for granted that the loop is coplanar.
  Plane plane([&]<class N>() { return LoopPlane{loop}.operator()<N>(); });
  return std::ranges::all_of(loop, [&](const Point& vertex) { return plane.side(vertex) == CGAL::ZERO; });
}

Seen see(const Viewpoint& view, const Loop& loop) {
  if (!has_three_distinct(loop)) return {"fewer than 3 distinct vertices", CGAL::ZERO};
  const Loop seen = without_repeats(view, loop);
  const std::optional<CGAL::Sign> turn = turn_everywhere(view, seen);
  if (!turn) return {"the loop is not convex seen from the eye", CGAL::ZERO};
  if (*turn == CGAL::ZERO) return {"the eye lies in the polygon's plane", CGAL::ZERO};
  Plane across(MeanPlane{loop, view.value});
  if (!view.at_infinity && !lies_ahead(across, loop, *turn)) return {"the eye lies in the polygon", CGAL::ZERO};
  if (!winds_once(view, seen, across)) return {"the loop is not convex seen from the eye", CGAL::ZERO};
  return {"", *turn};
}

}  // namespace occlude::oracle
