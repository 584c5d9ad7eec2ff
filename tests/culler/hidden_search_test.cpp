// SPDX-License-Identifier: MIT
// What is found to be hidden from a box of eyes is, and closer pictures find more.
#include "held/hidden_search.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <glm/vec3.hpp>
#include <random>
#include <span>
#include <vector>

#include "sanitized.h"
#include "scenes.h"
#include "seed.h"
#include "seen_by_rays.h"

namespace hidden_search_test {

using namespace occlude::culler;
using occlude::seed_of;
using occlude::unless_sanitized;
using occlude::kernel::Aabb;

/// The boxes of the polygons, and then others.
std::vector<Aabb> boxes_of(const Culler& culler, const std::vector<Aabb>& others) {
  std::vector<Aabb> boxes;
  const SoupView soup = culler.hierarchy().soup();
  for (std::uint32_t p = 0; p < soup.size(); ++p) boxes.push_back(soup.box(p));
  boxes.insert(boxes.end(), others.begin(), others.end());
  return boxes;
}

Aabb some_box(std::mt19937& random, double size) {
  Aabb box;
  for (int i = 0; i < 3; ++i) {
    box.min[i] = uniform(random, i == 2 ? 0.5 : -50, i == 2 ? 3 : 50);
    box.max[i] = box.min[i] + uniform(random, 0, size);
  }
  return box;
}

/// Often a corner.
glm::dvec3 some_point(std::mt19937& random, const Aabb& box) {
  glm::dvec3 point;
  for (int i = 0; i < 3; ++i) {
    const double share = random() % 3 == 0 ? static_cast<double>(random() % 2) : uniform(random, 0, 1);
    point[i] = share == 1 ? box.max[i] : box.min[i] + share * (box.max[i] - box.min[i]);
  }
  return point;
}

/// From cells and from several cells together, by few pictures and by many, and of boxes within the model and beyond it.
TEST(HiddenSearch, WhatItFindsNoSegmentReaches) {
  std::mt19937 random(seed_of(7101));
  std::size_t hidden_polygons = 0, hidden_boxes = 0;
  for (int trial = 0; trial < unless_sanitized(24, 8); ++trial) {
    const Culler culler(random_town_of_houses(static_cast<std::uint32_t>(random()), 1200));
    const SoupView soup = culler.hierarchy().soup();
    std::vector<Aabb> others;
    for (int i = 0; i < 60; ++i) others.push_back(some_box(random, 4));
    others.push_back({{200, 200, 0}, {201, 201, 1}});
    const std::vector<Aabb> boxes = boxes_of(culler, others);
    HiddenSearch search(culler, boxes, {static_cast<int>(64 + 8 * (random() % 16)), trial % 3 == 0 ? 1 : 0.01, {}});
    const Aabb eyes = some_box(random, trial % 4 == 0 ? 0 : 1.5);
    Aabb more = eyes;
    for (int i = 0; i < 3; ++i) more.max[i] += uniform(random, 0, 2);
    HiddenSearch::Known known = search.nothing();
    if (trial % 2 == 0) search.look_from(more, known);
    search.look_from(eyes, known);
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
      if (known.is_hidden[i] == 0) continue;
      (i < soup.size() ? hidden_polygons : hidden_boxes) += 1;
      for (int ray = 0; ray < 4; ++ray) {
        const glm::dvec3 eye = some_point(random, eyes);
        const bool is_polygon = i < soup.size();
        const glm::dvec3 point = is_polygon ? some_point(soup, i, random) : some_point(random, boxes[i]);
        bool is_blocked = false;
        for (std::uint32_t p = 0; p < soup.size() && !is_blocked; ++p) {
          is_blocked = !(is_polygon && p == i) && blocks(soup, p, eye, point, 0);
        }
        EXPECT_TRUE(is_blocked) << (is_polygon ? "polygon " : "box ") << i;
      }
    }
  }
  EXPECT_GT(hidden_polygons, unless_sanitized(1000U, 300U));
  EXPECT_GT(hidden_boxes, unless_sanitized(100U, 30U));
}

