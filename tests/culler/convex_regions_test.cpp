// SPDX-License-Identifier: MIT
#include "occlude/culler/convex_regions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "scenes.h"

namespace {

using namespace occlude::culler;
using Loop = std::vector<glm::dvec3>;

/// The corners of region r, from the least on.
Loop corners(const PolygonSoup& soup, const ConvexRegions& regions, std::size_t r) {
  Loop loop;
  for (const std::uint32_t i : regions.loop(r)) loop.push_back(soup.vertices[i]);
  const auto key = [](const glm::dvec3& v) { return std::array{v.x, v.y, v.z}; };
  std::ranges::rotate(loop, std::ranges::min_element(loop, {}, key));
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

TEST(ConvexRegions, TwoTrianglesOfARectangle) {
  const PolygonSoup soup = soup_of({{a, b, c}, {c, d, a}});
  const ConvexRegions regions = ConvexRegions::find(soup);
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_EQ(corners(soup, regions, 0), (Loop{a, b, c, d}));
  EXPECT_EQ(parts(regions, 0), (std::vector<std::uint32_t>{0, 1}));
}

TEST(ConvexRegions, AFanBecomesThePolygonThatItIs) {
  Loop hexagon{{2, 0, 0}, {1, 0, 2}, {-1, 0, 2}, {-2, 0, 0}, {-1, 0, -2}, {1, 0, -2}};
  std::vector<Loop> triangles;
  for (std::size_t i = 1; i + 1 < hexagon.size(); ++i) triangles.push_back({hexagon[0], hexagon[i], hexagon[i + 1]});
  const PolygonSoup soup = soup_of(triangles);
  const ConvexRegions regions = ConvexRegions::find(soup);
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_EQ(regions.loop(0).size(), 6U);
  EXPECT_EQ(regions.parts(0).size(), 4U);
}

TEST(ConvexRegions, WhatIsNotJoined) {
  const glm::dvec3 far{8, 0, 3}, low{2, 0, -3}, bent{0, 0.1, 3}, above{2, 0, 5}, middle{2, 0, 0};
  const auto count = [](const std::vector<Loop>& polygons) { return ConvexRegions::find(soup_of(polygons)).size(); };
  EXPECT_EQ(count({{a, b, c}, {b, far, c}}), 1U) << "and this is";
  EXPECT_EQ(count({{a, b, c}, {a, c, bent}}), 2U) << "a bend";
  EXPECT_EQ(count({{a, b, d}, {b, c, glm::dvec3{1, 0, 1}}}), 2U) << "no edge in common";
  EXPECT_EQ(count({{a, b, c}, {a, d, c}}), 2U) << "turned against one another";
  EXPECT_EQ(count({{a, b, c}, {a, b, c}}), 2U) << "one on the other";
  EXPECT_EQ(count({{a, b, c}, {c, b, a}}), 2U) << "back to back";
  EXPECT_EQ(count({{a, b, c}, {b, a, low}, {b, a, {2, 1, 0}}}), 3U) << "three at an edge";
  EXPECT_EQ(count({{a, b, c, d}, {d, c, above}, {b, a, {9, 0, -1}}}), 2U) << "a corner that turns back";
  EXPECT_EQ(count({{a, middle, {2, 0, 3}, d}, {middle, b, c, {2, 0, 3}}}), 2U)
      << "corners in line, which rounding may turn back";
  EXPECT_EQ(count({{a, a, a}, {a, b, b}, {a, b, {2, 0, 0}}}), 3U) << "no area";
  EXPECT_EQ(count({{a, b, {1, 0, 1}, d}, {b, a, low}}), 2U) << "not convex";
}

/// Whatever it joins, every polygon is in one region, and edges within a region cancel.
TEST(ConvexRegions, EveryPolygonInOneRegion) {
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
  const ConvexRegions regions = ConvexRegions::find(soup);
  EXPECT_EQ(regions.size(), soup.size() - (soup.size() - walls) / 2);
  std::vector<int> times(soup.size());
  for (std::size_t r = 0; r < regions.size(); ++r) {
    std::size_t sides = 2;
    for (const std::uint32_t part : regions.parts(r)) {
      ++times[part];
      sides += soup.loop(part).size() - 2;
    }
    EXPECT_EQ(regions.loop(r).size(), sides);
    EXPECT_TRUE(std::ranges::is_sorted(regions.parts(r)));
    if (regions.parts(r).size() == 1) {
      EXPECT_TRUE(std::ranges::equal(regions.loop(r), soup.loop(regions.parts(r)[0])));
    }
  }
  EXPECT_EQ(std::ranges::count(times, 1), static_cast<std::ptrdiff_t>(soup.size()));
}

}  // namespace
