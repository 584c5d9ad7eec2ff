// SPDX-License-Identifier: MIT
// Parts of soups, closed and open.
#include "frusta/closed_parts.h"

#include <gtest/gtest.h>

#include <array>
#include <vector>

#include "model/adjacency.h"
#include "scenes.h"

namespace closed_parts_test {

using namespace occlude::culler;

/// The sizes of the parts, negative where one is open.
std::vector<int> parts_of(SoupView soup) {
  const std::vector<std::uint32_t> weld = welded(soup.vertices);
  std::vector<int> sizes;
  for (const auto& part : find_parts(soup, weld)) {
    sizes.push_back(static_cast<int>(part.size()) * (is_closed(soup, weld, part) ? 1 : -1));
  }
  return sizes;
}

TEST(ClosedParts, AreConnectedOverCorners) {
  PolygonSoup soup;
  soup.add_box({0, 0, 0}, {1, 1, 1});
  add(soup, {{5, 0, 0}, {6, 0, 0}, {5, 1, 0}});
  add_box(soup, {1, 1, 1}, {2, 2, 2}, true);
  EXPECT_EQ(parts_of(soup), (std::vector{18, -1}));
  add(soup, {{1, 1, 1}, {6, 0, 0}, {9, 9, 9}});
  EXPECT_EQ(parts_of(soup), std::vector{-20}) << "joined by one that is open";
  EXPECT_EQ(parts_of({}), std::vector<int>{});
}

TEST(ClosedParts, ByEdgesWithAnEvenNumberOfSides) {
  const auto without = [](std::size_t left_out) {
    PolygonSoup box, soup;
    box.add_box({0, 0, 0}, {2, 2, 2});
    soup.vertices = box.vertices;
    for (std::size_t p = 0; p < box.size(); ++p) {
      if (p != left_out) soup.add_polygon(box.loop(p));
    }
    return soup;
  };
  EXPECT_EQ(parts_of(without(6)), std::vector{6});
  for (std::size_t p = 0; p < 6; ++p) EXPECT_EQ(parts_of(without(p)), std::vector{-5});
  PolygonSoup soup = without(0);
  add(soup, {{0, 0, 0}, {0, 2, 0}, {0, 2, 2}, {0, 0, 2}});
  EXPECT_EQ(parts_of(soup), std::vector{6}) << "turned the other way, with corners of its own";
  soup = without(0);
  add(soup, {{0, 0, 0}, {0, 0, 1}, {0, 0, 2}, {0, 2, 2}, {0, 2, 0}});
  EXPECT_EQ(parts_of(soup), std::vector{-6}) << "a T-junction";
  soup = without(0);
  add(soup, {{0, 0, 0}, {0, 0, 0}, {0, 0, 2}, {0, 2, 2}, {0, 2, 2}, {0, 2, 0}, {0, 0, 0}});
  EXPECT_EQ(parts_of(soup), std::vector{6}) << "corners are repeated";
  soup = without(6);
  soup.add_polygon(std::array{0U, 1U, 3U, 2U});
  EXPECT_EQ(parts_of(soup), std::vector{-7}) << "three polygons at an edge";
  soup.add_polygon(std::array{0U, 1U, 3U, 2U});
  EXPECT_EQ(parts_of(soup), std::vector{8}) << "four";
}

}  // namespace closed_parts_test