/// All that becomes known is told once, with a witness that has it, also where a polygon is asked by itself. Told or not,
/// the same becomes known.
TEST(HiddenSearch, TellsWhatHides) {
  std::mt19937 random(seed_of(7103));
  std::size_t by_themselves = 0;
  for (int trial = 0; trial < 6; ++trial) {
    const Culler culler(random_town_of_houses(static_cast<std::uint32_t>(random()), 1200));
    const SoupView soup = culler.hierarchy().soup();
    const std::vector<Aabb> boxes = boxes_of(culler, {some_box(random, 4)});
    const Aabb eyes = some_box(random, trial == 0 ? 0 : 1.5);
    std::vector<int> told(soup.size()), witnessed(soup.size());
    HiddenSearch::Options options{96, 0.01, {}};
    options.most_corners = 64;
    options.found = [&](const Camera&, std::span<const std::uint32_t> found, std::span<const CoverWitness> covers) {
      EXPECT_TRUE(std::ranges::is_sorted(found));
      for (const std::uint32_t p : found) ++told[p];
      std::vector<bool> has(soup.size());
      for (const CoverWitness& cover : covers) {
        for (std::uint32_t p = cover.range.first; p < cover.range.first + cover.range.count; ++p) {
          EXPECT_FALSE(has[p]) << "two witnesses of one picture";
          has[p] = true;
        }
        by_themselves += cover.range.count == 1 ? 1 : 0;
      }
      for (const std::uint32_t p : found) witnessed[p] += has[p] ? 1 : 0;
    };
    HiddenSearch search(culler, boxes, options);
    HiddenSearch::Known known = search.nothing(), untold = search.nothing();
    search.look_from(eyes, known);
    HiddenSearch(culler, boxes, {96, 0.01, {}}).look_from(eyes, untold);
    EXPECT_EQ(known.is_hidden, untold.is_hidden);
    for (std::size_t p = 0; p < soup.size(); ++p) {
      EXPECT_EQ(told[p], known.is_hidden[p]) << p;
      EXPECT_EQ(witnessed[p], told[p]) << p;
    }
  }
  EXPECT_GT(by_themselves, 100U);
}

/// Two walls that overlap by less than two pixels of the first pictures, and small things behind.
TEST(HiddenSearch, LooksCloserWhereMuchIsSeen) {
  PolygonSoup soup;
  add_wall(soup, 40, -30, 0.15, -10, 20);
  add_wall(soup, 40, 0, 30, -10, 20);
  constexpr unsigned kThings = 400;
  std::mt19937 random(7);
  for (unsigned i = 0; i < kThings; ++i) {
    const double y = uniform(random, -4, 4), z = uniform(random, -1, 4);
    add_wall(soup, uniform(random, 60, 80), y, y + 0.01, z, z + 0.01);
  }
  const Culler culler(soup);
  const std::vector<Aabb> boxes = boxes_of(culler, {});
  const Aabb eyes{{0, 0, 1}, {0.5, 0.5, 1.5}};
  const auto seen = [&](double closer) {
    HiddenSearch search(culler, boxes, {64, closer, {}});
    HiddenSearch::Known known = search.nothing();
    search.look_from(eyes, known);
    return std::ranges::count(known.is_hidden, 0);
  };
  EXPECT_GT(seen(1), 40);
  EXPECT_EQ(seen(0.01), 2);
}

/// A search keeps memory from call to call, which changes nothing. What is known stays.
TEST(HiddenSearch, DependsOnWhatItIsGivenAlone) {
  std::mt19937 random(seed_of(7102));
  const Culler culler(random_town_of_houses(5, 2000));
  const std::vector<Aabb> boxes = boxes_of(culler, {some_box(random, 4), some_box(random, 4)});
  const HiddenSearch::Options options{96, 0.02, {}};
  HiddenSearch search(culler, boxes, options);
  for (int trial = 0; trial < 5; ++trial) {
    const Aabb eyes = some_box(random, 1), others = some_box(random, 20);
    HiddenSearch::Known known = search.nothing(), again = search.nothing(), both = search.nothing();
    search.look_from(eyes, known);
    HiddenSearch(culler, boxes, options).look_from(eyes, again);
    EXPECT_EQ(known.is_hidden, again.is_hidden);
    search.look_from(others, both);
    const std::vector<std::uint8_t> before = both.is_hidden;
    search.look_from(eyes, both);
    for (std::size_t i = 0; i < boxes.size(); ++i) EXPECT_LE(before[i], both.is_hidden[i]);
  }
}

}  // namespace hidden_search_test
