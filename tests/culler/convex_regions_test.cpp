// SPDX-License-Identifier: MIT
#include "occlude/culler/convex_regions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <span>
#include <vector>

#include "scenes.h"

namespace {

using namespace occlude::culler;
using Loop = std::vector<glm::dvec3>;

/// The corners of region r, from the least on.
ConvexRegions find_regions(const PolygonSoup& soup) { return ConvexRegions::find(soup, find_adjacency(soup)); }

Loop corners(const PolygonSoup& soup, const ConvexRegions& regions, std::size_t r) {
  Loop loop;
  for (const std::uint32_t i : regions.loop(r)) loop.push_back(soup.vertices[i]);
  const auto key = [](const glm::dvec3& v) { return std::array{v.x, v.y, v.z}; };
  std::rotate(loop.begin(), std::ranges::min_element(loop, {}, key), loop.end());  // clang 14 has no ranges::rotate
  return loop;
}

std::vector<std::uint32_t> parts(const ConvexRegions& regions, std::size_t r) {
  const auto span = regions.parts(r);
  return {span.begin(), span.end()};
}

PolygonSoup soup_of(const std::vector<Loop>& polygons) {
  PolygonSoup soup;
  for (const Loop& polygon : polygons) add(soup, polygon);
  return soup;
}

constexpr glm::dvec3 a{0, 0, 0}, b{4, 0, 0}, c{4, 0, 3}, d{0, 0, 3};

/// How many are joined of several.
std::size_t joined(const PolygonSoup& soup) {
  const ConvexRegions regions = find_regions(soup);
  std::set<std::uint32_t> wholes;
  for (std::uint32_t p = 0; p < soup.size(); ++p) {
    if (regions.whole(p) != p) wholes.insert(regions.whole(p));
  }
  return wholes.size();
}

TEST(ConvexRegions, TwoTrianglesOfARectangle) {
  const PolygonSoup soup = soup_of({{a, b, c}, {c, d, a}});
  const ConvexRegions regions = find_regions(soup);
  ASSERT_EQ(regions.size(), 3U);
  EXPECT_EQ(corners(soup, regions, 0), (Loop{a, b, c}));
  EXPECT_EQ(parts(regions, 1), (std::vector<std::uint32_t>{1}));
  EXPECT_EQ(corners(soup, regions, 2), (Loop{a, b, c, d}));
  EXPECT_EQ(parts(regions, 2), (std::vector<std::uint32_t>{0, 1}));
  EXPECT_EQ(regions.whole(0), 2U);
  EXPECT_EQ(regions.whole(1), 2U);
}

TEST(ConvexRegions, AFanBecomesThePolygonThatItIs) {
  Loop hexagon{{2, 0, 0}, {1, 0, 2}, {-1, 0, 2}, {-2, 0, 0}, {-1, 0, -2}, {1, 0, -2}};
  std::vector<Loop> triangles;
  for (std::size_t i = 1; i + 1 < hexagon.size(); ++i) triangles.push_back({hexagon[0], hexagon[i], hexagon[i + 1]});
  const ConvexRegions regions = find_regions(soup_of(triangles));
  ASSERT_EQ(regions.size(), 5U);
  EXPECT_EQ(regions.loop(4).size(), 6U);
  EXPECT_EQ(regions.parts(4).size(), 4U);
}

TEST(ConvexRegions, AStripOfTilesWithStraightCorners) {
  std::vector<Loop> tiles;
  for (double x = 0; x < 40; ++x) tiles.push_back({{x, 0, 0}, {x + 1, 0, 0}, {x + 1, 0, 1}, {x, 0, 1}});
  const ConvexRegions regions = find_regions(soup_of(tiles));
  EXPECT_GT(regions.size(), tiles.size());
  for (std::size_t r = tiles.size(); r < regions.size(); ++r) EXPECT_LE(regions.loop(r).size(), 32U) << "too many sides";
}

TEST(ConvexRegions, WhatIsNotJoined) {
  const glm::dvec3 far{8, 0, 3}, low{2, 0, -3}, bent{0, 0.1, 3}, above{2, 0, 5}, minus{-0.0, 0, -0.0};
  const auto count = [](const std::vector<Loop>& polygons) { return joined(soup_of(polygons)); };
  EXPECT_EQ(count({{a, b, c}, {b, far, c}}), 1U) << "and this is";
  EXPECT_EQ(count({{minus, b, c}, {c, d, a}}), 1U) << "and this, for -0 is 0";
  EXPECT_EQ(count({{a, a, b, c}, {c, d, a}}), 1U) << "and this, with a corner twice";
  EXPECT_EQ(count({{a, b, c}, {a, c, bent}}), 0U) << "a bend";
  EXPECT_EQ(count({{a, b, d}, {b, c, glm::dvec3{1, 0, 1}}}), 0U) << "no edge in common";
  EXPECT_EQ(count({{a, b, c}, {a, d, c}}), 0U) << "turned against one another";
  EXPECT_EQ(count({{a, b, c}, {a, b, c}}), 0U) << "one on the other";
  EXPECT_EQ(count({{a, b, c}, {c, b, a}}), 0U) << "back to back";
  EXPECT_EQ(count({{a, b, c}, {b, a, low}, {b, a, {2, 1, 0}}}), 0U) << "three at an edge";
  EXPECT_EQ(count({{a, b, c, d}, {d, c, above}, {b, a, {9, 0, -1}}}), 1U) << "a corner that turns back";
  EXPECT_EQ(count({{a, a, a}, {a, b, b}, {a, b, {2, 0, 0}}}), 0U) << "no area";
  EXPECT_EQ(count({{a, b, {1, 0, 1}, d}, {b, a, low}}), 0U) << "not convex";
}

/// Every edge but those of the loop as often one way as the other.
void check_border(const PolygonSoup& soup, const ConvexRegions& regions, std::size_t r) {
  std::map<std::array<double, 6>, int> times;
  const auto add_loop = [&](std::span<const std::uint32_t> loop, int sign) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const glm::dvec3 &p = soup.vertices[loop[i]], &q = soup.vertices[loop[(i + 1) % loop.size()]];
      times[{p.x, p.y, p.z, q.x, q.y, q.z}] += sign;
      times[{q.x, q.y, q.z, p.x, p.y, p.z}] -= sign;
    }
  };
  std::size_t sides = 2;
  for (const std::uint32_t part : regions.parts(r)) {
    add_loop(soup.loop(part), 1);
    sides += soup.loop(part).size() - 2;
  }
  add_loop(regions.loop(r), -1);
  EXPECT_TRUE(std::ranges::all_of(times, [](const auto& edge) { return edge.second == 0; })) << "region " << r;
  EXPECT_EQ(regions.loop(r).size(), sides);  // no corner was lost
}

