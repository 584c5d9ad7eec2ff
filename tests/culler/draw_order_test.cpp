// SPDX-License-Identifier: MIT
// Ranges to draw that never cross materials.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <random>
#include <utility>
#include <vector>

#include "frames.h"
#include "occlude/culler/culler.h"
#include "occlude/culler/hierarchy.h"
#include "sanitized.h"
#include "scenes.h"

namespace draw_order_test {

using namespace occlude::culler;
using occlude::unless_sanitized;

using Materials = std::vector<std::uint32_t>;

/// A material for each polygon: by chance, so that leaves have many, or by place, as in a model.
Materials random_materials(std::mt19937& random, const PolygonSoup& soup, bool by_place) {
  constexpr std::uint32_t kMost = std::numeric_limits<std::uint32_t>::max();
  const Materials numbers{7, 0, kMost, 2048, 3, 100000};
  Materials materials;
  for (std::size_t p = 0; p < soup.size(); ++p) {
    const std::size_t place = static_cast<std::size_t>(soup.box(p).min.x + 100) / 20;
    materials.push_back(numbers[(by_place ? place : random()) % numbers.size()]);
  }
  return materials;
}

/// The polygons of the input that these ranges draw, ascending.
std::vector<std::uint32_t> drawn_by(const DrawOrder& order, const std::vector<MaterialRange>& ranges) {
  std::vector<std::uint32_t> polygons;
  for (const auto& [material, first, count] : ranges) {
    const auto part = order.polygons().subspan(first, count);
    polygons.insert(polygons.end(), part.begin(), part.end());
  }
  std::ranges::sort(polygons);
  return polygons;
}

std::vector<std::uint32_t> drawn_by(const Hierarchy& hierarchy, const std::vector<PolygonRange>& ranges) {
  std::vector<std::uint32_t> polygons;
  for (const auto& [first, count] : ranges) {
    for (std::uint32_t p = first; p < first + count; ++p) polygons.push_back(hierarchy.original(p));
  }
  std::ranges::sort(polygons);
  return polygons;
}

/// Each range is of one material, and no two could be one.
void expect_ranges(const DrawOrder& order, const std::vector<MaterialRange>& ranges, const Materials& materials) {
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    ASSERT_GT(ranges[i].count, 0U);
    for (const std::uint32_t p : order.polygons().subspan(ranges[i].first, ranges[i].count)) {
      ASSERT_EQ(materials[p], ranges[i].material);
    }
    if (i == 0) continue;
    const MaterialRange& before = ranges[i - 1];
    ASSERT_LE(before.first + before.count, ranges[i].first);
    ASSERT_TRUE(before.material < ranges[i].material || before.first + before.count < ranges[i].first);
  }
}

TEST(DrawOrder, RangesAreOfOneMaterialAndDrawWhatTheFrameDraws) {
  std::mt19937 random(3);
  std::size_t frames_in_part = 0;
  for (int i = 0; i < unless_sanitized(20, 4); ++i) {
    const PolygonSoup soup = random_town(static_cast<std::uint32_t>(random()), 2000);
    const Culler culler(soup, {.hierarchy = {.leaf_size = 1U + static_cast<std::uint32_t>(random() % 16)}});
    const Materials materials = random_materials(random, soup, i % 2 == 0);
    const DrawOrder order(culler.hierarchy(), materials);
    expect_ranges(order, {order.materials().begin(), order.materials().end()}, materials);
    EXPECT_EQ(order.materials().size(), 6U);
    EXPECT_TRUE(std::ranges::is_sorted(order.materials(), {}, &MaterialRange::material));
    std::vector<MaterialRange> ranges;
    for (int frame = 0; frame < 10; ++frame) {
      const CullResult result = culler.cull(random_camera(random), {.method = frame % 2 ? Method::cover : Method::frusta});
      order.find_ranges(result.drawn, ranges);
      expect_ranges(order, ranges, materials);
      ASSERT_EQ(drawn_by(order, ranges), drawn_by(culler.hierarchy(), result.drawn));
      frames_in_part += !ranges.empty() && result.stats.drawn_polygons < soup.size() ? 1 : 0;
    }
    order.find_ranges(std::vector{PolygonRange{0, static_cast<std::uint32_t>(soup.size())}}, ranges);
    EXPECT_TRUE(std::ranges::equal(ranges, order.materials()));
    order.find_ranges({}, ranges);
    EXPECT_TRUE(ranges.empty());
  }
  EXPECT_GT(frames_in_part, unless_sanitized(150U, 30U));
}

