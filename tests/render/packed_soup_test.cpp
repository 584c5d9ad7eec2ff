// SPDX-License-Identifier: MIT
// A model that a page holds comes back to the last bit.
#include "packed_soup.h"

#include <gtest/gtest.h>

#include <bit>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace occlude::render {
namespace packed_soup_test {

/// Coordinates of any bits, and polygons of three to nine sides; of some seeds with see-through ones, and faces of several.
culler::PolygonSoup random_soup(std::uint64_t seed) {
  std::mt19937_64 random(seed);
  culler::PolygonSoup soup;
  for (int v = 0; v < 100; ++v) {
    const auto next = [&] { return std::bit_cast<double>(random()); };
    const double x = next(), y = next(), z = next();
    soup.add_vertex({x, y, z});
  }
  for (int p = 0; p < 50; ++p) {
    std::vector<std::uint32_t> loop(3 + random() % 7);
    for (std::uint32_t& index : loop) index = static_cast<std::uint32_t>(random() % 100);
    soup.add_polygon(loop);
  }
  for (std::uint32_t p = 0, face = 0; p < soup.size() && seed % 3 == 0; ++p) {
    soup.faces.push_back(face += p == 0 ? 0U : static_cast<std::uint32_t>(random() % 2));
  }
  for (std::size_t p = 0; p < soup.size() && seed % 2 == 0; ++p)
    soup.see_through.push_back(static_cast<std::uint8_t>(random() % 2));
  return soup;
}

TEST(PackedSoup, ComesBackToTheLastBit) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const culler::PolygonSoup soup = random_soup(seed), again = unpacked(packed(soup));
    EXPECT_EQ(again.first, soup.first);
    EXPECT_EQ(again.indices, soup.indices);
    EXPECT_EQ(again.faces, soup.faces);
    EXPECT_EQ(again.see_through, soup.see_through);
    ASSERT_EQ(again.vertices.size(), soup.vertices.size());
    for (std::size_t v = 0; v < soup.vertices.size(); ++v) {
      for (int axis = 0; axis < 3; ++axis) {
        EXPECT_EQ(std::bit_cast<std::uint64_t>(again.vertices[v][axis]),
                  std::bit_cast<std::uint64_t>(soup.vertices[v][axis]));
      }
    }
  }
}

TEST(PackedSoup, OfNothingIsNothing) {
  const culler::PolygonSoup none = unpacked(packed({}));
  EXPECT_TRUE(none.empty());
  EXPECT_TRUE(none.vertices.empty());
}

TEST(PackedSoup, RefusesWhatEndsEarlyOrCountsTooMuch) {
  const std::string bytes = packed(random_soup(1));
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_THROW(static_cast<void>(unpacked(std::string_view(bytes).substr(0, size))), std::invalid_argument) << size;
  }
  EXPECT_THROW(static_cast<void>(unpacked("\xff\xff\xff\xff\xff\xff\xff\xff\x7f")), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(unpacked(std::string(20, '\xff'))), std::invalid_argument);
}

}  // namespace packed_soup_test
}  // namespace occlude::render
