// SPDX-License-Identifier: MIT
// The polytopes that are refused, and the viewpoints from which they are. Polytopes that are just legal answer correctly.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <variant>
#include <vector>

#include "cases/ask.h"
#include "hand_cases.h"
#include "kernel/cube.h"
#include "occlude/kernel/convex_polytope.h"
#include "occlude/kernel/shadow_frustum.h"

namespace polytope_refusal_test {

using namespace occlude;
using namespace occlude::kernel;

double up(double x) { return std::nextafter(x, HUGE_VAL); }
double down(double x) { return std::nextafter(x, -HUGE_VAL); }

const Vec3 kMin{2, -1, -1};

/// Vertices of the cube: 5 is at its maximum, on the diagonal 1 - 5 of the triangulated face at x = 4; 3 is not on it.
const Polytope kCube = cube(kMin), kTriangulated = cube(kMin, CubeForm::triangles);
constexpr std::size_t kFaceAtMaxX = 1;

Refusal refusal(const Polytope& polytope) { return ConvexPolytope::make(polytope).refusal; }

TEST(PolytopeRefusal, NumbersEvenOfVerticesThatNoFaceUses) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
  const auto with = [](double x) {
    Polytope polytope = kCube;
    polytope.vertices.push_back({3, x, 0});
    return refusal(polytope);
  };
  EXPECT_EQ(with(kNan), Refusal::not_finite);
  EXPECT_EQ(with(-kInfinity), Refusal::not_finite);
  EXPECT_EQ(with(0x1p101), Refusal::out_of_range);
  EXPECT_EQ(with(up(0x1p100)), Refusal::out_of_range);
  EXPECT_EQ(with(0x1p-101), Refusal::out_of_range);
  EXPECT_EQ(with(down(0x1p-100)), Refusal::out_of_range);
  EXPECT_EQ(with(0x1p-100), Refusal::none);
  Polytope used = kCube;
  used.vertices[0].y = kNan;
  EXPECT_EQ(refusal(used), Refusal::not_finite);
}

TEST(PolytopeRefusal, FaceIndicesThatDoNotExist) {
  Polytope polytope = kCube;
  polytope.faces[2][1] = 8;
  EXPECT_EQ(refusal(polytope), Refusal::bad_face_index);
  polytope.faces[2][1] = ~std::uint32_t{0};
  EXPECT_EQ(refusal(polytope), Refusal::bad_face_index);
  EXPECT_EQ(refusal({{}, {{0, 1, 2}}}), Refusal::bad_face_index);
}

TEST(PolytopeRefusal, TooFewVertices) {
  EXPECT_EQ(refusal({}), Refusal::too_few_vertices);
  EXPECT_EQ(refusal({kCube.vertices, {}}), Refusal::too_few_vertices);
  EXPECT_EQ(refusal({kCube.vertices, {{0, 1}, {1, 0}}}), Refusal::too_few_vertices);
  const Vec3 a{2, 0, 0}, b{2, 1, 0};
  EXPECT_EQ(refusal({{a, b, a, b}, {{0, 1, 2}, {1, 2, 3}}}), Refusal::too_few_vertices);
}

TEST(PolytopeRefusal, FacesThatAreNotPlaneByAnUlp) {
  for (const bool are_reversed : {false, true}) {
    for (const std::size_t vertex : {3U, 5U}) {
      for (const double x : {up(4), down(4)}) {
        Polytope polytope = kCube;
        polytope.vertices[vertex].x = x;
        if (are_reversed) std::ranges::for_each(polytope.faces, [](auto& face) { std::ranges::reverse(face); });
        EXPECT_EQ(refusal(polytope), Refusal::polytope_not_convex);
      }
    }
  }
}

