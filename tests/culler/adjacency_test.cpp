// SPDX-License-Identifier: MIT
#include "model/adjacency.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "scenes.h"

namespace adjacency_test {

using namespace occlude::culler;
using Loop = std::vector<glm::dvec3>;
using Sides = std::vector<std::pair<std::uint32_t, std::uint32_t>>;

constexpr glm::dvec3 a{0, 0, 0}, b{4, 0, 0}, c{4, 0, 3}, d{0, 0, 3}, below{2, 0, -3};

/// The pairs of sides that find_adjacency() finds, in its order.
Sides paired(const std::vector<Loop>& polygons) {
  PolygonSoup soup;
  for (const Loop& polygon : polygons) add(soup, polygon);
  Sides sides;
  for (const auto& [length, side, twin] : find_adjacency(soup, welded(soup.vertices))) sides.emplace_back(side, twin);
  return sides;
}

TEST(Adjacency, SidesInOppositeDirections) {
  EXPECT_EQ(paired({{a, b, c}, {c, d, a}}), (Sides{{2, 5}}));
  EXPECT_EQ(paired({{a, b, c}, {b, a, below}}), (Sides{{0, 3}}));
  EXPECT_EQ(paired({{a, b, c}, {a, b, below}}), Sides{}) << "in one direction";
  EXPECT_EQ(paired({{a, b, c}, {d, below, a}}), Sides{}) << "a corner is no side";
  EXPECT_EQ(paired({{a, b, c}, {{2, 0, 0}, a, below}}), Sides{}) << "half of it";
}

TEST(Adjacency, NotWithAThirdThere) {
  const Loop third{b, a, {2, 1, 0}};
  EXPECT_EQ(paired({{a, b, c}, {b, a, below}, third}), Sides{});
  EXPECT_EQ(paired({{a, b, c}, {b, a, below}, third, {a, b, {2, -1, 0}}}), Sides{}) << "nor with a fourth";
  EXPECT_EQ(paired({{a, b, c}, {a, b, c}, {c, b, below}}), Sides{}) << "one on the other";
}

TEST(Adjacency, ByEqualCoordinates) {
  EXPECT_EQ(paired({{{-0.0, 0, -0.0}, b, c}, {c, d, a}}), (Sides{{2, 5}})) << "-0 is 0";
  EXPECT_EQ(paired({{{0x1p-100, 0, 0}, b, c}, {c, d, a}}), Sides{}) << "and nothing else is";
}

TEST(Adjacency, RepeatedCornersHaveNoSide) {
  EXPECT_EQ(paired({{a, a, b, c}, {c, c, d, a}}), (Sides{{3, 7}}));
  EXPECT_EQ(paired({{a, a, a}, {a, a, a}}), Sides{});
}

/// A loop that goes along an edge and back pairs its own sides.
TEST(Adjacency, WithinOnePolygon) { EXPECT_EQ(paired({{a, b, a, d}}), (Sides{{0, 1}, {2, 3}})); }

TEST(Adjacency, TheLongestFirst) {
  PolygonSoup soup;
  add_box(soup, {0, 0, 0}, {2, 3, 5}, true);
  const std::vector<SidePair> pairs = find_adjacency(soup, welded(soup.vertices));
  ASSERT_EQ(pairs.size(), 18U);
  std::vector<double> lengths;
  for (const SidePair& pair : pairs) lengths.push_back(pair.length);
  EXPECT_EQ(lengths, (std::vector<double>{34, 34, 29, 29, 25, 25, 25, 25, 13, 13, 9, 9, 9, 9, 4, 4, 4, 4}));
  for (const auto& [length, side, twin] : pairs) EXPECT_NE(side / 3, twin / 3);
}

std::vector<bool> repeated(const std::vector<Loop>& polygons) {
  PolygonSoup soup;
  for (const Loop& polygon : polygons) add(soup, polygon);
  return find_repeated(soup, welded(soup.vertices));
}

TEST(Repeated, NotWhereTheFirstIsSeeThrough) {
  PolygonSoup soup;
  add(soup, {a, b, c});
  soup.see_through_from(0);
  for (int i = 0; i < 2; ++i) add(soup, {c, b, a});
  EXPECT_EQ(find_repeated(soup, welded(soup.vertices)), (std::vector{false, false, true}));
}

TEST(Repeated, WhereverTheLoopBeginsAndWhicheverWayRound) {
  EXPECT_EQ(repeated({{a, b, c}, {b, c, a}, {c, b, a}, {a, b, d}}), (std::vector{false, true, true, false}));
  EXPECT_EQ(repeated({{a, b, c, d}, {c, b, a, d}, {a, c, b, d}, {a, b, c}}), (std::vector{false, true, false, false}));
  EXPECT_EQ(repeated({{{-0.0, 0, 0}, b, c}, {a, b, c}}), (std::vector{false, true})) << "-0 is 0";
}

TEST(Repeated, WhatDiffersInItsLastCorners) {
  const glm::dvec3 e{2, 0, 5}, f{2, 0, 6};
  EXPECT_EQ(repeated({{a, b, c, e, d}, {a, b, c, f, d}, {d, e, c, b, a}}), (std::vector{false, false, true}));
}

/// More polygons than are sorted in one piece.
TEST(Repeated, OneOfVeryMany) {
  constexpr std::size_t kCopies = 100000;
  const std::vector<bool> is_repeated = repeated(std::vector<Loop>(kCopies, {c, a, b}));
  EXPECT_EQ(std::count(is_repeated.begin(), is_repeated.end(), true), std::ptrdiff_t{kCopies - 1});
  EXPECT_FALSE(is_repeated[0]);
}

}  // namespace adjacency_test
