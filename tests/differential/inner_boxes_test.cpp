// SPDX-License-Identifier: MIT
// Inner boxes of random solids, each proven by the oracle; and the exact questions behind them.
#include "occlude/culler/inner_boxes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>
#include <vector>

#include "culler/scenes.h"
#include "occlude/oracle/solid.h"
#include "seed.h"

namespace inner_boxes_test {

using namespace occlude::culler;
using occlude::seed_of;
using occlude::oracle::Point;
using occlude::oracle::Triangle;

std::vector<Triangle> triangles_of(SoupView soup) {
  std::vector<Triangle> triangles;
  for (std::size_t p = 0; p < soup.size(); ++p) {
    const auto at = [&](std::size_t i) {
      const glm::dvec3& v = soup.vertices[soup.loop(p)[i]];
      return Point{v.x, v.y, v.z};
    };
    for (std::size_t i = 1; i + 1 < soup.loop(p).size(); ++i) triangles.push_back({at(0), at(i), at(i + 1)});
  }
  return triangles;
}

/// Solids of one part, with many of the coordinates small whole numbers, so that boxes, faces and edges touch.
class RandomSolids {
 public:
  explicit RandomSolids(std::uint32_t first) : random_(first) {}

  PolygonSoup next() {
    PolygonSoup soup = pick(3) == 0 ? prism() : pick(2) == 0 ? bipyramid() : bent_box();
    const double angle = pick(2) == 0 ? 0 : number(0, 7);
    const glm::dvec3 to{pick(3) == 0 ? 0x1p40 : 0, pick(3) == 0 ? -0x1p20 : 0, 0};
    for (glm::dvec3& v : soup.vertices) {
      const double c = std::cos(angle), s = std::sin(angle);
      v = glm::dvec3{v.x * c - v.z * s, v.y, v.x * s + v.z * c} + to;
    }
    return soup;
  }

 private:
  std::uint32_t pick(std::uint32_t count) { return static_cast<std::uint32_t>(random_()) % count; }
  double number(double low, double high) { return uniform(random_, low, high); }
  glm::dvec3 whole() { return {pick(9), pick(9), pick(9)}; }

  /// A loop, which may cross itself, moved along a vector; its caps are drawn as fans.
  PolygonSoup prism() {
    PolygonSoup soup;
    std::vector<glm::dvec3> low, high;
    const glm::dvec3 along = whole() + glm::dvec3{0, 0, 1};
    for (std::uint32_t i = 0, corners = 3 + pick(5); i < corners; ++i) {
      low.push_back({pick(9), pick(9), 0});
      high.push_back(low.back() + along);
    }
    for (std::size_t i = 0; i < low.size(); ++i) {
      const std::size_t k = (i + 1) % low.size();
      add(soup, {low[i], low[k], high[k], high[i]});
    }
    add(soup, low);
    add(soup, high);
    return soup;
  }

  /// Two points over and under a loop of points: convex or not.
  PolygonSoup bipyramid() {
    PolygonSoup soup;
    std::vector<glm::dvec3> loop;
    for (std::uint32_t i = 0, corners = 3 + pick(6); i < corners; ++i) {
      const double angle = 2 * 3.14159265 * i / corners;
      loop.push_back({4 + number(1, 5) * std::cos(angle), 4 + number(1, 5) * std::sin(angle), number(2, 6)});
    }
    const glm::dvec3 top = whole(), bottom = whole();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      add(soup, {loop[i], loop[(i + 1) % loop.size()], top});
      add(soup, {loop[i], loop[(i + 1) % loop.size()], bottom});
    }
    return soup;
  }

  /// A box of which some corners were moved: its quadrilaterals are not plane.
  PolygonSoup bent_box() {
    PolygonSoup soup;
    add_box(soup, {0, 0, 0}, glm::dvec3{1, 1, 1} + whole(), pick(2) == 0);
    for (std::uint32_t i = pick(4); i > 0; --i) soup.vertices[pick(8)] = whole();
    return soup;
  }

  std::mt19937 random_;
};

TEST(InnerBoxesAgainstTheOracle, EveryBoxIsInside) {
  RecordProperty("seed", static_cast<int>(seed_of(1)));
  RandomSolids solids(seed_of(1));
  std::size_t boxes = 0, filled = 0;
  for (int i = 0; i < 300; ++i) {
    const PolygonSoup soup = solids.next();
    const InnerBoxes found = find_inner_boxes(soup, {.cells = i % 3 == 0 ? std::size_t{5} : std::size_t{16}});
    const std::vector<Triangle> triangles = triangles_of(soup);
    EXPECT_EQ(found.closed_parts, 1U);
    for (const auto& [box, polygon] : found.boxes) {
      const auto refuted = occlude::oracle::refute_inner_box(
          triangles, {{box.min.x, box.min.y, box.min.z}, {box.max.x, box.max.y, box.max.z}});
      EXPECT_EQ(refuted, "") << "solid " << i << " of seed " << seed_of(1);
    }
    boxes += found.boxes.size();
    filled += found.filled_parts;
  }
  EXPECT_GT(filled, 150U);
  EXPECT_GT(boxes, 400U);
  std::printf("%zu boxes in %zu solids\n", boxes, filled);
}

}  // namespace inner_boxes_test