TEST(PolytopeRefusal, SolidsThatAreNotConvexByAnUlp) {
  // Triangles are always planar. So it matters only whether the diagonal of the face is a ridge or a valley.
  const auto moved = [](std::size_t vertex, double x) {
    Polytope polytope = kTriangulated;
    polytope.vertices[vertex].x = x;
    return refusal(polytope);
  };
  EXPECT_EQ(moved(5, up(4)), Refusal::none);
  EXPECT_EQ(moved(5, down(4)), Refusal::polytope_not_convex);
  EXPECT_EQ(moved(3, up(4)), Refusal::polytope_not_convex);
  EXPECT_EQ(moved(3, down(4)), Refusal::none);
}

/// The cube with four triangles to `tip` in place of the face at x = 4.
Polytope cube_with_tip(const Vec3& tip) {
  Polytope polytope = kCube;
  const std::vector<std::uint32_t> base = polytope.faces[kFaceAtMaxX];
  polytope.faces.erase(polytope.faces.begin() + kFaceAtMaxX);
  const auto top = static_cast<std::uint32_t>(polytope.vertices.size());
  polytope.vertices.push_back(tip);
  for (std::size_t i = 0; i < base.size(); ++i) polytope.faces.push_back({base[i], base[(i + 1) % base.size()], top});
  return polytope;
}

TEST(PolytopeRefusal, Pits) {
  EXPECT_EQ(refusal(cube_with_tip({3, 0, 0})), Refusal::polytope_not_convex);
  EXPECT_EQ(refusal(cube_with_tip({down(4), 0, 0})), Refusal::polytope_not_convex);
  EXPECT_EQ(refusal(cube_with_tip({4, 0, 0})), Refusal::none);
  EXPECT_EQ(refusal(cube_with_tip({up(4), 0, 0})), Refusal::none);
  EXPECT_EQ(refusal(cube_with_tip({5, 0, 0})), Refusal::none);
  // A tip that leans over an edge of its base.
  EXPECT_EQ(refusal(cube_with_tip({5, 1, 0})), Refusal::none);
  EXPECT_EQ(refusal(cube_with_tip({5, up(1), 0})), Refusal::polytope_not_convex);
  EXPECT_EQ(refusal(cube_with_tip({4, 1.5, 0})), Refusal::polytope_not_convex);
}

TEST(PolytopeRefusal, FacesThatAreNotConvex) {
  // The face at x = 4 is divided into two parts that cover it exactly. One has a notch into which the other fits.
  Polytope polytope = kCube;
  polytope.vertices.push_back({4, -0.25, 0});
  polytope.faces[kFaceAtMaxX] = {1, 3, 5, 7, 8};
  polytope.faces.push_back({7, 1, 8});
  EXPECT_EQ(refusal(polytope), Refusal::polytope_not_convex);
  polytope.vertices[8].y = -1;  // on the edge 7 - 1: no notch
  EXPECT_EQ(refusal(polytope), Refusal::none);
}

TEST(PolytopeRefusal, MissingFaces) {
  for (const Polytope& whole : {kCube, kTriangulated}) {
    for (std::size_t face = 0; face < whole.faces.size(); ++face) {
      Polytope open = whole;
      open.faces.erase(open.faces.begin() + static_cast<std::ptrdiff_t>(face));
      EXPECT_EQ(refusal(open), Refusal::polytope_not_closed) << face;
    }
  }
}

TEST(PolytopeRefusal, FacesGivenTwice) {
  for (const Polytope& whole : {kCube, kTriangulated}) {
    for (std::size_t face = 0; face < whole.faces.size(); ++face) {
      Polytope doubled = whole;
      doubled.faces.push_back(whole.faces[face]);
      EXPECT_EQ(refusal(doubled), Refusal::polytope_not_closed) << face;
      std::ranges::reverse(doubled.faces.back());
      EXPECT_EQ(refusal(doubled), Refusal::polytope_not_closed) << face;
    }
  }
}

