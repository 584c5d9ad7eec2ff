// SPDX-License-Identifier: MIT
// The oracle on polytopes: a given plane, changes that must not matter, refusals, and proofs of culls.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "occlude/oracle/oracle.h"
#include "occlude/oracle/second.h"
#include "oracle/cuboid.h"
#include "oracle/vocabulary.h"

namespace occlude::oracle {
namespace polytope_test {

using Faces = std::vector<std::vector<std::uint32_t>>;

constexpr Point kZero{};

// From the origin, three faces are turned to the eye. With near `surface`, F is where x, y, z >= 1 and none of them is more
// than 3 times another. The vertices (3, 3, 1), (3, 1, 3) and (1, 3, 3), numbers 3, 5 and 6, are equally far.
const Polytope kCorner = cuboid({1, 1, 1}, {3, 3, 3});

Aabb point_box(const Point& p) { return {p, p}; }

TEST(Polytope, TakesAGivenPlane) {
  const Polytope block = cuboid({-1, -1, 1}, {1, 1, 3});
  const Near plane{Near::Kind::plane, {0, 0, 1}, {5, 5, 3}};
  for (const auto& [box, expected] : {std::pair{Aabb{{-1, -1, 3}, {1, 1, 4}}, kInside}, {point_box({0, 0, 2}), kOutside}}) {
    EXPECT_EQ(relation(kOrigin, block, plane, box).relation, expected);
    EXPECT_EQ(second::relation(kOrigin, block, plane, box).relation, expected);
  }
}

// ------------------------------------------------------------------------------------------------ what must not matter

/// Expects the same answers as for kCorner, a cube whose near x face is {0, 2, 6, 4}.
void expect_corner(const Polytope& polytope, const std::string& what) {
  const Box boxes[] = {Aabb{{1, 1, 1}, {3, 3, 3}},
                       Aabb{{below(1), 1, 1}, {3, 3, 3}},
                       Aabb{{0, 0, 0}, {1, 1, 1}},
                       Aabb{{9, 9, 0}, {12, 12, below(3)}},
                       Aabb{{2, 3, 4}, {3, 3, 4}},
                       Aabb{{2, 3, below(4)}, {3, 3, 4}},
                       Obb{{6, 6, 6}, {{{3, -1.5, -1.5}, {0, 1.5, -1.5}, kZero}}}};
  for (const Viewpoint& view : {kOrigin, Viewpoint{{1, 2, 3}, true}, Viewpoint{{2, 0, 1}, false}}) {
    for (const Near& near : {kSurface, kFarthest}) {
      for (const Box& box : boxes) {
        const Answer answer = relation(view, polytope, near, box);
        EXPECT_EQ(answer.refusal, "") << what;
        EXPECT_EQ(answer.relation, relation(view, kCorner, near, box).relation) << what;
      }
    }
  }
}

Polytope with_faces(Faces faces) { return {kCorner.vertices, std::move(faces)}; }

TEST(Polytope, IsTheSameHoweverItsFacesAreWritten) {
  Faces faces = kCorner.faces;
  for (std::size_t f = 0; f < faces.size(); f += 2) std::ranges::reverse(faces[f]);
  std::rotate(faces[3].begin(), faces[3].begin() + 1, faces[3].end());
  std::ranges::reverse(faces);
  expect_corner(with_faces(faces), "other ways round, other starts, other order");

  Faces triangles;
  for (const auto& face : kCorner.faces) {
    triangles.push_back({face[0], face[1], face[2]});
    triangles.push_back({face[0], face[2], face[3]});
  }
  expect_corner(with_faces(triangles), "triangles");

  faces = kCorner.faces;
  faces[0] = {0, 2, 2, 6, 4, 4, 4, 0};
  faces.insert(faces.end(), {{0, 0, 0}, {0, 1, 0}, {5, 6}, {}, {7}});
  expect_corner(with_faces(faces), "repeated vertices, and faces without area");
}

TEST(Polytope, IsTheSameWithMoreVertices) {
  // The near x face is cut across its middle. Vertices 8 and 9 are corners of its two parts, and of no other face.
  Polytope polytope = kCorner;
  polytope.vertices.insert(polytope.vertices.end(), {{1, 2, 1}, {1, 2, 3}});
  polytope.faces[0] = {0, 8, 9, 4};
  polytope.faces.push_back({8, 2, 6, 9});
  expect_corner(polytope, "T-junctions");

  // The second part is cut again, so that one part has a vertex inside an edge of another.
  polytope.vertices.push_back({1, 2, 2});
  polytope.faces.back() = {8, 2, 10};
  polytope.faces.insert(polytope.faces.end(), {{10, 2, 6}, {10, 6, 9}});
  expect_corner(polytope, "T-junctions within a face");

  polytope.faces.push_back({8, 10, 9});
  expect_corner(polytope, "a sliver without area in a T-junction");

  polytope = kCorner;
  polytope.vertices.insert(polytope.vertices.end(), {{2, 2, 2}, {1, 2, 2}, {3, 3, 2}, {3, 3, 1}});
  expect_corner(polytope, "vertices of no face: inside, in a face, on an edge, another's double");

  polytope = kCorner;
  const std::size_t count = polytope.vertices.size();
  for (std::size_t i = 0; i < count; ++i) polytope.vertices.push_back(Point(polytope.vertices[i]));
  for (std::size_t f = 1; f < polytope.faces.size(); ++f) {
    for (std::size_t i = f % 2; i < 4; i += 2) polytope.faces[f][i] += 8;
  }
  expect_corner(polytope, "every vertex twice");
}

TEST(Polytope, TakesMinusZeroForZero) {
  Polytope polytope = cuboid({0, 0, 0}, {2, 2, 2});
  polytope.vertices.push_back({-0., -0., -0.});
  polytope.faces[0][0] = 8;
  const Answer answer = relation({{-1, -1, -1}, false}, polytope, kSurface, point_box(kZero));
  EXPECT_EQ(answer.refusal, "");
  EXPECT_EQ(answer.relation, kInside);
}

TEST(Polytope, TakesTheFirstInTheListOfEquallyFarVertices) {
  Polytope polytope = kCorner;
  std::swap(polytope.vertices[3], polytope.vertices[6]);
  for (auto& face : polytope.faces) {
    for (std::uint32_t& index : face) index = index == 3 ? 6 : index == 6 ? 3 : index;
  }
  EXPECT_EQ(relation(kOrigin, polytope, kFarthest, point_box({1, 3, 3})).relation, kInside);
  EXPECT_EQ(relation(kOrigin, polytope, kFarthest, point_box({3, 3, 1})).relation, kOutside);
}

// ------------------------------------------------------------------------------------------------------------- refusals

/// kCorner with vertex `index` moved to p.
Polytope with_vertex(std::size_t index, const Point& p) {
  Polytope polytope = kCorner;
  polytope.vertices[index] = p;
  return polytope;
}

Polytope without_face(std::size_t f) {
  Polytope polytope = kCorner;
  polytope.faces.erase(polytope.faces.begin() + static_cast<std::ptrdiff_t>(f));
  return polytope;
}

Polytope with_face(std::vector<std::uint32_t> face) {
  Polytope polytope = kCorner;
  polytope.faces.push_back(std::move(face));
  return polytope;
}

Polytope with_point(const Point& p) {
  Polytope polytope = kCorner;
  polytope.vertices.push_back(p);
  return polytope;
}

/// A tetrahedron.
Polytope tetrahedron(const std::vector<Point>& vertices) { return {vertices, {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}}; }

TEST(Polytope, RefusesWithAReason) {
  const std::string not_finite = "a number is not finite", out_of_range = "a coordinate is out of range";
  const std::string no_vertex = "a face names a vertex that does not exist", bad_face = "a face is not plane and convex";
  const std::string open = "the polytope is not closed", not_convex = "the polytope is flat or not convex";
  const std::string overlap = "two faces of the polytope overlap";

  // A dent: the top of the cube is drawn in to a point inside.
  Polytope dented = with_point({2, 2, 2});
  dented.faces.back() = {4, 5, 8};
  dented.faces.insert(dented.faces.end(), {{5, 7, 8}, {7, 6, 8}, {6, 4, 8}});
  // Only its top, twice, which is closed. The other vertices are listed but unused.
  const Polytope folded = with_faces({{4, 5, 7, 6}, {6, 7, 5, 4}});
  // The near x face with a square inside it, twice.
  Polytope patched = kCorner;
  patched.vertices.insert(patched.vertices.end(), {{1, 1.5, 1.5}, {1, 2.5, 1.5}, {1, 2.5, 2.5}, {1, 1.5, 2.5}});
  patched.faces.insert(patched.faces.end(), {{8, 9, 10, 11}, {8, 9, 10, 11}});
  // Two tetrahedra that share a vertex.
  const Polytope two{{{2, 2, 2}, {3, 2, 2}, {2, 3, 2}, {2, 2, 3}, {1, 2, 2}, {2, 1, 2}, {2, 2, 1}},
                     {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}, {0, 4, 5}, {0, 4, 6}, {0, 5, 6}, {4, 5, 6}}};
  // A face whose edges cross where there is no vertex, like part of a star.
  Polytope star = kCorner;
  star.faces[0] = {0, 6, 2, 4};
  // A face with a notch, and a face that fills the notch.
  Polytope notched = with_point({1, 2, 2});
  notched.faces[0] = {0, 2, 6, 8, 4};
  notched.faces.push_back({8, 6, 4});

