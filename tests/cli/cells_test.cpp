// SPDX-License-Identifier: MIT
#include "cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "seed.h"
#include "visible_sets.h"

namespace occlude::cli {
namespace cells_test {

bool holds(const kernel::Aabb& box, const glm::dvec3& point) {
  for (int axis = 0; axis < 3; ++axis) {
    if (!(box.min[axis] <= point[axis] && point[axis] <= box.max[axis])) return false;
  }
  return true;
}
bool hold(const std::vector<kernel::Aabb>& cells, const glm::dvec3& point) {
  return std::ranges::any_of(cells, [&](const kernel::Aabb& cell) { return holds(cell, point); });
}

TEST(Cells, TheFewestThatCoverABox) {
  const CellGrid grid{.size = 1, .layer = {}};
  const auto count = [&](double low, double high) { return grid.cells_of({{low, 0.5, 0.5}, {high, 0.5, 0.5}}).size(); };
  EXPECT_EQ(count(0.5, 1.5), 2);
  EXPECT_EQ(count(0, 2), 2);
  EXPECT_EQ(count(-2, 0), 2);
  EXPECT_EQ(count(std::nextafter(1.0, 0.0), 2), 2);
  EXPECT_EQ(count(1, std::nextafter(2.0, 3.0)), 2);
  EXPECT_EQ(count(2, 2), 1);
  EXPECT_EQ(grid.cells_of({{2, 0, 0}, {2, 0, 0}})[0].min.x, 2);
}

TEST(Cells, CoverNumbersWhoseQuotientIsRounded) {
  const std::uint32_t seed = seed_of(31);
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 20'000; ++i) {
    const CellGrid grid{.size = std::ldexp(1 + std::uniform_real_distribution(0.0, 1.0)(random), -10), .layer = {}};
    const double border = static_cast<double>(static_cast<int>(random() % 200'000) - 100'000) * grid.size;
    for (const double x : {border, std::nextafter(border, 1e9), std::nextafter(border, -1e9)}) {
      const auto cells = grid.cells_of({{x, 0, 0}, {x, 0, 0}});
      ASSERT_EQ(cells.size(), 1);
      ASSERT_TRUE(holds(cells[0], {x, 0, 0})) << x << " with " << grid.size;
      ASSERT_TRUE(x != border || cells[0].min.x == x);
    }
  }
  // floor(1.918 / 0.001) is 1918, and 1918 * 0.001 is above 1.918.
  ASSERT_TRUE(hold(CellGrid{.size = 0.001, .layer = {}}.cells_of({{1.918, 0, 0}, {1.918, 0, 0}}), {1.918, 0, 0}));
}

render::CameraPath path_of(std::initializer_list<glm::dvec3> eyes) {
  render::CameraPath path;
  path.frames = eyes.size();
  for (const glm::dvec3& eye : eyes) path.keyframes.push_back({eye, eye + glm::dvec3(1, 0, 0)});
  return path;
}

TEST(Cells, ACorridorHoldsAllThatIsWithinReachOfTheWay) {
  const std::uint32_t seed = seed_of(32);
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  const auto number = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  for (int i = 0; i < 300; ++i) {
    const CellGrid grid{.size = number(0.5, 2), .layer = {}};
    const glm::dvec3 a{number(-3, 3), number(-3, 3), number(-3, 3)}, b{number(-3, 3), number(-3, 3), number(-3, 3)};
    const double reach = i % 2 == 0 ? 0 : number(0, 1);
    const auto cells = grid.cells_along(path_of({a, b}), reach);
    for (int k = 0; k < 300; ++k) {
      const double share = number(0, 1);
      const glm::dvec3 off{number(-reach, reach), number(-reach, reach), number(-reach, reach)};
      ASSERT_TRUE(hold(cells, a + share * (b - a) + off));
    }
    // None is farther than that and half a size.
    for (const kernel::Aabb& cell : cells) {
      const double most = reach + 0.5 * grid.size + 1e-9;
      double first = 0, last = 1;  // the part of the way that is so near
      for (int axis = 0; axis < 3; ++axis) {
        const double to_low = (cell.min[axis] - most - a[axis]) / (b[axis] - a[axis]),
                     to_high = (cell.max[axis] + most - a[axis]) / (b[axis] - a[axis]);
        first = std::max(first, std::min(to_low, to_high));
        last = std::min(last, std::max(to_low, to_high));
      }
      ASSERT_LE(first, last);
    }
  }
  ASSERT_TRUE(
      hold(CellGrid{.size = 1, .layer = {}}.cells_along(path_of({{.5, .52, .5}, {1.5, 1.52, .5}}), 0), {.99, 1.01, .5}));
}

TEST(Cells, HeightsOfALayerAreAlongUp) {
  CellGrid grid{.size = 1, .layer = CellGrid::Layer{1, 3, 1, false}};
  const auto check = [&](double low, double high) {
    const auto cells = grid.cells_of({{0, -9, 0}, {1, 9, 1}});
    ASSERT_EQ(cells.size(), 1);
    EXPECT_EQ(cells[0].min.y, low);
    EXPECT_EQ(cells[0].max.y, high);
  };
  check(1, 3);
  grid.layer->is_down = true;
  check(-3, -1);
}

TEST(Cells, PiecesCoverACellAndAreAsLongAsTheSide) {
  for (std::int64_t place = -1000; place <= 1000; ++place) {
    const double low = static_cast<double>(place) * 2.2, high = static_cast<double>(place + 1) * 2.2;
    EXPECT_EQ(pieces_of({{low, 0, 0}, {high, 2.2, 2.2}}, 2.2).size(), 1);
    const auto pieces = pieces_of({{low, 0, 0}, {high, 0, 0}}, 2.1);
    ASSERT_EQ(pieces.size(), 2);
    EXPECT_EQ(pieces[0].min.x, low);
    EXPECT_EQ(pieces[0].max.x, pieces[1].min.x);
    EXPECT_EQ(pieces[1].max.x, high);
  }
  EXPECT_EQ(pieces_of({{0, 0, 0}, {4, 4, 0}}, 2).size(), 4);
  try {
    static_cast<void>(pieces_of({{0, 0, 0}, {100, 100, 100}}, 2));
    FAIL();
  } catch (const std::length_error& error) {
    EXPECT_STREQ(error.what(), "the cell from (0, 0, 0) to (100, 100, 100) has more than 65536 pieces, with --piece 2");
  }
}

TEST(VisibleSets, MutualIsWhatBothHave) {
  const std::uint32_t seed = seed_of(33);
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  for (const std::size_t count : {1U, 2U, 63U, 64U, 65U, 200U}) {
    std::vector<std::vector<bool>> seen(count, std::vector<bool>(count));
    std::vector<BakedCell> cells(count);
    for (std::size_t a = 0; a < count; ++a) {
      bool is_seen = false;  // runs and single ones
      for (std::size_t b = 0; b < count; ++b) {
        if (random() % (1 + a % 9) == 0) is_seen = random() % 2 == 0;
        seen[a][b] = is_seen;
      }
      cells[a].cells = changes_of(seen[a]);
    }
    make_mutual(cells);
    for (std::size_t a = 0; a < count; ++a) {
      std::vector<bool> both(count);
      for (std::size_t b = 0; b < count; ++b) both[b] = seen[a][b] && seen[b][a];
      ASSERT_EQ(cells[a].cells, changes_of(both));
    }
  }
}

}  // namespace cells_test
}  // namespace occlude::cli