TEST(PolytopeRefusal, OverlappingPatches) {
  Polytope crossed = kCube;  // both halves are on the same side of the diagonal
  crossed.faces[kFaceAtMaxX] = {1, 3, 5};
  crossed.faces.push_back({1, 3, 7});
  EXPECT_EQ(refusal(crossed), Refusal::polytope_not_closed);
  // With its copy, the patch has two faces at every edge.
  Polytope patched = kCube;
  patched.vertices.insert(patched.vertices.end(), {{4, 0, 0}, {4, 0.5, 0}, {4, 0, 0.5}});
  patched.faces.push_back({8, 9, 10});
  EXPECT_EQ(refusal(patched), Refusal::polytope_not_closed);
  patched.faces.push_back({8, 10, 9});
  EXPECT_EQ(refusal(patched), Refusal::polytope_not_closed);
}

TEST(PolytopeRefusal, FlatSolids) {
  const std::vector<std::uint32_t> face = kCube.faces[0], back(face.rbegin(), face.rend());
  EXPECT_EQ(refusal({kCube.vertices, {face}}), Refusal::polytope_not_closed);
  const std::vector<Vec3> square{{2, -1, -1}, {2, 1, -1}, {2, 1, 1}, {2, -1, 1}};
  EXPECT_EQ(refusal({square, {{0, 1, 2, 3}}}), Refusal::polytope_not_convex);
  EXPECT_EQ(refusal({square, {{0, 1, 2, 3}, {3, 2, 1, 0}}}), Refusal::polytope_not_convex);
  EXPECT_EQ(refusal({kCube.vertices, {face, back}}), Refusal::polytope_not_closed);
  Polytope pressed = kCube;
  for (Vec3& v : pressed.vertices) v.z = 1;
  EXPECT_EQ(refusal(pressed), Refusal::polytope_not_convex);
  const std::vector<Vec3> line{{2, 0, 0}, {2, 1, 0}, {2, 2, 0}};
  EXPECT_EQ(refusal({line, {{0, 1, 2}, {2, 1, 0}}}), Refusal::polytope_not_closed);
  // The polytope is flat except for an ulp.
  const std::vector<Vec3> thin{{2, -1, -1}, {2, 1, -1}, {2, 0, 1}, {up(2), 0, 0}};
  EXPECT_EQ(refusal({thin, {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}}), Refusal::none);
}

Refusal from(const Viewpoint& viewpoint) {
  const auto made = ConvexPolytope::make(kCube);
  const Refusal farthest = ShadowFrustum::make(viewpoint, *made.polytope, Near::farthest).refusal;
  EXPECT_EQ(farthest, ShadowFrustum::make(viewpoint, *made.polytope, Near::surface).refusal);
  return farthest;
}

TEST(PolytopeRefusal, ViewpointsInThePolytope) {
  const auto eye = [](double x, double y, double z) { return from(Viewpoint::eye({x, y, z})); };
  EXPECT_EQ(eye(3, 0, 0), Refusal::eye_in_polytope);
  EXPECT_EQ(eye(2, 0, 0), Refusal::eye_in_polytope) << "on a face";
  EXPECT_EQ(eye(4, 0.5, 0), Refusal::eye_in_polytope) << "on a face";
  EXPECT_EQ(eye(3, 1, 1), Refusal::eye_in_polytope) << "on an edge";
  EXPECT_EQ(eye(2, -1, -1), Refusal::eye_in_polytope) << "at a vertex";
  EXPECT_EQ(eye(up(2), 0, 0), Refusal::eye_in_polytope) << "an ulp behind a face";
  EXPECT_EQ(eye(down(2), 0, 0), Refusal::none) << "an ulp before a face";
  EXPECT_EQ(eye(3, up(1), 1), Refusal::none) << "an ulp off an edge, on a face's plane";
  EXPECT_EQ(eye(down(2), -1, -1), Refusal::none) << "an ulp off a vertex, on an edge's line";
  EXPECT_EQ(eye(2, down(-1), down(-1)), Refusal::none) << "an ulp off a vertex";
  EXPECT_EQ(eye(2, 5, 0), Refusal::none) << "on a face's plane";
}