  const std::pair<Polytope, std::string> cases[] = {
      {with_vertex(2, {1, kNan, 1}), not_finite},
      {with_point({1, 2, kInfinity}), not_finite},
      {with_vertex(2, {1, 0x1p101, 1}), out_of_range},
      {with_point({1, 2, 0x1p-101}), out_of_range},
      {with_face({0, 1, 8}), no_vertex},
      {with_face({8}), no_vertex},
      {{{}, {{0}}}, no_vertex},
      {{{}, {}}, open},
      {{kCorner.vertices, {}}, open},
      {{{{1, 1, 1}, {2, 2, 2}}, {{0, 1, 0}, {1, 0}}}, open},
      {{{{1, 1, 1}, {2, 1, 1}, {1, 2, 1}}, {{0, 1, 2}}}, open},
      {with_faces({{0, 1, 3, 2}}), open},
      {without_face(4), open},
      {with_face({0, 1, 3}), open},
      {with_face({0, 2, 6, 4}), open},
      {with_face({0, 1, 7, 6}), open},
      {with_vertex(7, {3, 3, above(3)}), bad_face},
      {with_vertex(7, {2, 2, 3}), bad_face},
      {with_vertex(0, {below(1), 1, 1}), bad_face},
      {star, bad_face},
      {notched, bad_face},
      {{{{1, 1, 1}, {2, 1, 1}, {1, 2, 1}}, {{0, 1, 2}, {2, 1, 0}}}, not_convex},
      {{{{1, 1, 1}, {2, 1, 1}, {2, 2, 1}, {1, 2, 1}}, {{0, 1, 2, 3}, {0, 1, 2}, {0, 2, 3}}}, not_convex},
      {tetrahedron({{1, 1, 1}, {2, 1, 1}, {1, 2, 1}, {2, 2, 1}}), not_convex},
      {tetrahedron({{1, 1, 1}, {2, 1, 1}, {1, 2, 1}, {2, 2, above(1)}}), ""},
      {with_point({3, 3, above(3)}), not_convex},
      {with_point({below(1), 2, 2}), not_convex},
      {dented, not_convex},
      {two, not_convex},
      {folded, overlap},
      {patched, overlap},
  };
  for (std::size_t i = 0; i < std::size(cases); ++i) {
    const auto& [polytope, reason] = cases[i];
    EXPECT_EQ(relation(kOrigin, polytope, kSurface, point_box({9, 9, 9})).refusal, reason) << "case " << i;
    if (!reason.empty()) {
      EXPECT_EQ(refute_shadow_cull(kOrigin, polytope, kFarthest, point_box({9, 9, 9})), reason) << "case " << i;
    }
  }
}

TEST(Polytope, RefusesViewpointsAndPlanesWithAReason) {
  const std::string within = "the eye lies in the polytope";
  const std::pair<Viewpoint, std::string> views[] = {
      {{{2, 2, 2}, false}, within},
      {{{1, 2, 2}, false}, within},
      {{{1, 1, 2}, false}, within},
      {{{3, 3, 3}, false}, within},
      {{{1, 1, 1}, false}, within},
      {{{3, 3, above(3)}, false}, ""},
      {{{below(1), 1, 1}, false}, ""},
      {{{0, 1, 1}, false}, ""},
      {{{2, 2, 2}, true}, ""},
      {{{0, 0, 0}, true}, "the direction of view is zero"},
      {{{0, kNan, 0}, true}, "a number is not finite"},
  };
  for (const auto& [view, reason] : views) {
    EXPECT_EQ(relation(view, kCorner, kSurface, point_box({9, 9, 9})).refusal, reason) << testing::PrintToString(view.value);
  }
  const auto refusal = [](const Point& normal, const Point& point) {
    return relation(kOrigin, kCorner, {Near::Kind::plane, normal, point}, point_box({9, 9, 9})).refusal;
  };
  EXPECT_EQ(refusal({0, 0, 1}, {0, 0, 3}), "");
  EXPECT_EQ(refusal({0, 0, 1}, {0, 0, below(3)}), "part of the occluder lies behind the near plane");
  EXPECT_EQ(refusal({0, 0, -1}, {0, 0, 0}), "the near plane does not face the eye");
}

// -------------------------------------------------------------------------------------------------------- proofs of culls

TEST(Polytope, ProvesAShadowCullOnlyStrictlyBeyondEveryNearPlane) {
  const auto refute = [](const Near& near, const Box& box) { return refute_shadow_cull(kOrigin, kCorner, near, box); };
  EXPECT_EQ(refute(kSurface, Aabb{{5, 5, 5}, {15, 15, 15}}), "") << "side planes may be touched";
  EXPECT_EQ(refute(kSurface, Aabb{{5, 5, 5}, {above(15), 15, 15}}), "the box is not inside the frustum");
  EXPECT_EQ(refute(kSurface, Aabb{{above(1), above(1), above(1)}, {2, 2, 2}}), "");
  EXPECT_EQ(refute(kSurface, Aabb{{2, 1, 2}, {2, 2, 2}}), "the box touches the near plane");
  EXPECT_EQ(refute(kFarthest, point_box({3, 3, 1})), "the box touches the near plane");
  EXPECT_EQ(refute(kFarthest, point_box({3, 3, above(1)})), "");
  EXPECT_EQ(refute(kFarthest, Obb{{9, 9, 9}, {{{1, 1, 0}, {1, -1, 0}, {0, 0, 1}}}}), "");
}

}  // namespace polytope_test
}  // namespace occlude::oracle
