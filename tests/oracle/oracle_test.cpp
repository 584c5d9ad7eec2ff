// SPDX-License-Identifier: MIT
// The oracle on cases that no file can hold, against a second way in integers, and on changes that must not matter.
#include "occlude/oracle/oracle.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "occlude/fuzz/cases.h"
#include "occlude/fuzz/random.h"
#include "occlude/oracle/second.h"
#include "oracle/vocabulary.h"
#include "oracle/whole_numbers.h"

namespace occlude::oracle {

namespace oracle_test {

struct Question {
  Viewpoint view;
  Loop loop;
  Near near;
  Aabb box;
};

Answer ask(const Question& q) { return relation(q.view, q.loop, q.near, q.box); }
Answer ask_second(const Question& q) { return second::relation(q.view, q.loop, q.near, q.box); }
std::string refute(const Question& q) { return refute_shadow_cull(q.view, q.loop, q.near, q.box); }

// ---------------------------------------------------------------------------------------- cases that no file can hold

TEST(Oracle, TakesAGivenPlane) {
  const Near plane{Near::Kind::plane, {0, 0, 2}, {7, 7, 3}};
  const Question beyond{kOrigin, kSquare, plane, {{-1, -1, 3}, {1, 1, 4}}};
  const Question before{kOrigin, kSquare, plane, {{-1, -1, 2}, {1, 1, below(3)}}};
  EXPECT_EQ(ask(beyond).relation, kInside);
  EXPECT_EQ(ask_second(beyond).relation, kInside);
  EXPECT_EQ(ask(before).relation, kOutside);
  EXPECT_EQ(ask_second(before).relation, kOutside);
}

Loop circle(int sides, double radius, double z) {
  Loop loop;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2 * std::acos(-1.0) * i / sides;
    loop.push_back({radius * std::cos(angle), radius * std::sin(angle), z});
  }
  return loop;
}

TEST(Oracle, TakesManySides) {
  const Loop loop = circle(64, 1, 1);  // vertex 0 is (1, 0, 1) exactly
  EXPECT_EQ(ask({kOrigin, loop, kSurface, {{-1.4, -1.4, 2}, {1.4, 1.4, 3}}}).relation, kInside);
  EXPECT_EQ(ask({kOrigin, loop, kSurface, {{-1.5, -1.5, 2}, {1.5, 1.5, 3}}}).relation, kPartial);
  EXPECT_EQ(ask({kOrigin, loop, kSurface, {{2, -9, 1}, {3, 9, 2}}}).relation, kPartial) << "touches the ray of vertex 0";
  EXPECT_EQ(ask({kOrigin, loop, kSurface, {{above(2), -9, 1}, {3, 9, 2}}}).relation, kOutside);
}

TEST(Oracle, TakesTwoHundredSides) {
  const Loop loop = circle(200, 1, 1);
  EXPECT_EQ(ask({kOrigin, loop, kSurface, {{above(2), -9, 1}, {3, 9, 2}}}).relation, kOutside);
  EXPECT_EQ(ask({kOrigin, loop, kSurface, {{2, -9, 1}, {3, 9, 2}}}).relation, kPartial) << "touches the ray of vertex 0";
}

// ------------------------------------------------------------------------------------------------------------- refusals

Loop star() {
  const Loop five = circle(5, 1, 1);
  return {five[0], five[2], five[4], five[1], five[3]};
}

TEST(Oracle, RefusesWithAReason) {
  const Aabb box{{-1, -1, 2}, {1, 1, 3}};
  const auto loop = [&](Loop vertices) { return Question{kOrigin, std::move(vertices), kFarthest, box}; };
  const auto viewed = [&](const Viewpoint& view) { return Question{view, kSquare, kFarthest, box}; };
  const auto boxed = [&](const Aabb& other) { return Question{kOrigin, kSquare, kFarthest, other}; };
  const auto with_near = [&](const Near& near) { return Question{kOrigin, kSquare, near, box}; };
  const Loop twice{kSquare[0], kSquare[1], kSquare[2], kSquare[3], kSquare[0], kSquare[1], kSquare[2], kSquare[3]};
  const Loop bent{{0, 0, 1}, {1, 0, 1}, {1, 1, 2}, {0, 1, 1}};

  const std::string concave = "the loop is not convex seen from the eye", in_plane = "the eye lies in the polygon's plane";
  const std::string not_finite = "a number is not finite", out_of_range = "a coordinate is out of range";
  const std::string few = "fewer than 3 distinct vertices";
  const std::pair<Question, std::string> cases[] = {
      {boxed({{-1, -1, 2}, {1, kNan, 3}}), not_finite},
      {viewed({{0, kInfinity, 0}, false}), not_finite},
      {loop({{-1, -1, 1}, {1, -kInfinity, 1}, {0, 1, 1}}), not_finite},
      {with_near({Near::Kind::plane, {0, 0, kNan}, {0, 0, 1}}), not_finite},
      {boxed({{-1, -1, 2}, {1, 1, above(0x1p100)}}), out_of_range},
      {boxed({{-1, below(0x1p-100), 2}, {1, 1, 3}}), out_of_range},
      {viewed({{0, 0x1p-101, 0}, false}), out_of_range},
      {boxed({{-1, -1, 3}, {1, 1, 2}}), "the box has min > max"},
      {loop({}), few},
      {loop({{-1, -1, 1}, {1, 1, 1}}), few},
      {loop({{-1, -1, 1}, {1, 1, 1}, {-1, -1, 1}, {1, 1, 1}, {1, 1, 1}}), few},
      {loop({{0, 0, 1}, {1, 0, 1}, {2, 0, 1}}), in_plane},
      {loop({{1, 0, 0}, {0, 1, 0}, {-1, -1, 0}}), in_plane},
      {viewed({{1, 1, 1}, false}), in_plane},
      {viewed({{1, 0, 0}, true}), in_plane},
      {viewed({{0, 0, 0}, true}), "the direction of view is zero"},
      {loop(star()), concave},
      {loop(twice), concave},
      {loop({{0, 0, 1}, {4, 0, 1}, {1, 1, 1}, {0, 4, 1}}), concave},
      {loop({{-1, -1, 1}, {1, 1, 1}, {1, -1, 1}, {-1, 1, 1}}), concave},               // a bow tie
      {loop({{-1, -1, 1}, {3, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}}), concave},   // a spike along an edge
      {loop({{-1, -1, 1}, {1, -1, 1}, {-1, -1, 1}, {1, -1, 1}, {0, 1, 1}}), concave},  // an edge gone over three times
      {loop({{-1, -1, 1}, {0, 0, 1}, {-1, -1, 1}, {1, -1, 1}, {0, 1, 1}}), concave},   // an antenna
      {loop({{-1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0, 0, 1}}), "the eye lies in the polygon"},
      {Question{kOrigin, bent, kSurface, box}, "the vertices are not coplanar: give a support plane as near"},
      {with_near({Near::Kind::plane, {0, 0, 1}, {0, 0, below(1)}}), "part of the occluder lies behind the near plane"},
      {with_near({Near::Kind::plane, {1, 0, 0}, {1, 0, 0}}), ""},
      {with_near({Near::Kind::plane, {0, 0, 0}, {0, 0, 1}}), "the near plane does not face the eye"},
      {with_near({Near::Kind::plane, {0, 0, -1}, {0, 0, 0}}), "the near plane does not face the eye"},
  };
  for (std::size_t i = 0; i < std::size(cases); ++i) {
    const auto& [question, reason] = cases[i];
    EXPECT_EQ(ask(question).refusal, reason) << "case " << i;
    if (!reason.empty()) {
      EXPECT_EQ(refute(question), reason) << "case " << i;
    }
  }
}

/// With so many vertices, work for every pair of them would take minutes.
TEST(Oracle, LoopsOfVeryManyVertices) {
  constexpr int kSides = 100000;
  Loop disc;
  for (int i = 0; i < kSides; ++i) {
    const double angle = i * 2 * 3.14159265358979 / kSides;
    disc.push_back({std::cos(angle), std::sin(angle), 1});
  }
  const Aabb box{{-0.5, -0.5, 3}, {0.5, 0.5, 4}};
  const auto answer = [&](const Viewpoint& view, const Loop& loop) { return relation(view, loop, kFarthest, box); };
  const Viewpoint along{{0, 0, 1}, true};
  EXPECT_EQ(answer(kOrigin, disc).relation, Relation::inside);
  EXPECT_EQ(answer(along, disc).relation, Relation::inside);
  Loop twice = disc, dented = disc;
  twice.insert(twice.end(), disc.begin(), disc.end());
  dented[kSides - 2] = {0.5, 0, 1};
  for (const Viewpoint& view : {kOrigin, along}) {
    EXPECT_EQ(answer(view, twice).refusal, "the loop is not convex seen from the eye");
    EXPECT_EQ(answer(view, dented).refusal, "the loop is not convex seen from the eye");
  }
}

// ----------------------------------------------------------------------------------------------------- the second way
// It uses integers only, small enough for 64 bits, and shares nothing with the oracle. The intersection of box and F is
// bounded. So box and F have a common point exactly when some point where three of their planes meet is in all of their
// half-spaces.

struct WholePlane {  // normal . x >= offset
  WholePoint normal;
  Whole offset;
};

/// The plane through `point` with `within` on its positive side.
WholePlane plane_through(const WholePoint& point, WholePoint normal, const WholePoint& within) {
  if (dot(normal, minus(within, point)) < 0) normal = {-normal[0], -normal[1], -normal[2]};
  return {normal, dot(normal, point)};
}

struct WholeCase {
  WholePoint eye;
  bool at_infinity;
  std::vector<WholePoint> loop;
  bool is_surface;
  WholePoint min, max;
};

/// The half-spaces of F. The inner side of a side plane is that of some vertex that is not on the plane.
std::vector<WholePlane> planes_of_frustum(const WholeCase& c) {
  std::vector<WholePlane> planes;
  const std::size_t count = c.loop.size();
  for (std::size_t i = 0; i < count; ++i) {
    const WholePoint &a = c.loop[i], &b = c.loop[(i + 1) % count];
    const WholePoint normal = cross(c.at_infinity ? c.eye : minus(a, c.eye), minus(b, a));
    const auto off = std::ranges::find_if(c.loop, [&](const WholePoint& v) { return dot(normal, minus(v, a)) != 0; });
    if (off != c.loop.end()) planes.push_back(plane_through(a, normal, *off));
  }
  const auto sight = [&](const WholePoint& p) { return c.at_infinity ? c.eye : minus(p, c.eye); };
  if (c.is_surface) {
    const WholePoint &p = c.loop[0], s = sight(p);
    const WholePoint normal = cross(minus(c.loop[1], p), minus(c.loop.back(), p));
    planes.push_back(plane_through(p, normal, {p[0] + s[0], p[1] + s[1], p[2] + s[2]}));
  } else {
    const auto remoteness = [&](const WholePoint& p) { return dot(sight(p), c.at_infinity ? p : sight(p)); };
    const WholePoint& p = *std::ranges::max_element(c.loop, {}, remoteness);  // the first on a tie
    planes.push_back({sight(p), dot(sight(p), p)});
  }
  return planes;
}

/// Whether the three planes meet in one point, and that point is in all half-spaces.
bool meet_within(const WholePlane& p, const WholePlane& q, const WholePlane& r, const std::vector<WholePlane>& all) {
  const WholePoint qr = cross(q.normal, r.normal), rp = cross(r.normal, p.normal), pq = cross(p.normal, q.normal);
  const Whole w = dot(p.normal, qr);  // the point is x / w
  if (w == 0) return false;
  WholePoint x;
  for (std::size_t k = 0; k < 3; ++k) x[k] = p.offset * qr[k] + q.offset * rp[k] + r.offset * pq[k];
  return std::ranges::all_of(all, [&](const WholePlane& h) {
    const Whole height = dot(h.normal, x) - h.offset * w;
    return w > 0 ? height >= 0 : height <= 0;
  });
}

bool share_a_point(const std::vector<WholePlane>& planes) {
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        if (meet_within(planes[i], planes[j], planes[k], planes)) return true;
      }
    }
  }
  return false;
}