TEST(PolytopeRefusal, NumbersOfViewpoints) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(from(Viewpoint::eye({0, kNan, 0})), Refusal::not_finite);
  EXPECT_EQ(from(Viewpoint::eye({0, 0x1p101, 0})), Refusal::out_of_range);
  EXPECT_EQ(from(Viewpoint::eye({0, 0x1p100, 0})), Refusal::none);
  EXPECT_EQ(from(Viewpoint::direction({0, 0, 0})), Refusal::zero_direction);
  EXPECT_EQ(from(Viewpoint::direction({0, 0, 0x1p-101})), Refusal::out_of_range);
  EXPECT_EQ(from(Viewpoint::direction({0, 0, 0x1p-100})), Refusal::none);
}

/// Checks the hand cases of the cube with its polytope written in another way.
template <class Rewrite>
void expect_same_answers(const Rewrite& rewrite) {
  for (const char* place : {"cube_ahead", "cube_across", "cube_eye", "cube_along"}) {
    const std::vector<HandCase> rows = hand_cases(place);
    EXPECT_FALSE(rows.empty()) << place;
    for (HandCase row : rows) {
      rewrite(std::get<Polytope>(row.question.occluder));
      const auto made = cases::make_frustum(row.question);
      ASSERT_TRUE(made.frustum) << row.id << ": " << to_string(made.refusal);
      EXPECT_EQ(to_string(cases::overlap(*made.frustum, row.question.box).relation), to_string(row.relation)) << row.id;
    }
  }
}

TEST(PolytopeSpelling, FacesMayTurnEitherWay) {
  expect_same_answers([](Polytope& polytope) {
    for (auto& face : polytope.faces) std::ranges::reverse(face);
  });
  expect_same_answers([](Polytope& polytope) { std::ranges::reverse(polytope.faces[1]); });
}

TEST(PolytopeSpelling, FacesMayBeginAnywhereAndComeInAnyOrder) {
  expect_same_answers([](Polytope& polytope) {
    for (auto& face : polytope.faces) std::rotate(face.begin(), face.begin() + 1, face.end());
    std::ranges::reverse(polytope.faces);
  });
}

TEST(PolytopeSpelling, VerticesMayBeRepeated) {
  // Every face has vertices of its own, as in a triangle soup, and one corner twice.
  expect_same_answers([](Polytope& polytope) {
    const Polytope shared = polytope;
    for (auto& face : polytope.faces) {
      for (auto& i : face) {
        polytope.vertices.push_back(shared.vertices[i]);
        i = static_cast<std::uint32_t>(polytope.vertices.size() - 1);
      }
      face.push_back(face.back());
    }
  });
}

TEST(PolytopeSpelling, VerticesMayLieOnEdges) {
  // The middle of the edge 0 - 2, which is in faces 0 and 2: as a T-junction in either, and in both.
  for (const std::vector<std::size_t>& faces : {std::vector<std::size_t>{0}, {2}, {0, 2}}) {
    expect_same_answers([&](Polytope& polytope) {
      const Vec3 a = polytope.vertices[0], b = polytope.vertices[2];
      polytope.vertices.push_back({(a.x + b.x) / 2, (a.y + b.y) / 2, (a.z + b.z) / 2});
      for (const std::size_t face : faces) polytope.faces[face].insert(polytope.faces[face].begin() + 1, 8);
    });
  }
}

TEST(PolytopeSpelling, FacesMayBeCutAndFlatFacesCount) {
  expect_same_answers([](Polytope& polytope) {
    polytope.faces[kFaceAtMaxX] = {1, 3, 5};
    polytope.faces.push_back({1, 5, 7});
  });
  expect_same_answers([](Polytope& polytope) { polytope.faces.push_back({1, 1, 3}); });
}

}  // namespace polytope_refusal_test
