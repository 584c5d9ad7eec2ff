// SPDX-License-Identifier: MIT
// Triangles on others: with seams, overlaps, holes, and an ulp beside them.
#include "occlude/oracle/faces.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "oracle/vocabulary.h"

namespace occlude::oracle {
namespace faces_test {

/// The plane x + 2 y + 4 z = 0, by x and y.
Point on(double x, double y) { return {x, y, -(x + 2 * y) / 4}; }

/// The squares of a board of n x n in that plane, two triangles each, without those at the places (x, y).
std::vector<Triangle> board(int n, const std::vector<std::array<int, 2>>& without = {}) {
  std::vector<Triangle> faces;
  for (int x = 0; x < n; ++x) {
    for (int y = 0; y < n; ++y) {
      if (std::ranges::find(without, std::array{x, y}) != without.end()) continue;
      faces.push_back({on(x, y), on(x + 1, y), on(x + 1, y + 1)});
      faces.push_back({on(x, y), on(x + 1, y + 1), on(x, y + 1)});
    }
  }
  return faces;
}

const char* const kHole = "a part of it is on no face";
const char* const kNoPlane = "no face lies in its plane and turns its way";

TEST(OnFaces, WhatTheyCoverTogether) {
  EXPECT_EQ(refute_on_faces(board(4), {on(0, 0), on(4, 0), on(4, 4)}), "");
  EXPECT_EQ(refute_on_faces(board(4), {on(0.5, 0.25), on(3.75, 0), on(1, 4)}), "");
  EXPECT_EQ(refute_on_faces(board(1), {on(0, 0), on(1, 0), on(1, 1)}), "");
  EXPECT_EQ(refute_on_faces(board(4), {on(0, 0), on(above(4), 0), on(4, 4)}), kHole) << "an ulp over the border";
  EXPECT_EQ(refute_on_faces(board(4), {on(0, 0), on(4.125, 0), on(4, 4)}), kHole);
  EXPECT_EQ(refute_on_faces(board(4), {on(5, 5), on(9, 5), on(9, 9)}), kNoPlane) << "none is near";
}

TEST(OnFaces, AHoleIsNoFace) {
  const std::vector<Triangle> faces = board(5, {{2, 2}});
  EXPECT_EQ(refute_on_faces(faces, {on(2, 2), on(3, 2), on(3, 3)}), kHole);
  EXPECT_EQ(refute_on_faces(faces, {on(0, 0), on(5, 0), on(5, 5)}), kHole);
  EXPECT_EQ(refute_on_faces(faces, {on(0, 0), on(4.5, 0), on(4.5, 3)}), "") << "it touches the hole";
  EXPECT_EQ(refute_on_faces(faces, {on(0, 0), on(4.5, 0), on(4.5, 3.0625)}), kHole);
}

TEST(OnFaces, AnUlpBesideThemIsNotOnThem) {
  const Triangle good{on(0, 0), on(4, 0), on(4, 4)};
  for (std::size_t corner = 0; corner < 3; ++corner) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (const bool is_up : {false, true}) {
        Triangle bad = good;
        bad[corner][axis] = is_up ? above(good[corner][axis]) : below(good[corner][axis]);
        EXPECT_EQ(refute_on_faces(board(4), bad), kNoPlane) << corner << axis << is_up;
      }
    }
  }
}

TEST(OnFaces, OverlapsSeamsAndTurns) {
  const Triangle good{on(0, 0), on(4, 0), on(4, 4)};
  std::vector<Triangle> faces{
      {on(0, 0), on(3, 0), on(3, 3)}, {on(2, 0), on(4, 0), on(4, 4)}, {on(2, 0), on(4, 4), on(2, 2)}};
  EXPECT_EQ(refute_on_faces(faces, good), "");
  faces[1][0] = on(3, 0);  // leaves a triangle below the diagonal
  faces[2] = {on(3, 0), on(4, 4), on(3, 2)};
  EXPECT_EQ(refute_on_faces(faces, good), kHole);
  faces = board(4);
  EXPECT_EQ(refute_on_faces(faces, {good[0], good[2], good[1]}), kNoPlane) << "it turns the other way";
  std::ranges::reverse(faces[0]);
  EXPECT_EQ(refute_on_faces(faces, good), kHole) << "one of them does";
}

TEST(OnFaces, WithoutArea) {
  std::vector<Triangle> faces = board(2);
  const Triangle flat{on(0, 0), on(1, 0), on(2, 0)};
  EXPECT_EQ(refute_on_faces(faces, flat), "a triangle without area is none of the faces");
  faces.push_back(flat);
  EXPECT_EQ(refute_on_faces(faces, flat), "");
  EXPECT_EQ(refute_on_faces({}, flat), "a triangle without area is none of the faces");
  EXPECT_EQ(refute_on_faces(std::vector{flat}, {on(0, 0), on(1, 0), on(1, 1)}), kNoPlane);
}

}  // namespace faces_test
}  // namespace occlude::oracle
