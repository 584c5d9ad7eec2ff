// SPDX-License-Identifier: MIT
#include "enclosed.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <random>
#include <vector>

#include "occlude/oracle/ray.h"
#include "occlude/oracle/visibility.h"
#include "seed.h"

namespace occlude::cli {
namespace enclosed_test {

using culler::PolygonSoup;
using glm::dvec3;
using Loop = std::vector<dvec3>;

void add(PolygonSoup& soup, const Loop& loop) {
  std::vector<std::uint32_t> indices;
  for (const dvec3& v : loop) indices.push_back(soup.add_vertex(v));
  soup.add_polygon(indices);
}

/// The side of a box across an axis.
Loop side(const dvec3& low, const dvec3& high, int axis, bool is_upper) {
  Loop loop(4, low);
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  for (std::size_t i = 0; i < 4; ++i) {
    loop[i][axis] = is_upper ? high[axis] : low[axis];
    if (i == 1 || i == 2) loop[i][u] = high[u];
    if (i >= 2) loop[i][v] = high[v];
  }
  return loop;
}

/// A box without the sides in `missing`: 2 * axis + 1 for upper ones.
void add_box(PolygonSoup& soup, const dvec3& low, const dvec3& high, const std::vector<int>& missing = {}) {
  for (int i = 0; i < 6; ++i) {
    if (std::ranges::count(missing, i) == 0) add(soup, side(low, high, i / 2, i % 2 != 0));
  }
}

/// The numbers of the enclosed polygons in the soup.
std::vector<std::uint32_t> enclosed(const PolygonSoup& soup, bool may_touch = true) {
  const culler::Hierarchy tree = culler::Hierarchy::build(soup, {.leaf_size = 1});
  const std::vector<bool> is_enclosed = enclosed_polygons(tree, may_touch, {}).polygons;
  std::vector<std::uint32_t> numbers;
  for (std::uint32_t p = 0; p < is_enclosed.size(); ++p) {
    if (is_enclosed[p]) numbers.push_back(tree.original(p));
  }
  std::ranges::sort(numbers);
  return numbers;
}

using Numbers = std::vector<std::uint32_t>;

TEST(Enclosed, AWallBetweenTwoHouses) {
  PolygonSoup soup;
  add_box(soup, {0, 0, 0}, {1, 1, 1}, {1});
  add_box(soup, {1, 0, 0}, {2, 1, 1}, {0});
  add(soup, side({0, 0, 0}, {1, 1, 1}, 0, true));
  EXPECT_EQ(enclosed(soup), Numbers{10});
  EXPECT_EQ(enclosed(soup, false), Numbers{});
  // With an open door in one house, its inside and the wall are seen.
  PolygonSoup open;
  add_box(open, {0, 0, 0}, {1, 1, 1}, {0, 1});
  add_box(open, {1, 0, 0}, {2, 1, 1}, {0});
  add(open, side({0, 0, 0}, {1, 1, 1}, 0, true));
  EXPECT_EQ(enclosed(open), Numbers{});
  // Behind the wall is what only the other house hides.
  add_box(open, {0.25, 0.25, 0.25}, {0.75, 0.75, 0.75});
  add_box(open, {1.25, 0.25, 0.25}, {1.75, 0.75, 0.75});
  EXPECT_EQ(enclosed(open), (Numbers{16, 17, 18, 19, 20, 21}));
}

TEST(Enclosed, FourRoomsWhoseWallsMeetInAnEdge) {
  PolygonSoup soup;
  for (const double x : {0, 1}) {
    for (const double y : {0, 1}) {
      add_box(soup, {x, y, 0}, {x + 1, y + 1, 1}, {x == 0 ? 1 : 0, y == 0 ? 3 : 2});
    }
  }
  ASSERT_EQ(soup.size(), 16);
  for (const double at : {0, 1}) {
    add(soup, side({0, at, 0}, {1, at + 1, 1}, 0, true));
    add(soup, side({at, 0, 0}, {at + 1, 1, 1}, 1, true));
  }
  EXPECT_EQ(enclosed(soup), (Numbers{16, 17, 18, 19}));
}

TEST(Enclosed, WhatTouchesFromInside) {
  PolygonSoup corner;  // three sides lie in those of the box, and stay
  add_box(corner, {0, 0, 0}, {4, 4, 4});
  add_box(corner, {0, 0, 0}, {2, 2, 2});
  EXPECT_EQ(enclosed(corner), (Numbers{7, 9, 11}));
  EXPECT_EQ(enclosed(corner, false), Numbers{});
  PolygonSoup edges;  // a tetrahedron with a corner in a side of the box, and one in an edge
  add_box(edges, {0, 0, 0}, {4, 4, 4});
  const std::array<dvec3, 4> corners{dvec3(0, 1, 1), dvec3(4, 4, 2), dvec3(2, 2, 1), dvec3(2, 1, 3)};
  for (const auto& [a, b, c] : {std::array{0, 1, 2}, std::array{0, 3, 1}, std::array{1, 3, 2}, std::array{0, 2, 3}}) {
    add(edges,
        {corners[static_cast<std::size_t>(a)], corners[static_cast<std::size_t>(b)], corners[static_cast<std::size_t>(c)]});
  }
  EXPECT_EQ(enclosed(edges), (Numbers{6, 7, 8, 9}));
  EXPECT_EQ(enclosed(edges, false), Numbers{});
  PolygonSoup across;  // a wall from side to side without corners in common with the box
  add_box(across, {0, 0, 0}, {4, 4, 4});
  add(across, {{2, 0, 0}, {2, 4, 0}, {2, 4, 4}, {2, 0, 4}});
  EXPECT_EQ(enclosed(across), Numbers{6});
}

TEST(Enclosed, WhatPierces) {
  PolygonSoup soup;
  add_box(soup, {0, 0, 0}, {4, 4, 4});
  add(soup, {{1, 1, 1}, {5, 1, 1}, {1, 2, 1}});
  add(soup, {{-1, 2, 2}, {5, 2, 2}, {2, 3, 2}});                        // all corners out
  add(soup, {{2, 2, 1}, {std::nextafter(4.0, 5.0), 2, 1}, {2, 3, 1}});  // by one ulp
  add(soup, {{2, 2, 3}, {4, 2, 3}, {2, 3, 3}});                         // to the side
  add(soup, {{-4, 2, 2}, {2, 2, 8}, {2, 1, 2.5}});                      // over an edge, in the plane through it
  add(soup, {{1, 1, 2}, {2, 1, 2}, {2, 2, 2}, {5, 5, 2}});              // the second triangle of its fan
  EXPECT_EQ(enclosed(soup), Numbers{9});
}

TEST(Enclosed, EqualShells) {
  PolygonSoup soup;  // of two, each is inside of the closure of the other; neither may go
  add_box(soup, {0, 0, 0}, {4, 4, 4});
  add_box(soup, {0, 0, 0}, {4, 4, 4});
  EXPECT_EQ(enclosed(soup), Numbers{});
  add_box(soup, {1, 1, 1}, {2, 2, 2});
  EXPECT_EQ(enclosed(soup), (Numbers{12, 13, 14, 15, 16, 17}));
  // A tetrahedron whose edges are diagonals of the box's sides, and the one beside it: their triangles cross in the middle.
  PolygonSoup stars;
  const auto add_tetrahedron = [&](const std::array<dvec3, 4>& c) {
    for (std::size_t i = 0; i < 4; ++i) add(stars, {c[i], c[(i + 1) % 4], c[(i + 2) % 4]});
  };
  add_tetrahedron({dvec3(0, 0, 0), dvec3(4, 4, 0), dvec3(4, 0, 4), dvec3(0, 4, 4)});
  add_tetrahedron({dvec3(4, 0, 0), dvec3(0, 4, 0), dvec3(0, 0, 4), dvec3(4, 4, 4)});
  EXPECT_EQ(enclosed(stars), Numbers{});
}

TEST(Enclosed, WhatIsNotClosed) {
  const auto with_a_cube = [](PolygonSoup soup) {
    add_box(soup, {1, 1, 1}, {2, 2, 2});
    return enclosed(soup);
  };
  PolygonSoup crack;  // by one ulp
  add_box(crack, {0, 0, 0}, {4, 4, 4}, {5});
  add(crack, side({0, 0, 0}, {std::nextafter(4.0, 0.0), 4, 4}, 2, true));
  EXPECT_EQ(with_a_cube(crack), Numbers{});
  PolygonSoup junction;  // a corner of two sides in the middle of an edge of another one
  add_box(junction, {0, 0, 0}, {4, 4, 4}, {5});
  add(junction, side({0, 0, 0}, {2, 4, 4}, 2, true));
  add(junction, side({2, 0, 0}, {4, 4, 4}, 2, true));
  EXPECT_EQ(with_a_cube(junction), Numbers{});
  PolygonSoup window;
  add_box(window, {0, 0, 0}, {4, 4, 4}, {5});
  add(window, side({0, 0, 0}, {4, 4, 4}, 2, true));
  window.see_through_from(5);
  add_box(window, {1, 1, 1}, {2, 2, 2});
  EXPECT_EQ(enclosed(window), Numbers{});
  window.see_through.assign(window.size(), 0);
  window.see_through[8] = 1;  // of glass inside of what is opaque nothing is seen
  EXPECT_EQ(enclosed(window), (Numbers{6, 7, 8, 9, 10, 11}));
  PolygonSoup strip;  // a Moebius strip, which has one side
  const auto at = [](int i, double out) {
    const double angle = i * 2 * 3.14159265358979 / 12, turn = angle / 2;
    const double radius = 3 + out * std::cos(turn);
    return dvec3(radius * std::cos(angle), radius * std::sin(angle), out * std::sin(turn));
  };
  for (int i = 0; i < 11; ++i) add(strip, {at(i, -1), at(i + 1, -1), at(i + 1, 1), at(i, 1)});
  add(strip, {at(11, -1), at(0, 1), at(0, -1), at(11, 1)});
  EXPECT_EQ(with_a_cube(strip), Numbers{});
}

TEST(Enclosed, WhatIsLeftOutOfAShell) {
  PolygonSoup soup;  // a side that is there twice, a fin that stands out, and a shelf with a free edge
  add_box(soup, {0, 0, 0}, {4, 4, 4});
  add(soup, side({0, 0, 0}, {4, 4, 4}, 2, true));
  add(soup, {{4, 0, 0}, {4, 4, 0}, {6, 4, 0}, {6, 0, 0}});
  add(soup, {{0, 0, 4}, {0, 4, 4}, {2, 4, 2}, {2, 0, 2}});
  add_box(soup, {3, 1, 1}, {3.5, 2, 2});
  EXPECT_EQ(enclosed(soup), (Numbers{8, 9, 10, 11, 12, 13, 14}));
}

std::vector<oracle::Triangle> triangles_of(const PolygonSoup& soup, std::vector<std::uint32_t>& owner) {
  std::vector<oracle::Triangle> triangles;
  for (std::uint32_t p = 0; p < soup.size(); ++p) {
    const auto loop = soup.loop(p);
    const auto at = [&](std::size_t i) {
      const dvec3& v = soup.vertices[loop[i]];
      return oracle::Point{v.x, v.y, v.z};
    };
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      triangles.push_back({at(0), at(i), at(i + 1)});
      owner.push_back(p);
    }
  }
  return triangles;
}

/// Rooms on a lattice, some without a wall or with glass, and polygons across them.
PolygonSoup rooms(std::mt19937& random) {
  const auto one_of = [&](int count) { return static_cast<int>(random() % static_cast<unsigned>(count)); };
  PolygonSoup soup;
  std::array<std::array<std::array<bool, 4>, 4>, 4> is_room{};
  for (int x = 1; x < 4; ++x) {
    for (int y = 1; y < 4; ++y) is_room[x][y][1] = one_of(3) != 0;
  }
  Numbers glass;
  const int most_faults = one_of(3) == 0 ? 2 : 0;
  int faults = 0;
  for (int axis = 0; axis < 3; ++axis) {
    for (int x = 0; x < 4; ++x) {
      for (int y = 0; y < 4; ++y) {
        for (int z = 0; z < 3; ++z) {
          std::array<int, 3> next{x, y, z};
          ++next[static_cast<std::size_t>(axis)];
          if (next[0] > 3 || next[1] > 3 || next[2] > 3) continue;
          const bool here = is_room[x][y][z], there = is_room[next[0]][next[1]][next[2]];
          if (!here && !there) continue;
          if (one_of(12) == 0 && faults < most_faults) {
            ++faults;
            if (one_of(2) == 0) continue;
            glass.push_back(static_cast<std::uint32_t>(soup.size()));
          }
          if (here && there && one_of(4) == 0) continue;  // one large room
          add(soup, side(dvec3(x, y, z), dvec3(x + 1, y + 1, z + 1), axis, true));
        }
      }
    }
  }
  const auto on_lattice = [&] { return 1 + one_of(13) / 4.0; };
  for (int i = one_of(6); i > 0; --i) {
    Loop loop;
    for (int k = 0; k < 3; ++k) loop.emplace_back(on_lattice(), on_lattice(), 1 + one_of(5) / 4.0);
    if (glm::cross(loop[1] - loop[0], loop[2] - loop[0]) != dvec3(0)) add(soup, loop);
  }
  for (int i = one_of(3); i > 0; --i) {
    const dvec3 low(on_lattice(), on_lattice(), 1 + one_of(4) / 4.0);
    add_box(soup, low, low + dvec3(1 + one_of(4), 1 + one_of(4), 1 + one_of(2)) / 4.0);
  }
  if (!soup.empty()) soup.see_through.assign(soup.size(), 0);
  for (const std::uint32_t p : glass) soup.see_through[p] = 1;
  return soup;
}

TEST(Enclosed, NothingThatIsSeen) {
  const std::uint32_t seed = seed_of(41);
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  std::size_t gone = 0, apart = 0, touching = 0;
  for (int i = 0; i < 400; ++i) {
    const PolygonSoup soup = rooms(random);
    if (soup.empty()) continue;
    std::vector<bool> is_gone(soup.size()), is_apart(soup.size());
    for (const std::uint32_t p : enclosed(soup, false)) is_apart[p] = true;
    const Numbers numbers = enclosed(soup);
    gone += numbers.size();
    for (const std::uint32_t p : numbers) is_gone[p] = true;
    Numbers owner;
    const std::vector<oracle::Triangle> triangles = triangles_of(soup, owner);
    std::vector<bool> see_through;
    for (const std::uint32_t p : owner) see_through.push_back(!culler::SoupView(soup).is_opaque(p));
    const auto far = [&] { return std::uniform_real_distribution(-8.0, 8.0)(random); };
    for (int k = 0; k < 6; ++k) {
      oracle::Point eye{2.5 + far(), 2.5 + far(), 1.5 + far()};
      eye[static_cast<std::size_t>(k % 3)] = k < 3 ? -0.5 + far() / 20 : 5.5 + far() / 20;
      if (k % 2 == 0) {
        const std::vector<bool> shows = oracle::visible_triangles({eye, false}, triangles, {}, see_through);
        for (std::size_t t = 0; t < triangles.size(); ++t) {
          ASSERT_FALSE(shows[t] && is_gone[owner[t]]) << "model " << i << ", polygon " << owner[t];
        }
      }
      // What a ray meets first is on a polygon that stays, at corners and edges, too.
      for (std::size_t t = 0; t < triangles.size(); ++t) {
        if (!is_gone[owner[t]]) continue;
        oracle::Point point = triangles[t][random() % 3];
        const oracle::Point& other = triangles[t][random() % 3];
        for (std::size_t axis = 0; axis < 3; ++axis) point[axis] = (point[axis] + other[axis]) / 2;
        const oracle::Ray ray({eye, false}, point);
        const auto [x, y, z] = point;
        const oracle::Triangle aim{{{x + 0.5, y + 0.25, z}, {x, y - 0.5, z + 0.25}, {x - 0.5, y + 0.25, z - 0.25}}};
        ASSERT_TRUE(ray.enters(aim, {}));
        bool is_clear = true, is_on = false;
        for (std::size_t o = 0; o < triangles.size() && is_clear; ++o) {
          if (see_through[o]) continue;
          const auto order = ray.order(aim, triangles[o], {0, 0, 0, 1});
          is_on = is_on || (order == oracle::Ray::Order::same && !is_gone[owner[o]]);
          is_clear = order != oracle::Ray::Order::nearer;
        }
        touching += is_clear && is_on;
        apart += is_apart[owner[t]];
        ASSERT_FALSE(is_clear && is_apart[owner[t]]) << "model " << i << ", polygon " << owner[t];
        ASSERT_TRUE(!is_clear || is_on) << "model " << i << ", polygon " << owner[t];
      }
    }
  }
  EXPECT_GT(gone, 500);
  EXPECT_GT(apart, 200);
  EXPECT_GT(touching, 100);  // what a ray meets first is on one that is gone, too
}

}  // namespace enclosed_test
}  // namespace occlude::cli
