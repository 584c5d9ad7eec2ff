// SPDX-License-Identifier: MIT
// Boxes in a tetrahedron and in two.
#include "occlude/oracle/solid.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "oracle/vocabulary.h"

namespace occlude::oracle {
namespace solid_test {

/// x, y, z >= 0, x + y + z <= size.
std::vector<Triangle> tetrahedron(double size) {
  const Point o{0, 0, 0}, x{size, 0, 0}, y{0, size, 0}, z{0, 0, size};
  return {{o, y, x}, {o, x, z}, {o, z, y}, {x, y, z}};
}

TEST(InnerBox, InATetrahedron) {
  const std::vector<Triangle> solid = tetrahedron(3);
  EXPECT_EQ(refute_inner_box(solid, {{0, 0, 0}, {1, 1, 1}}), "") << "it touches";
  EXPECT_EQ(refute_inner_box(solid, {{0, 0, 0}, {1, 1, above(1)}}), "triangle 3 comes into the box");
  EXPECT_EQ(refute_inner_box(solid, {{below(0), 0, 0}, {1, 1, 1}}), "triangle 2 comes into the box");
  EXPECT_EQ(refute_inner_box(solid, {{1, 1, 1}, {2, 2, 2}}), "the box is outside");
  EXPECT_EQ(refute_inner_box(solid, {{-2, -2, -2}, {0, 0, 0}}), "the box is outside");
  EXPECT_EQ(refute_inner_box(solid, {{-9, -9, -9}, {9, 9, 9}}), "triangle 0 comes into the box");
  EXPECT_EQ(refute_inner_box(solid, {{0, 0, 0}, {1, 1, 0}}), "the box is flat");
}

TEST(InnerBox, ModuloTwo) {
  std::vector<Triangle> solid = tetrahedron(9);
  for (const Triangle& triangle : tetrahedron(3)) solid.push_back(triangle);
  EXPECT_EQ(refute_inner_box(solid, {{0, 0, 0}, {1, 1, 1}}), "the box is outside");
  EXPECT_EQ(refute_inner_box(solid, {{1, 1, 1}, {3, 3, 3}}), "");
  solid.pop_back();
  EXPECT_EQ(refute_inner_box(solid, {{1, 1, 1}, {3, 3, 3}}), "the surface is not closed");
  EXPECT_EQ(refute_inner_box({}, {{1, 1, 1}, {3, 3, 3}}), "the box is outside");
}

TEST(InnerBox, SegmentsCountToo) {
  std::vector<Triangle> solid = tetrahedron(9);
  solid.push_back({Point{0, 0, 0}, Point{4, 4, 4}, Point{0, 0, 0}});
  EXPECT_EQ(refute_inner_box(solid, {{1, 1, 1}, {2, 2, 2}}), "triangle 4 comes into the box");
  EXPECT_EQ(refute_inner_box(solid, {{1, 2, 1}, {2, 3, 2}}), "");
}

TEST(HalfFace, OfABox) {
  const Aabb box{{0, 0, 0}, {1, 2, 3}};
  EXPECT_EQ(refute_half_face(box, {Point{1, 0, 0}, Point{1, 2, 0}, Point{1, 2, 3}}), "");
  EXPECT_EQ(refute_half_face(box, {Point{0, 0, 0}, Point{0, 2, 3}, Point{0, 2, 0}}), "");
  EXPECT_EQ(refute_half_face(box, {Point{1, 0, 0}, Point{1, 2, 3}, Point{1, 2, 0}}), "turned inwards");
  EXPECT_EQ(refute_half_face(box, {Point{0, 0, 0}, Point{1, 2, 0}, Point{1, 2, 3}}), "on no face of the box");
  EXPECT_EQ(refute_half_face(box, {Point{1, 0, 0}, Point{1, 0, 0}, Point{1, 2, 3}}), "turned inwards") << "no area";
  EXPECT_EQ(refute_half_face(box, {Point{1, 0, 0}, Point{1, 2, 0}, Point{1, 2, above(3)}}),
            "not between corners of the box");
}

}  // namespace solid_test
}  // namespace occlude::oracle