Relation second_way(const WholeCase& c) {
  std::vector<WholePlane> planes = planes_of_frustum(c);
  const bool is_inside = std::ranges::all_of(planes, [&](const WholePlane& plane) {
    Whole lowest = -plane.offset;
    for (std::size_t k = 0; k < 3; ++k) lowest += std::min(plane.normal[k] * c.min[k], plane.normal[k] * c.max[k]);
    return lowest >= 0;
  });
  if (is_inside) return kInside;
  for (std::size_t k = 0; k < 3; ++k) {
    WholePoint up{}, down{};
    up[k] = 1;
    down[k] = -1;
    planes.push_back({up, c.min[k]});
    planes.push_back({down, -c.max[k]});
  }
  return share_a_point(planes) ? kPartial : kOutside;
}

/// A triangle or parallelogram. Some have a vertex in the middle of an edge, or a vertex twice.
WholeCase whole_case(fuzz::Random& random) {
  WholeCase c{whole_point(random, 4), random.chance(0.25), {}, random.chance(0.5), {}, {}};
  const WholePoint start = whole_point(random, 3), e = whole_point(random, 2), f = whole_point(random, 2);
  const auto at = [&](Whole a, Whole b) {
    return WholePoint{start[0] + a * e[0] + b * f[0], start[1] + a * e[1] + b * f[1], start[2] + a * e[2] + b * f[2]};
  };
  c.loop = {at(0, 0), at(2, 0), at(2, 2), at(0, 2)};
  if (random.chance(0.5)) c.loop.erase(c.loop.begin() + 2);
  if (random.chance(0.2)) c.loop.insert(c.loop.begin() + 2, c.loop[1]);
  if (random.chance(0.2)) c.loop.insert(c.loop.begin() + 1, at(1, 0));
  const WholePoint p = whole_point(random, 9), size = whole_point(random, random.chance(0.5) ? 2 : 18);
  for (std::size_t k = 0; k < 3; ++k) {
    c.min[k] = p[k];
    c.max[k] = std::max(p[k], p[k] + size[k]);  // flat half the time
  }
  return c;
}

