// SPDX-License-Identifier: MIT
// Boxes in a tetrahedron and in two.
#include "occlude/oracle/solid.h"

#include <gtest/gtest.h>

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

TEST(InnerTriangle, InATetrahedron) {
  std::vector<Triangle> solid = tetrahedron(4);
  const Triangle in{Point{1, 1, 0.5}, Point{0.5, 1, 1}, Point{1, 0.5, 1}};
  EXPECT_EQ(refute_inner_triangle(solid, in), "");
  EXPECT_EQ(refute_inner_triangle(solid, {Point{1, 1, 0}, in[1], in[2]}), "triangle 0 meets it") << "a corner on a face";
  EXPECT_EQ(refute_inner_triangle(solid, {Point{1, 1, above(0)}, in[1], in[2]}), "");
  EXPECT_EQ(refute_inner_triangle(solid, {Point{9, 9, 9}, in[1], in[2]}), "triangle 3 meets it");
  EXPECT_EQ(refute_inner_triangle(solid, {Point{9, 1, 1}, Point{9, 2, 1}, Point{9, 1, 2}}), "the triangle is outside");
  EXPECT_EQ(refute_inner_triangle(solid, {in[0], in[1], in[1]}), "the triangle has no area");
  const Triangle around{Point{-20, -20, 1}, Point{40, -20, 1}, Point{-20, 40, 1}};
  EXPECT_EQ(refute_inner_triangle(solid, around), "triangle 1 meets it") << "its border is outside";
  for (const Point& end : {Point{0.75, 1, 0.75}, Point{0.5, 1, 1}}) {
    solid.push_back({Point{0.5, 1, 0.5}, end, Point{0.5, 1, 0.5}});
    EXPECT_EQ(refute_inner_triangle(solid, in), "triangle 4 meets it") << "a segment";
    solid.back() = {end, end, end};
    EXPECT_EQ(refute_inner_triangle(solid, in), "triangle 4 meets it") << "a point";
    solid.pop_back();
  }
  solid.pop_back();
  EXPECT_EQ(refute_inner_triangle(solid, in), "the surface is not closed");
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