TEST(ConvexRegions, PolygonsFirstThenWhatIsJoined) {
  PolygonSoup soup = random_town(5, 2000);
  const std::size_t walls = soup.size();
  for (std::size_t p = 0; p < walls; p += 10) {  // the walls once more, beside them, as triangles
    const auto loop = soup.loop(p);
    if (loop.size() != 4) continue;
    Loop corner;
    for (const std::uint32_t i : loop) corner.push_back(soup.vertices[i] + glm::dvec3{200, 0, 0});
    add(soup, {corner[0], corner[1], corner[2]});
    add(soup, {corner[0], corner[2], corner[3]});
  }
  const ConvexRegions regions = find_regions(soup);
  EXPECT_EQ(regions.size(), soup.size() + (soup.size() - walls) / 2);
  std::vector<std::uint32_t> whole(soup.size());
  for (std::size_t r = 0; r < regions.size(); ++r) {
    EXPECT_TRUE(std::ranges::is_sorted(regions.parts(r)));
    EXPECT_EQ(regions.parts(r).size() == 1, r < soup.size());
    check_border(soup, regions, r);
    for (const std::uint32_t part : regions.parts(r)) whole[part] = static_cast<std::uint32_t>(r);
  }
  for (std::uint32_t p = 0; p < soup.size(); ++p) EXPECT_EQ(regions.whole(p), whole[p]);
}

}  // namespace