Question to_question(const WholeCase& c) {
  Question q{{to_point(c.eye), c.at_infinity}, {}, c.is_surface ? kSurface : kFarthest, {to_point(c.min), to_point(c.max)}};
  for (const WholePoint& v : c.loop) q.loop.push_back(to_point(v));
  return q;
}

/// Whether the loop is seen edge-on. The case has a frustum exactly when it is not, because all these loops are convex.
bool is_seen_edge_on(const WholeCase& c) {
  const WholePoint& a = c.loop[0];
  const WholePoint normal = cross(minus(c.loop[1], a), minus(c.loop.back(), a));
  return dot(normal, c.at_infinity ? c.eye : minus(a, c.eye)) == 0;
}

TEST(Oracle, AgreesWithTheSecondWay) {
  fuzz::Random random(1);
  std::array<int, 3> counts{};
  int refused = 0;
  for (int i = 0; i < 20000; ++i) {
    const WholeCase c = whole_case(random);
    const Answer answer = ask(to_question(c));
    ASSERT_EQ(!answer.refusal.empty(), is_seen_edge_on(c)) << "case " << i << ": " << answer.refusal;
    if (!answer.refusal.empty()) {
      ++refused;
      continue;
    }
    ASSERT_EQ(answer.relation, second_way(c)) << "case " << i;
    ++counts[static_cast<std::size_t>(answer.relation)];
  }
  for (const int count : counts) EXPECT_GT(count, 200);
  EXPECT_LT(refused, 8000);
}

