// SPDX-License-Identifier: MIT
#include "triangles.h"

#include <algorithm>

namespace occlude::oracle::second {

Triangles::Triangles(const Viewpoint& view, const Occluder& occluder) : view_(view) {
  if (const Loop* loop = std::get_if<Loop>(&occluder)) {
    add_fan(*loop);
    return;
  }
  const auto& [vertices, faces] = std::get<Polytope>(occluder);
  for (const auto& face : faces) {
    Loop loop;
    for (const std::uint32_t index : face) loop.push_back(vertices[index]);
    add_fan(loop);
  }
}

bool Triangles::are_in_line_with(const ExactPoint& x) const {
  return std::ranges::any_of(triangles_, [&](const Triangle& t) { return is_in_line(t, x); });
}

bool Triangles::shade(const ExactPoint& x) const {
  return std::ranges::any_of(triangles_,
                             [&](const Triangle& t) { return is_in_line(t, x) && depth(t, x) != CGAL::SMALLER; });
}

bool Triangles::hide(const ExactPoint& x) const {
  return std::ranges::any_of(triangles_, [&](const Triangle& t) { return is_in_line(t, x) && depth(t, x) == CGAL::LARGER; });
}

void Triangles::add_fan(const Loop& loop) {
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    const ExactPoint a = exact(loop[0]), b = exact(loop[i]), c = exact(loop[i + 1]);
    const CGAL::Orientation turn = side(a, b, c);
    if (turn != CGAL::COPLANAR) triangles_.push_back({a, b, c, turn});
  }
}

CGAL::Orientation Triangles::side(const ExactPoint& a, const ExactPoint& b, const ExactPoint& x) const {
  if (view_.at_infinity) return CGAL::orientation(a, a + from_origin(view_.value), b, x);
  return CGAL::orientation(exact(view_.value), a, b, x);
}

bool Triangles::is_in_line(const Triangle& triangle, const ExactPoint& x) const {
  const auto& [a, b, c, turn] = triangle;
  return side(a, b, x) != -turn && side(b, c, x) != -turn && side(c, a, x) != -turn;
}

CGAL::Comparison_result Triangles::depth(const Triangle& triangle, const ExactPoint& x) const {
  const auto& [a, b, c, turn] = triangle;
  const ExactPoint before = view_.at_infinity ? a - from_origin(view_.value) : exact(view_.value);
  const CGAL::Orientation of_x = CGAL::orientation(a, b, c, x);
  if (of_x == CGAL::COPLANAR) return CGAL::EQUAL;
  return of_x == CGAL::orientation(a, b, c, before) ? CGAL::SMALLER : CGAL::LARGER;
}

}  // namespace occlude::oracle::second