/// Within a material polygons are in the order of the leaves, whatever other materials are between them.
TEST(DrawOrder, WhatOtherMaterialsSeparateIsOneRange) {
  PolygonSoup soup;
  Materials materials;
  for (int i = 0; i < 64; ++i) {
    add(soup, {{i, 0, 0}, {i + 1, 0, 0}, {i, 1, 0}, {i, 1, 1}});
    materials.push_back(static_cast<std::uint32_t>(i % 4));
  }
  const Culler culler(soup, {.hierarchy = {.leaf_size = 8}});
  const DrawOrder order(culler.hierarchy(), materials);
  std::vector<MaterialRange> ranges;
  order.find_ranges(std::vector{PolygonRange{8, 16}, {32, 8}, {40, 8}}, ranges);
  EXPECT_EQ(ranges.size(), 8U);  // two stretches of the tree, each with 4 materials
  EXPECT_EQ(order.first_triangle(0), 0U);
  EXPECT_EQ(order.first_triangle(10), 20U);
  EXPECT_EQ(order.first_triangle(64), 128U);
}

TEST(DrawOrder, OfOneMaterialIsTheOrderOfTheTree) {
  const Culler culler(random_town(5, 300));
  const DrawOrder order(culler.hierarchy(), Materials(300, 4));
  for (std::uint32_t p = 0; p < 300; ++p) {
    EXPECT_EQ(order.polygons()[p], culler.hierarchy().original(p));
    EXPECT_EQ(order.first_triangle(p), culler.hierarchy().first_triangle(p));
  }
  const CullResult result = culler.cull(Camera{});
  std::vector<MaterialRange> ranges;
  order.find_ranges(result.drawn, ranges);
  ASSERT_EQ(ranges.size(), result.drawn.size());
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    EXPECT_EQ(ranges[i], (MaterialRange{4, result.drawn[i].first, result.drawn[i].count}));
  }
}

TEST(DrawOrder, APieceHasTheMaterialOfItsFace) {
  PolygonSoup soup;
  add(soup, {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  std::vector<std::uint32_t> arrow;
  for (const auto& [x, y] : {std::pair{4, 4}, {0, 1}, {-4, 4}, {0, 0}}) arrow.push_back(soup.add_vertex({x, y, 2}));
  ASSERT_EQ(soup.add_face(arrow), FaceShape::pieces);
  add(soup, {{0, 0, 4}, {1, 0, 4}, {0, 1, 4}});
  ASSERT_EQ(soup.size(), 4U);
  const Culler culler(soup);
  const DrawOrder order(culler.hierarchy(), Materials{1, 0, 1});
  ASSERT_EQ(order.materials().size(), 2U);
  EXPECT_EQ(order.materials()[0], (MaterialRange{0, 0, 2}));
  EXPECT_EQ(drawn_by(order, {order.materials()[0]}), (std::vector<std::uint32_t>{1, 2}));
  EXPECT_EQ(refusal([&] { DrawOrder(culler.hierarchy(), Materials(4)); }), "4 materials for 3 faces");
}

/// A store keeps the numbers of the input, so that the materials of a model order what comes out of it as well.
TEST(DrawOrder, IsTheSameOfAModelFromItsParts) {
  std::mt19937 random(8);
  const PolygonSoup soup = random_town(8, 500);
  const Culler culler(soup), again(culler.parts());
  const Materials materials = random_materials(random, soup, false);
  const DrawOrder order(culler.hierarchy(), materials), other(again.hierarchy(), materials);
  EXPECT_TRUE(std::ranges::equal(order.polygons(), other.polygons()));
  EXPECT_TRUE(std::ranges::equal(order.materials(), other.materials()));
}

}  // namespace draw_order_test
