// SPDX-License-Identifier: MIT
#include "frusta/convex_shells.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/vec2.hpp>
#include <limits>
#include <vector>

#include "model/adjacency.h"
#include "scenes.h"

namespace convex_shells_test {

using namespace occlude::culler;
using Indices = std::vector<std::uint32_t>;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

ConvexShells find_shells(SoupView soup) { return ConvexShells::find(soup, find_adjacency(soup, welded(soup.vertices))); }

Indices parts(const ConvexShells& shells, std::size_t s) {
  const auto span = shells.parts(s);
  return {span.begin(), span.end()};
}

PolygonSoup box(bool triangles) {
  PolygonSoup soup;
  add_box(soup, {0, 0, 0}, {2, 3, 5}, triangles);
  return soup;
}

/// The box without the last of its polygons.
PolygonSoup open_box(bool triangles) {
  const PolygonSoup whole = box(triangles);
  PolygonSoup soup;
  soup.vertices = whole.vertices;
  for (std::size_t p = 0; p + 1 < whole.size(); ++p) soup.add_polygon(whole.loop(p));
  return soup;
}

/// A prism over a convex polygon with this many sides.
PolygonSoup prism(std::uint32_t sides) {
  PolygonSoup soup;
  for (std::uint32_t i = 0; i < sides; ++i) {
    // Points of a parabola: convex without rounding.
    const double x = static_cast<double>(i) - (sides - 1) / 2.0;
    soup.add_vertex({x, x * x, 0});
    soup.add_vertex({x, x * x, 7});
  }
  Indices bottom, top;
  for (std::uint32_t i = 0; i < sides; ++i) {
    const std::uint32_t next = (i + 1) % sides;
    soup.add_polygon(Indices{2 * i, 2 * next, 2 * next + 1, 2 * i + 1});
    bottom.insert(bottom.begin(), 2 * i);
    top.push_back(2 * i + 1);
  }
  soup.add_polygon(bottom);
  soup.add_polygon(top);
  return soup;
}

TEST(ConvexShells, ABoxOfQuadrilateralsOrTriangles) {
  for (const bool triangles : {false, true}) {
    const PolygonSoup soup = box(triangles);
    const ConvexShells shells = find_shells(soup);
    ASSERT_EQ(shells.size(), 1U);
    EXPECT_EQ(shells.parts(0).size(), soup.size());
    EXPECT_EQ(shells.polytope(0).vertices().size(), 8U);
    EXPECT_EQ(shells.polytope(0).faces().size(), 6U) << "triangles are halves of a face";
    EXPECT_EQ(shells.polytope(0).edges().size(), 12U);
    for (std::uint32_t p = 0; p < soup.size(); ++p) EXPECT_EQ(shells.shell_of(p), 0U);
  }
}

TEST(ConvexShells, VerticesOfTheSoupAreFoundByTheirCoordinates) {
  const PolygonSoup shared = box(false);
  PolygonSoup soup;
  for (std::size_t p = 0; p < shared.size(); ++p) {
    std::vector<glm::dvec3> loop;
    for (const std::uint32_t i : shared.loop(p)) loop.push_back(shared.vertices[i]);
    add(soup, loop);
  }
  ASSERT_EQ(soup.vertices.size(), 24U);
  const ConvexShells shells = find_shells(soup);
  ASSERT_EQ(shells.size(), 1U);
  EXPECT_EQ(shells.polytope(0).edges().size(), 12U);
}

TEST(ConvexShells, InsideOut) {
  const PolygonSoup outwards = box(true);
  PolygonSoup soup;
  soup.vertices = outwards.vertices;
  for (std::size_t p = 0; p < outwards.size(); ++p) {
    const auto loop = outwards.loop(p);
    soup.add_polygon(Indices(loop.rbegin(), loop.rend()));
  }
  EXPECT_EQ(find_shells(soup).size(), 1U);
}

TEST(ConvexShells, NotWithAVertexMovedByAnUlp) {
  for (std::size_t v = 0; v < 8; ++v) {
    for (const double way : {-kInfinity, kInfinity}) {
      for (int axis = 0; axis < 3; ++axis) {
        PolygonSoup soup = box(false);
        double& x = soup.vertices[v][axis];
        x = x == 0 ? std::copysign(0x1p-52, way) : std::nextafter(x, way);
        EXPECT_EQ(find_shells(soup).size(), 0U) << "vertex " << v << " along axis " << axis;
      }
    }
  }
  // The diagonals of three faces meet at corner 7. When it moves outwards they become ridges, when it moves inwards valleys.
  PolygonSoup outwards = box(true), inwards = box(true);
  outwards.vertices[7].z = std::nextafter(outwards.vertices[7].z, kInfinity);
  inwards.vertices[7].z = std::nextafter(inwards.vertices[7].z, 0);
  EXPECT_EQ(find_shells(outwards).size(), 1U);
  EXPECT_EQ(find_shells(inwards).size(), 0U);
}

TEST(ConvexShells, NotWhatIsOpen) {
  for (const bool triangles : {false, true}) {
    PolygonSoup soup = open_box(triangles);
    EXPECT_EQ(find_shells(soup).size(), 0U);
    EXPECT_EQ(find_shells(soup).shell_of(0), ConvexShells::kNone);
    const PolygonSoup whole = box(triangles);
    const auto lid = whole.loop(whole.size() - 1);
    soup.add_polygon(Indices(lid.rbegin(), lid.rend()));
    EXPECT_EQ(find_shells(soup).size(), 0U) << "a face turned the other way";
  }
}

TEST(ConvexShells, NotWhatIsNotConvex) {
  PolygonSoup soup;
  const std::vector<glm::dvec2> base{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  for (const double z : {0.0, 1.0}) {
    for (const glm::dvec2& p : base) soup.add_vertex({p, z});
  }
  soup.add_polygon(Indices{5, 4, 3, 2, 1, 0});
  soup.add_polygon(Indices{6, 7, 8, 9, 10, 11});
  for (std::uint32_t i = 0; i < 6; ++i) soup.add_polygon(Indices{i, (i + 1) % 6, (i + 1) % 6 + 6, i + 6});
  EXPECT_EQ(find_adjacency(soup, welded(soup.vertices)).size(), 18U) << "closed it is";
  EXPECT_EQ(find_shells(soup).size(), 0U);
}

/// Four sides run along the common edge, and it is unclear which two belong together.
TEST(ConvexShells, NotTwoBoxesThatShareAnEdge) {
  PolygonSoup soup;
  soup.add_box({0, 0, 0}, {1, 1, 1});
  soup.add_box({1, 1, 0}, {2, 2, 1});
  EXPECT_EQ(find_shells(soup).size(), 0U);
}

TEST(ConvexShells, TwoBoxesThatShareACorner) {
  PolygonSoup soup;
  soup.add_box({0, 0, 0}, {1, 1, 1});
  add_box(soup, {1, 1, 1}, {2, 2, 2}, true);
  const ConvexShells shells = find_shells(soup);
  ASSERT_EQ(shells.size(), 2U);
  EXPECT_EQ(parts(shells, 0), (Indices{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(parts(shells, 1), (Indices{6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17}));
  for (std::uint32_t p = 0; p < soup.size(); ++p) EXPECT_EQ(shells.shell_of(p), p < 6 ? 0U : 1U);
}

TEST(ConvexShells, AmongOtherPolygons) {
  PolygonSoup soup;
  add_wall(soup, 0, 0, 1, 0, 1);
  soup.add_box({4, 4, 4}, {6, 6, 6});
  add_wall(soup, 5, 0, 9, 0, 9);  // through the box
  const ConvexShells shells = find_shells(soup);
  ASSERT_EQ(shells.size(), 1U);
  EXPECT_EQ(parts(shells, 0), (Indices{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(shells.shell_of(0), ConvexShells::kNone);
  EXPECT_EQ(shells.shell_of(7), ConvexShells::kNone);
  // A fence along an edge is a third side there.
  soup.add_polygon(Indices{soup.loop(1)[0], soup.loop(1)[1], soup.add_vertex({0, 0, 0})});
  EXPECT_EQ(find_shells(soup).size(), 0U);
}

TEST(ConvexShells, OfFourToSixtyFourPolygons) {
  PolygonSoup tetrahedron;
  for (const glm::dvec3& v : {glm::dvec3{0, 0, 0}, glm::dvec3{1, 0, 0}, glm::dvec3{0, 1, 0}, glm::dvec3{0, 0, 1}}) {
    tetrahedron.add_vertex(v);
  }
  for (const Indices& face : {Indices{0, 2, 1}, Indices{0, 1, 3}, Indices{0, 3, 2}, Indices{1, 2, 3}}) {
    tetrahedron.add_polygon(face);
  }
  EXPECT_EQ(find_shells(tetrahedron).size(), 1U);
  EXPECT_EQ(find_shells(prism(62)).size(), 1U);
  EXPECT_EQ(find_shells(prism(63)).size(), 0U) << "too many to ask";
  PolygonSoup flat;  // a triangle and its other side
  add(flat, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  add(flat, {{0, 1, 0}, {1, 0, 0}, {0, 0, 0}});
  EXPECT_EQ(find_shells(flat).size(), 0U);
}

TEST(ConvexShells, PolytopeOfPolygons) {
  const PolygonSoup soup = box(false);
  const occlude::kernel::Polytope solid = polytope_of(soup, Indices{1, 3});
  // Corners 1, 3, 7, 5 of the soup, then 2 and 6.
  EXPECT_EQ(solid.vertices.size(), 6U);
  EXPECT_EQ(solid.faces, (std::vector<Indices>{{0, 1, 2, 3}, {4, 5, 2, 1}}));
  EXPECT_EQ(solid.vertices[4], (occlude::kernel::Vec3{0, 3, 0}));
}

}  // namespace convex_shells_test
