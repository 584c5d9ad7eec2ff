// SPDX-License-Identifier: MIT
#include "frusta/convex_regions.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <span>
#include <vector>

#include "frusta/potential_occluders.h"
#include "model/adjacency.h"
#include "occlude/kernel/shadow_frustum.h"
#include "scenes.h"

namespace convex_regions_test {

using namespace occlude::culler;
using Loop = std::vector<glm::dvec3>;

ConvexRegions find_regions(SoupView soup) { return ConvexRegions::find(soup, find_adjacency(soup, welded(soup.vertices))); }

/// The corners of region r, starting with the least one.
Loop corners(SoupView soup, const ConvexRegions& regions, std::size_t r) {
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

/// The number of regions that are joined of several polygons.
std::size_t joined(SoupView soup) {
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

/// The polygons of the region go along every edge as often one way as the other, except along the edges of its loop.
void check_border(SoupView soup, const ConvexRegions& regions, std::size_t r) {
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

/// The runs of the pieces of a polygon that is alone in its soup. Checks what must hold for all pieces.
std::vector<FanRun> runs_of(const Loop& polygon) {
  const PolygonSoup soup = soup_of({polygon});
  const ConvexRegions regions = find_regions(soup);
  std::vector<FanRun> runs;
  std::uint32_t covered = 0;
  for (std::size_t r = 0; r < regions.size(); ++r) {
    const auto run = regions.piece(r);
    EXPECT_EQ(run.has_value(), r > 0);
    if (!run) continue;
    EXPECT_EQ(run->first, covered) << "the fan is covered once, without a gap";
    EXPECT_GT(run->count, 0U);
    covered += run->count;
    EXPECT_TRUE(std::ranges::equal(regions.loop(r), piece_of(soup.loop(0), *run)));
    EXPECT_EQ(parts(regions, r), (std::vector<std::uint32_t>{0}));
    // The loop is the border of the triangles that the renderer makes of the run, and has all their corners.
    PolygonSoup triangles;
    triangles.vertices = soup.vertices;
    for (std::uint32_t t = run->first; t < run->first + run->count; ++t) {
      triangles.add_polygon(std::array{soup.loop(0)[0], soup.loop(0)[t + 1], soup.loop(0)[t + 2]});
    }
    std::map<std::array<std::uint32_t, 2>, int> times;
    const auto add_edges = [&](std::span<const std::uint32_t> loop, int sign) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const std::uint32_t from = loop[i], to = loop[(i + 1) % loop.size()];
        times[{std::min(from, to), std::max(from, to)}] += from < to ? sign : -sign;
      }
    };
    for (std::size_t t = 0; t < triangles.size(); ++t) add_edges(triangles.loop(t), 1);
    add_edges(regions.loop(r), -1);
    EXPECT_TRUE(std::ranges::all_of(times, [](const auto& edge) { return edge.second == 0; }));
    EXPECT_EQ(regions.loop(r).size(), run->count + 2);
    runs.push_back(*run);
  }
  EXPECT_EQ(covered, runs.empty() ? 0 : polygon.size() - 2);
  return runs;
}

using Runs = std::vector<FanRun>;

TEST(ConvexRegions, PiecesOfAnL) {
  const Loop l{{0, 0, 0}, {2, 0, 0}, {2, 0, 1}, {1, 0, 1}, {1, 0, 2}, {0, 0, 2}};
  EXPECT_EQ(runs_of(l), (Runs{{0, 2}, {2, 2}}));
  // When the loop starts at the next corner, the fan reaches out of the L, and one triangle is turned over. They are drawn
  // all the same, so they may hide.
  Loop turned(l.begin() + 1, l.end());
  turned.push_back(l[0]);
  EXPECT_EQ(runs_of(turned), (Runs{{0, 1}, {1, 1}, {2, 2}}));
}

TEST(ConvexRegions, ConvexPolygonsHaveNoPieces) {
  EXPECT_EQ(runs_of({a, b, c, d}), Runs{});
  EXPECT_EQ(runs_of({d, c, b, a}), Runs{});
  EXPECT_EQ(runs_of({a, {2, 0, 0}, b, c, d}), Runs{}) << "a corner in line with its neighbours";
  EXPECT_EQ(runs_of({{2, 0, 0}, {3, 0, 0}, b, c, d, a}), Runs{}) << "the first of them in line";
  EXPECT_EQ(runs_of({a, a, b, c, c, d}), Runs{}) << "corners twice";
  EXPECT_EQ(runs_of({a, b, d}), Runs{});
}

/// An L whose first triangle has no area.
TEST(ConvexRegions, PiecesWhereTheFirstCornersAreInLine) {
  const Loop l{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {2, 0, 1}, {1, 0, 1}, {1, 0, 2}, {0, 0, 2}};
  EXPECT_EQ(runs_of(l), (Runs{{0, 3}, {3, 2}}));
  EXPECT_EQ(runs_of({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 0.5}, {1, 0, 2}}), (Runs{{0, 2}, {2, 1}}));
}

/// The corners of a star, alternately far from its middle and near.
Loop star(std::size_t rays) {
  Loop loop;
  for (std::size_t i = 0; i < 2 * rays; ++i) {
    const double angle = 3.14159265358979323846 * static_cast<double>(i) / static_cast<double>(rays);
    const double length = i % 2 == 0 ? 4 : 1;
    loop.push_back({length * std::cos(angle), 0, length * std::sin(angle)});
  }
  return loop;
}

TEST(ConvexRegions, PiecesOfAStarWhoseFanFoldsOver) {
  for (const std::size_t rays : {3U, 5U, 8U}) {
    for (std::size_t first = 0; first < 2; ++first) {
      Loop loop = star(rays);
      std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(first), loop.end());
      EXPECT_GT(runs_of(loop).size(), 1U) << rays << " rays";
    }
  }
}