// ------------------------------------------------------------------------------------------------ what must not matter

Point to_point(const kernel::Vec3& v) { return {v.x, v.y, v.z}; }

using Polygon = std::vector<kernel::Vec3>;

/// REQUIRES: the case has a polygon and an axis-aligned box.
Question to_question(const fuzz::Case& made) {
  const auto& box = std::get<kernel::Aabb>(made.box);
  Question q{{to_point(made.viewpoint.value), !made.viewpoint.is_eye()},
             {},
             made.near == fuzz::Near::farthest ? kFarthest : kSurface,
             {to_point(box.min), to_point(box.max)}};
  for (const kernel::Vec3& v : std::get<Polygon>(made.occluder)) q.loop.push_back(to_point(v));
  return q;
}

/// Applies `map` to every point of the question, and sorts the bounds of the box again.
Question mapped(Question q, const std::function<Point(const Point&)>& map) {
  q.view.value = map(q.view.value);
  for (Point& vertex : q.loop) vertex = map(vertex);
  const Point a = map(q.box.min), b = map(q.box.max);
  for (std::size_t k = 0; k < 3; ++k) {
    q.box.min[k] = std::min(a[k], b[k]);
    q.box.max[k] = std::max(a[k], b[k]);
  }
  return q;
}

void for_each_case(int count, const std::function<void(fuzz::Family, const Question&)>& check) {
  for (const fuzz::Family family : fuzz::families()) {
    for (int seed = 0; seed < count; ++seed) {
      const fuzz::Case made = fuzz::make_case(family, static_cast<std::uint64_t>(seed));
      if (!std::holds_alternative<Polygon>(made.occluder) || !std::holds_alternative<kernel::Aabb>(made.box)) break;
      check(family, to_question(made));
    }
  }
}

