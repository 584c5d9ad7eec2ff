// SPDX-License-Identifier: MIT
// A model as the page of `inspect` has it, read back.
#include "packed_soup.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "page_reader.h"

namespace occlude::render {
namespace packed_soup_test {

struct Read {
  struct Polygon {
    std::vector<std::uint32_t> loop;
    bool is_see_through = false, is_same_face = false;
    Rgb colour = kWhite;
  };
  std::vector<Polygon> polygons;
  std::vector<glm::vec3> vertices;
};

Read read(const std::string& bytes, std::size_t vertices) {
  Read result;
  PageNumbers numbers(bytes);
  result.polygons.resize(numbers.next());
  for (Read::Polygon& polygon : result.polygons) {
    const std::uint64_t sides = numbers.next();
    polygon = {std::vector<std::uint32_t>(sides >> 2), (sides & 1) != 0, (sides & 2) != 0};
  }
  std::int64_t index = 0;
  for (Read::Polygon& polygon : result.polygons) {
    for (std::uint32_t& corner : polygon.loop) corner = static_cast<std::uint32_t>(index += numbers.difference());
  }
  std::vector<std::uint64_t> palette(numbers.next());
  std::uint64_t colour = 0;
  for (std::uint64_t& known : palette) known = colour += numbers.next();
  std::int64_t place = 0;
  for (Read::Polygon& polygon : result.polygons) {
    if (palette.empty()) break;
    const std::uint64_t number = palette.at(static_cast<std::size_t>(place += numbers.difference()));
    for (unsigned k = 0; k < 3; ++k) polygon.colour[k] = static_cast<std::uint8_t>(number >> (16 - 8 * k));
  }
  result.vertices.resize(vertices);
  for (int axis = 0; axis < 3; ++axis) {
    std::uint32_t bits = 0;
    const std::vector<float> differences = numbers.floats(vertices);
    for (std::size_t v = 0; v < vertices; ++v) {
      const auto folded = std::bit_cast<std::uint32_t>(differences[v]);
      bits += folded >> 1 ^ ((folded & 1) == 0 ? 0 : ~std::uint32_t{0});
      result.vertices[v][axis] = std::bit_cast<float>(bits);
    }
  }
  EXPECT_TRUE(numbers.is_at_end());
  return result;
}

/// Polygons of three to nine sides in a cube of this size; of some seeds with see-through ones, and faces of several.
culler::PolygonSoup random_soup(std::uint64_t seed, double low, double size) {
  std::mt19937_64 random(seed);
  culler::PolygonSoup soup;
  const auto next = [&] { return low + size * std::generate_canonical<double, 53>(random); };
  for (int v = 0; v < 100; ++v) {
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
  for (std::size_t p = 0; p < soup.size() && seed % 2 == 0; ++p) {
    soup.see_through.push_back(static_cast<std::uint8_t>(random() % 2));
  }
  return soup;
}

TEST(PackedSoup, KeepsPolygonsAndRoundsCoordinatesOnce) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const culler::PolygonSoup soup = random_soup(seed, -3, 10);
    const PackedSoup packed_soup = packed(soup);
    EXPECT_EQ(packed_soup.origin, glm::dvec3(0)) << "about 0";
    const Read again = read(packed_soup.bytes, soup.vertices.size());
    ASSERT_EQ(again.polygons.size(), soup.size());
    for (std::size_t p = 0; p < soup.size(); ++p) {
      const auto loop = soup.loop(p);
      EXPECT_EQ(again.polygons[p].loop, std::vector<std::uint32_t>(loop.begin(), loop.end()));
      EXPECT_EQ(again.polygons[p].is_see_through, !soup.is_opaque(p));
      EXPECT_EQ(again.polygons[p].is_same_face, p != 0 && soup.face(p) == soup.face(p - 1));
    }
    for (std::size_t v = 0; v < soup.vertices.size(); ++v) EXPECT_EQ(again.vertices[v], glm::vec3(soup.vertices[v]));
  }
}

TEST(PackedSoup, KeepsColours) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const culler::PolygonSoup soup = random_soup(seed, -3, 10);
    std::mt19937_64 random(seed);
    std::vector<Rgb> colours(soup.size());
    for (Rgb& colour : colours) {
      // Few that come again and again, or as many as there are polygons.
      const std::uint64_t bits = random() >> (seed % 2 == 0 ? 62 : 0);
      colour = {static_cast<std::uint8_t>(bits >> 16), static_cast<std::uint8_t>(bits >> 8),
                static_cast<std::uint8_t>(bits)};
    }
    const Read again = read(packed(soup, colours).bytes, soup.vertices.size());
    for (std::size_t p = 0; p < soup.size(); ++p) {
      EXPECT_EQ(again.polygons[p].colour, colours[p]);
      EXPECT_EQ(again.polygons[p].is_see_through, !soup.is_opaque(p));
    }
    for (std::size_t v = 0; v < soup.vertices.size(); ++v) EXPECT_EQ(again.vertices[v], glm::vec3(soup.vertices[v]));
  }
}

TEST(PackedSoup, OneColourIsNone) {
  const culler::PolygonSoup soup = random_soup(1, 0, 1);
  EXPECT_EQ(packed(soup, std::vector<Rgb>(soup.size(), {1, 2, 3})).bytes, packed(soup).bytes);
}

TEST(PackedSoup, HasItsDigitsHoweverFarFromZero) {
  for (const double low : {1e6, -3e9, 1e15}) {
    const double size = 1e-6 * std::abs(low);
    const culler::PolygonSoup soup = random_soup(1, low, size);
    const PackedSoup packed_soup = packed(soup);
    const Read again = read(packed_soup.bytes, soup.vertices.size());
    for (std::size_t v = 0; v < soup.vertices.size(); ++v) {
      for (int axis = 0; axis < 3; ++axis) {
        const double difference =
            packed_soup.origin[axis] + static_cast<double>(again.vertices[v][axis]) - soup.vertices[v][axis];
        // Half a unit in the last place of a float of twice the size, and what doubles round.
        EXPECT_LE(std::abs(difference), 2 * size * 0x1p-24 + std::abs(low) * 0x1p-52);
      }
    }
  }
}

TEST(PackedSoup, OfAPointFarAwayAndOfNothing) {
  culler::PolygonSoup point;
  point.add_vertex({1e20, 5, 0});
  point.add_polygon(std::vector<std::uint32_t>{0, 0, 0});
  EXPECT_EQ(packed(point).origin, glm::dvec3(1e20, 5, 0));
  EXPECT_EQ(packed({}).bytes, std::string(2, '\0'));
}

}  // namespace packed_soup_test
}  // namespace occlude::render
