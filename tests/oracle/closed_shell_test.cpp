// SPDX-License-Identifier: MIT
// Triangles in cubes.
#include "occlude/oracle/closed_shell.h"

#include <gtest/gtest.h>

#include <array>
#include <random>
#include <vector>

#include "occlude/oracle/solid.h"
#include "oracle/vocabulary.h"
#include "seed.h"

namespace occlude::oracle {
namespace closed_shell_test {

constexpr const char *kMet = "the shell meets it", *kOutside = "it is outside of the shell";

/// The sides of the cube from `low` to `high` on each axis, of two triangles each, corners first along x.
std::vector<Triangle> cube(double low, double high) {
  const auto at = [&](unsigned i) { return Point{i & 1U ? high : low, i & 2U ? high : low, i & 4U ? high : low}; };
  std::vector<Triangle> triangles;
  for (const auto& [a, b, c, d] : std::vector<std::array<unsigned, 4>>{
           {0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}) {
    triangles.push_back({at(a), at(b), at(c)});
    triangles.push_back({at(a), at(c), at(d)});
  }
  return triangles;
}

TEST(ClosedShell, HasWhatDoesNotTouchIt) {
  const ClosedShell shell(cube(0, 8));
  EXPECT_EQ(shell.fault(), "");
  const Triangle in{Point{1, 1, 1}, Point{7, 2, 1}, Point{1, 7, 7}};
  EXPECT_EQ(shell.refute_inside(in, false), "");
  EXPECT_EQ(shell.refute_inside(in, true), "");
  const Triangle level{Point{1, 1, 4}, Point{7, 1, 4}, Point{1, 7, 4}}, segment{in[0], in[1], in[1]},
      point{in[0], in[0], in[0]};
  for (const Triangle& triangle : {level, segment, point}) EXPECT_EQ(shell.refute_inside(triangle, false), "");
  EXPECT_EQ(shell.refute_inside({Point{9, 1, 1}, Point{9, 2, 1}, Point{9, 1, 2}}, true), kOutside);
  EXPECT_EQ(shell.refute_inside({Point{-9, 4, 4}, Point{-8, 4, 4}, Point{-9, 5, 4}}, true), kOutside) << "two sides ahead";
  EXPECT_EQ(shell.refute_inside({in[0], in[1], Point{9, 1, 1}}, true), kMet);
  EXPECT_EQ(shell.refute_inside({Point{-20, -20, 1}, Point{40, -20, 1}, Point{-20, 40, 1}}, true), kMet) << "around it";
}

/// Walls from edge to edge, with corners on sides, and in a side.
TEST(ClosedShell, MayTouchBorders) {
  const ClosedShell shell(cube(0, 8));
  const auto expect = [&](const Triangle& triangle, const char* apart, const char* without_borders) {
    EXPECT_EQ(shell.refute_inside(triangle, false), apart);
    EXPECT_EQ(shell.refute_inside(triangle, true), without_borders);
  };
  expect({Point{0, 0, 4}, Point{8, 0, 4}, Point{8, 8, 4}}, kMet, "");
  expect({Point{0, 0, 0}, Point{8, 8, 0}, Point{8, 8, 8}}, kMet, "");
  expect({Point{4, 4, 0}, Point{4, 5, 4}, Point{5, 4, 4}}, kMet, "");
  expect({Point{4, 4, below(0)}, Point{4, 5, 4}, Point{5, 4, 4}}, kMet, kMet);
  expect({Point{4, 4, above(0)}, Point{4, 5, 4}, Point{5, 4, 4}}, "", "");
  expect({Point{0, 0, 0}, Point{8, 0, 0}, Point{8, 8, 0}}, kMet, kMet);
  expect({Point{1, 1, 0}, Point{2, 1, 0}, Point{1, 2, 0}}, kMet, kMet);
  expect({Point{0, 0, 0}, Point{8, 8, 8}, Point{8, 8, 8}}, kMet, "");
  expect({Point{8, 0, 0}, Point{8, 8, 0}, Point{16, 0, 0}}, kMet, kOutside);
}

TEST(ClosedShell, ModuloTwo) {
  std::vector<Triangle> triangles = cube(0, 8);
  const Triangle in{Point{1, 1, 1}, Point{1.5, 1, 1}, Point{1, 1.5, 1}},
      deep{Point{3, 3, 3}, Point{4, 3, 3}, Point{3, 4, 3}};
  for (const Triangle& triangle : cube(2, 6)) triangles.push_back(triangle);
  const ClosedShell both(triangles);
  EXPECT_EQ(both.refute_inside(in, false), "");
  EXPECT_EQ(both.refute_inside(deep, false), kOutside);
  triangles.pop_back();
  EXPECT_EQ(ClosedShell(triangles).fault(), "the shell is not closed");
  EXPECT_EQ(ClosedShell({}).refute_inside(in, false), kOutside);
}

/// The same as by rational numbers, on a small grid where everything touches.
TEST(ClosedShell, AgreesWithRationalNumbers) {
  std::mt19937 random(seed_of(8201));
  const auto coordinate = [&](unsigned low, unsigned count) { return static_cast<double>(low + random() % count); };
  const auto corner = [&] { return Point{coordinate(0, 9), coordinate(0, 9), coordinate(0, 9)}; };
  std::size_t inside = 0;
  for (int trial = 0; trial < 300; ++trial) {
    // A tetrahedron, and in every second trial a cube around part of it.
    const Point a = corner(), b = corner(), c = corner(), d = corner();
    std::vector<Triangle> triangles{{a, b, c}, {a, b, d}, {a, c, d}, {b, c, d}};
    if (trial % 2 == 0) {
      for (const Triangle& triangle : cube(1, 7)) triangles.push_back(triangle);
    }
    const ClosedShell shell(triangles);
    ASSERT_EQ(shell.fault(), "");
    for (int i = 0; i < 20; ++i) {
      const unsigned low = i % 2 == 0 ? 0 : 2, count = i % 2 == 0 ? 9 : 5;
      const auto near = [&] { return Point{coordinate(low, count), coordinate(low, count), coordinate(low, count)}; };
      const Triangle asked{near(), near(), near()};
      const std::string rational = refute_inner_triangle(triangles, asked);
      if (rational == "the triangle has no area" || rational == "no ray misses all edges") continue;
      const std::string found = shell.refute_inside(asked, false);
      EXPECT_EQ(found.empty(), rational.empty()) << found << "; " << rational;
      inside += rational.empty() ? 1 : 0;
      if (found.empty()) {
        EXPECT_EQ(shell.refute_inside(asked, true), "");
      }
    }
  }
  EXPECT_GT(inside, 20U);
}

}  // namespace closed_shell_test
}  // namespace occlude::oracle