void expect_same(const Question& q, const Question& other, const char* what) {
  const Answer a = ask(q), b = ask(other);
  EXPECT_EQ(a.refusal, b.refusal) << what;
  EXPECT_EQ(a.relation, b.relation) << what;
}

TEST(Oracle, CaresNeitherForAxesNorForScale) {
  for_each_case(100, [](fuzz::Family family, const Question& q) {
    SCOPED_TRACE(fuzz::name(family));
    expect_same(q, mapped(q, [](const Point& p) { return Point{p[1], p[2], p[0]}; }), "axes permuted");
    expect_same(q, mapped(q, [](const Point& p) { return Point{p[1], p[0], p[2]}; }), "axes exchanged");
    expect_same(q, mapped(q, [](const Point& p) { return Point{p[0], -p[1], p[2]}; }), "mirrored");
    const double scale = family == fuzz::Family::huge_scale ? 0x1p-37 : 0x1p11;
    expect_same(q, mapped(q, [&](const Point& p) { return Point{scale * p[0], scale * p[1], scale * p[2]}; }), "scaled");
  });
}

TEST(Oracle, CaresNotWhereTheSceneIs) {
  using fuzz::Family;
  for_each_case(200, [](Family family, const Question& q) {
    const bool is_whole = family == Family::lattice || family == Family::ray_touch || family == Family::collinear ||
                          family == Family::many_sided || family == Family::eye_in_box;
    if (!is_whole) return;
    Question moved = mapped(q, [](const Point& p) { return Point{p[0] + 1000, p[1] - 77, p[2] + 123456}; });
    expect_same(q, moved, "moved");
  });
}

TEST(Oracle, CaresNotHowTheLoopIsWritten) {
  for_each_case(100, [](fuzz::Family family, Question q) {
    if (q.near.kind == Near::Kind::farthest) return;  // its plane may depend on the order
    SCOPED_TRACE(fuzz::name(family));
    const Question before = q;
    std::ranges::reverse(q.loop);
    expect_same(before, q, "reversed");
    std::rotate(q.loop.begin(), q.loop.begin() + 1, q.loop.end());
    expect_same(before, q, "rotated");
    q.loop.insert(q.loop.begin() + 1, {q.loop[1], q.loop[1]});
    q.loop.push_back(q.loop.front());
    if (q.loop.size() > 6) expect_same(before, q, "vertices repeated");
  });
}

TEST(Oracle, TakesTheFirstOfEquallyFarVertices) {
  // All four corners of the square are equally far. From the first, the plane is -x - y + z >= 3; from the third, x + y + z
  // >= 3.
  const Aabb corner{{-1, -1, 1}, {-1, -1, 1}};
  EXPECT_EQ(ask({kOrigin, kSquare, kFarthest, corner}).relation, kInside);
  Loop rotated = kSquare;
  std::rotate(rotated.begin(), rotated.begin() + 2, rotated.end());
  EXPECT_EQ(ask({kOrigin, rotated, kFarthest, corner}).relation, kOutside);
}

