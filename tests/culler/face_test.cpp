// SPDX-License-Identifier: MIT
// Faces on a lattice: all areas are exact.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <numeric>
#include <string>
#include <vector>

#include "occlude/culler/polygon_soup.h"
#include "random_faces.h"

namespace face_test {

using namespace occlude::culler;

std::vector<std::uint32_t> loop_of(const Face& face) {
  std::vector<std::uint32_t> loop(face.size());
  std::iota(loop.begin(), loop.end(), 0U);
  return loop;
}
auto triangles_of(const Face& face) { return triangles_of_face(face, loop_of(face)); }
bool is_fan(const Face& face) { return fan_is_face(face, loop_of(face)); }

/// Of a face that is largest as seen along z, that its triangles are the face. Returns whether there are any.
bool expect_the_face(const Face& face) {
  const auto triangles = triangles_of(face);
  if (!triangles) return false;
  const double side = area(face) < 0 ? -1 : 1;
  double sum = 0;
  using Edge = std::pair<std::array<double, 3>, std::array<double, 3>>;
  std::map<Edge, int> edges;  // how often more in this direction than in the other
  const auto add = [&](const glm::dvec3& a, const glm::dvec3& b, int times) {
    const std::array<double, 3> from{a.x, a.y, a.z}, to{b.x, b.y, b.z};
    (from < to ? edges[{from, to}] : edges[{to, from}]) += from < to ? times : -times;
  };
  for (const auto& [a, b, c] : *triangles) {
    const double own = side * area(face.at(a), face.at(b), face.at(c));
    EXPECT_GE(own, 0);
    sum += own;
    add(face[a], face[b], 1);
    add(face[b], face[c], 1);
    add(face[c], face[a], 1);
  }
  EXPECT_EQ(sum, side * area(face));
  for (std::size_t i = 0; i < face.size(); ++i) add(face[i], face[(i + 1) % face.size()], -1);
  // Edges in one line may be divided otherwise.
  std::erase_if(edges, [](const auto& edge) { return edge.second == 0; });
  double rest_x = 0, rest_y = 0;
  for (const auto& [edge, times] : edges) {
    rest_x += times * (edge.second[0] - edge.first[0]);
    rest_y += times * (edge.second[1] - edge.first[1]);
  }
  EXPECT_EQ(rest_x, 0);
  EXPECT_EQ(rest_y, 0);
  return true;
}

struct Case {
  std::string name;
  Face face;
  bool has_fan, has_triangles;
};

std::vector<Case> cases() {
  return {
      {"triangle", {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}, true, true},
      {"square", {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, true, true},
      {"square, clockwise", {{0, 0, 0}, {0, 4, 0}, {4, 4, 0}, {4, 0, 0}}, true, true},
      {"collinear corner", {{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, true, true},
      {"begun at a collinear corner", {{2, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0}}, true, true},
      {"repeated corners", {{0, 0, 0}, {0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0}}, true, true},
      {"dart, begun at its notch", {{1, 1, 0}, {4, 0, 0}, {0, 0, 0}, {0, 4, 0}}, true, true},
      {"dart, begun opposite", {{0, 0, 0}, {0, 4, 0}, {1, 1, 0}, {4, 0, 0}}, true, true},
      {"dart, begun beside its notch", {{4, 0, 0}, {0, 0, 0}, {0, 4, 0}, {1, 1, 0}}, false, true},
      {"dart, its notch on the edge", {{4, 0, 0}, {0, 0, 0}, {0, 4, 0}, {2, 2, 0}}, true, true},
      {"doorway", {{0, 0, 0}, {4, 0, 0}, {4, 8, 0}, {6, 8, 0}, {6, 0, 0}, {10, 0, 0}, {10, 10, 0}, {0, 10, 0}}, false, true},
      {"window by a keyhole",
       {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {0, 0, 0}, {3, 3, 0}, {3, 6, 0}, {6, 6, 0}, {6, 3, 0}, {3, 3, 0}},
       false,
       true},
      {"two windows by keyholes from one corner",
       {{0, 0, 0},
        {9, 0, 0},
        {9, 9, 0},
        {0, 9, 0},
        {0, 0, 0},
        {1, 2, 0},
        {1, 4, 0},
        {3, 4, 0},
        {3, 2, 0},
        {1, 2, 0},
        {0, 0, 0},
        {4, 1, 0},
        {4, 3, 0},
        {6, 3, 0},
        {6, 1, 0},
        {4, 1, 0}},
       false,
       true},
      {"window that touches a corner",
       {{0, 0, 0}, {9, 0, 0}, {9, 9, 0}, {0, 9, 0}, {0, 0, 0}, {2, 5, 0}, {5, 2, 0}},
       false,
       true},
      {"window that touches an edge",
       {{0, 0, 0}, {4, 0, 0}, {3, 3, 0}, {5, 3, 0}, {4, 0, 0}, {8, 0, 0}, {8, 8, 0}, {0, 8, 0}},
       false,
       true},
      {"spike", {{0, 0, 0}, {4, 0, 0}, {8, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, true, true},
      {"two squares that share a corner",
       {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {4, 2, 0}, {4, 4, 0}, {2, 4, 0}, {2, 2, 0}, {0, 2, 0}},
       false,
       true},
      {"bow tie", {{0, 0, 0}, {4, 4, 0}, {4, 0, 0}, {0, 5, 0}}, false, false},
      {"star of five points, which winds twice round its middle",
       {{0, 9, 0}, {-5, -8, 0}, {9, 3, 0}, {-9, 3, 0}, {5, -8, 0}},
       false,
       false},
      {"a square, passed twice",
       {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}},
       true,
       true},
      {"no area", {{0, 0, 0}, {4, 0, 0}, {8, 0, 0}, {2, 0, 0}}, true, true},
      {"a point", {{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}}, true, true},
  };
}

/// The same face as seen along another axis, and turned over by a mirror.
Face permuted(const Face& face, int by, bool is_mirrored) {
  Face result;
  for (const glm::dvec3& v : face) {
    glm::dvec3 moved;
    for (int axis = 0; axis < 3; ++axis) moved[(axis + by) % 3] = v[axis];
    result.push_back(is_mirrored ? -moved : moved);
  }
  return result;
}

/// The same face, passed the other way.
Face turned(Face face) {
  std::reverse(face.begin() + 1, face.end());
  return face;
}

TEST(Face, FanAndTrianglesOfShapes) {
  for (const auto& [name, face, has_fan, has_triangles] : cases()) {
    SCOPED_TRACE(name);
    EXPECT_EQ(is_fan(face), has_fan);
    EXPECT_EQ(expect_the_face(face), has_triangles);
    EXPECT_EQ(is_fan(turned(face)), has_fan);
    EXPECT_EQ(expect_the_face(turned(face)), has_triangles);
    for (const int by : {0, 1, 2}) {
      for (const bool is_mirrored : {false, true}) {
        const Face copy = permuted(face, by, is_mirrored);
        EXPECT_EQ(is_fan(copy), has_fan);
        EXPECT_EQ(triangles_of(copy), triangles_of(face));
      }
    }
  }
}

constexpr std::uint64_t kSeeds = 2000;

TEST(Face, TrianglesOfEveryOutline) {
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    EXPECT_TRUE(expect_the_face(RandomFaces(seed).outline(4, 34)));
  }
}

TEST(Face, TrianglesOfEveryFaceWithOpenings) {
  std::size_t corners = 0;
  for (std::uint64_t seed = 1; seed <= kSeeds; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    const Face face = RandomFaces(seed).with_openings().loop;
    EXPECT_TRUE(expect_the_face(face));
    EXPECT_TRUE(expect_the_face(turned(face)));
    corners += face.size();
  }
  EXPECT_GT(corners, 15 * kSeeds) << "openings are found";
}

/// A comb: every second corner is concave, and is asked about by each ear.
TEST(Face, TheWorkIsBounded) {
  for (const bool is_long : {false, true}) {
    const int teeth = is_long ? 20'000 : 1000;
    Face face{{0, -1, 0}};
    for (int i = 0; i < teeth; ++i) {
      face.push_back({2.0 * i, 1000, 0});
      face.push_back({2.0 * i + 1, 0, 0});
    }
    face.push_back({2.0 * teeth, -1, 0});
    EXPECT_EQ(triangles_of(face).has_value(), !is_long) << "long ones are given up";
  }
}

}  // namespace face_test