/// A pentagram turns to one side at every corner, and runs round twice.
TEST(ConvexRegions, PiecesOfAPentagram) {
  const Loop rays = star(5);
  EXPECT_EQ(runs_of({rays[0], rays[4], rays[8], rays[2], rays[6]}), (Runs{{0, 1}, {1, 1}, {2, 1}}));
}

TEST(ConvexRegions, PiecesHaveNoMoreThanThirtyTwoSides) {
  Loop comb{{0, 0, -1}};
  for (int i = 0; i <= 100; ++i) comb.push_back({100.0 - i, 0, i * (100.0 - i)});
  comb.push_back({0.5, 0, -0.9});  // not convex here
  const Runs runs = runs_of(comb);
  EXPECT_GE(runs.size(), 4U);
  for (const FanRun& run : runs) EXPECT_LE(run.count + 2, 32U);
}

/// Whether the loop, which lies in a plane of constant y, has an area.
bool has_area(const std::vector<occlude::kernel::Vec3>& loop) {
  double doubled = 0;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    doubled += (loop[i].x - loop[0].x) * (loop[i + 1].z - loop[0].z) - (loop[i].z - loop[0].z) * (loop[i + 1].x - loop[0].x);
  }
  return doubled != 0;
}

/// The polygon is convex, but has too many sides for one shadow.
TEST(ConvexRegions, PiecesOfAPolygonWithVeryManySides) {
  constexpr std::uint32_t kSides = 1000;
  Loop disc;
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const double angle = i * 2 * 3.14159265358979 / kSides;
    disc.push_back({2, std::cos(angle), std::sin(angle)});
  }
  const PolygonSoup soup = soup_of({disc});
  const ConvexRegions regions = find_regions(soup);
  ASSERT_EQ(regions.size(), 5U) << "itself, and four pieces of at most 254 triangles";
  std::uint32_t next = 0;
  for (std::size_t r = 1; r < regions.size(); ++r) {
    EXPECT_LE(regions.loop(r).size(), ConvexRegions::kMostSides);
    EXPECT_EQ(regions.piece(r)->first, next);
    next += regions.piece(r)->count;
  }
  EXPECT_EQ(next, kSides - 2);
  const PotentialOccluders occluders = PotentialOccluders::find(SharedSoup(soup), {});
  EXPECT_EQ(occluders[0].area(), 0);
  for (std::size_t r = 1; r < regions.size(); ++r) EXPECT_GT(occluders[r].area(), 0.1);
}

/// The pieces of random loops are sound, and the kernel takes those that have an area as occluders.
TEST(ConvexRegions, PiecesOfAnyLoop) {
  constexpr std::uint32_t kSeed = 4;
  std::mt19937 random(kSeed);
  std::size_t pieces = 0, hide = 0;
  for (int n = 0; n < 2000; ++n) {
    Loop loop;
    for (std::size_t corners = 4 + random() % 9; corners > 0; --corners) {
      const auto x = static_cast<double>(random() % 7), z = static_cast<double>(random() % 7);
      const glm::dvec3 corner{x, 5, z};
      // At a repeated corner doubles cannot tell how the loop turns.
      if (loop.empty() || (corner != loop.back() && corner != loop.front())) loop.push_back(corner);
    }
    if (loop.size() < 4) continue;
    runs_of(loop);
    ASSERT_FALSE(HasFailure()) << "seed " << kSeed << ", loop " << n;
    const PolygonSoup soup = soup_of({loop});
    const ConvexRegions regions = find_regions(soup);
    for (std::size_t r = 1; r < regions.size(); ++r) {
      std::vector<occlude::kernel::Vec3> corners;
      for (const std::uint32_t i : regions.loop(r)) {
        const glm::dvec3& v = soup.vertices[i];
        corners.push_back({v.x, v.y, v.z});
      }
      const auto eye = occlude::kernel::Viewpoint::eye({3, 0, 3});
      const auto made = occlude::kernel::ShadowFrustum::make(eye, corners, occlude::kernel::Near::surface);
      ++pieces;
      hide += made.frustum ? 1 : 0;
      EXPECT_EQ(made.frustum.has_value(), has_area(corners)) << "seed " << kSeed << ", loop " << n;
    }
  }
  EXPECT_GT(pieces, 5000U);
  EXPECT_GT(hide, pieces / 2);
}

}  // namespace convex_regions_test