// -------------------------------------------------------------------------------------------------------- proofs of culls

TEST(Oracle, ProvesAShadowCullOnlyStrictlyBeyondTheNearPlane) {
  EXPECT_EQ(refute({kOrigin, kSquare, kSurface, {{-1, -1, above(1)}, {1, 1, 2}}}), "");
  EXPECT_EQ(refute({kOrigin, kSquare, kSurface, {{-2, -2, 2}, {2, 2, 3}}}), "") << "side planes may be touched";
  EXPECT_EQ(refute({kOrigin, kSquare, kSurface, {{-1, -1, 1}, {1, 1, 2}}}), "the box touches the near plane");
  EXPECT_EQ(refute({kOrigin, kSquare, kSurface, {{-1, -1, 1}, {1, 1, 1}}}), "the box touches the near plane");
  EXPECT_EQ(refute({kOrigin, kSquare, kSurface, {{-2, -2, 2}, {above(2), 2, 3}}}), "the box is not inside the frustum");
  EXPECT_EQ(refute({kOrigin, kSquare, kSurface, {{-1, -1, below(1)}, {1, 1, 2}}}), "the box is not inside the frustum");
  const Near plane{Near::Kind::plane, {0, 0, 1}, {0, 0, 2}};
  EXPECT_EQ(refute({kOrigin, kSquare, plane, {{-1, -1, above(2)}, {1, 1, 3}}}), "");
  EXPECT_EQ(refute({kOrigin, kSquare, plane, {{-1, -1, 2}, {1, 1, 3}}}), "the box touches the near plane");
  EXPECT_EQ(refute({{{0, 0, 1}, true}, kSquare, kFarthest, {{-1, -1, above(1)}, {1, 1, 3}}}), "");
  EXPECT_EQ(refute({{{0, 0, 1}, true}, kSquare, kFarthest, {{-1, -1, 1}, {1, 1, 3}}}), "the box touches the near plane");
}

TEST(Oracle, ProvesAShadowCullExactlyWhenInsideAndOffTheNearPlane) {
  int proved = 0, touching = 0;
  for_each_case(200, [&](fuzz::Family family, const Question& q) {
    const Answer answer = ask(q);
    const std::string refutation = refute(q);
    SCOPED_TRACE(fuzz::name(family));
    if (!answer.refusal.empty()) {
      EXPECT_EQ(refutation, answer.refusal);
    } else if (answer.relation == kInside) {
      EXPECT_TRUE(refutation.empty() || refutation == "the box touches the near plane") << refutation;
      ++(refutation.empty() ? proved : touching);
    } else {
      EXPECT_EQ(refutation, "the box is not inside the frustum");
    }
  });
  EXPECT_GT(proved, 500);
  EXPECT_GT(touching, 200);
}

TEST(Oracle, ProvesAViewCullExactly) {
  const Aabb box{{-1, -1, -1}, {1, 1, 1}};
  EXPECT_EQ(refute_view_cull({1, 1, 1, -4}, box), "");
  EXPECT_EQ(refute_view_cull({1, 1, 1, -3}, box), "the box reaches the plane");
  EXPECT_EQ(refute_view_cull({1, 1, 1, below(-3)}, box), "");
  EXPECT_EQ(refute_view_cull({0, 0, 0, 0}, box), "the box reaches the plane");
  // 3 * 0.1, with 0.1 as a double, is between the doubles 0.3 and 0.30000000000000004.
  const Aabb three{{3, 0, 0}, {3, 0, 0}};
  EXPECT_EQ(refute_view_cull({0.1, 0, 0, -0.30000000000000004}, three), "");
  EXPECT_EQ(refute_view_cull({0.1, 0, 0, -0.3}, three), "the box reaches the plane");
  EXPECT_EQ(refute_view_cull({0.1, 0, 0, kInfinity}, three), "a number is not finite");
  EXPECT_EQ(refute_view_cull({1, 0, 0, -9}, Aabb{{3, 0, 0}, {2, 0, 0}}), "the box has min > max");
}

}  // namespace oracle_test
}  // namespace occlude::oracle
