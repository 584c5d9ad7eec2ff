// SPDX-License-Identifier: MIT
// The division of a mesh into sheets, and the numbers of what is gathered.
#include "cover/cover_sheets.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <bit>
#include <random>
#include <vector>

#include "base/local_index.h"
#include "cover/cover_group.h"
#include "cover/cover_triangles.h"
#include "occlude/culler/polygon_soup.h"

namespace cover_sheets_test {

using namespace occlude::culler;

/// Quadrilaterals, each a polygon, as seen along the z axis.
class Quads {
 public:
  void add(const std::array<glm::dvec3, 4>& corners) {
    const auto first = static_cast<std::uint32_t>(soup_.vertices.size());
    soup_.vertices.insert(soup_.vertices.end(), corners.begin(), corners.end());
    soup_.add_polygon(std::array{first, first + 1, first + 2, first + 3});
  }

  /// The polygons of each sheet, with the signs of the triangles in the plane.
  [[nodiscard]] std::vector<std::vector<std::uint32_t>> sheets() {
    triangles_ = CoverTriangles::find(soup_);
    CoverGroup group;
    for (std::uint32_t p = 0; p < soup_.size(); ++p) group.add(triangles_, p);
    const CoverMesh mesh = group.mesh(triangles_);
    std::vector<std::int8_t> signs;
    for (const auto& [a, b, c] : mesh.triangles) {
      const glm::dvec3 u = mesh.vertices[b] - mesh.vertices[a], v = mesh.vertices[c] - mesh.vertices[a];
      const double side = u.x * v.y - u.y * v.x;
      signs.push_back(static_cast<std::int8_t>(side > 0 ? 1 : side < 0 ? -1 : 0));
    }
    CoverSheets sheets;
    sheets.part(mesh, signs);
    std::vector<std::vector<std::uint32_t>> result;
    for (std::size_t i = 0; i < sheets.size(); ++i) {
      std::vector<std::uint32_t>& polygons = result.emplace_back();
      for (const std::uint32_t t : sheets[i]) {
        const std::uint32_t polygon = triangles_.polygon(group.ids()[t]);
        if (polygons.empty() || polygons.back() != polygon) polygons.push_back(polygon);
      }
    }
    return result;
  }

 private:
  PolygonSoup soup_;
  CoverTriangles triangles_;
};

using Polygons = std::vector<std::vector<std::uint32_t>>;

std::array<glm::dvec3, 4> square(double x, double y, double z = 0) {
  return {glm::dvec3{x, y, z}, {x + 1, y, z}, {x + 1, y + 1, z}, {x, y + 1, z}};
}

TEST(CoverSheets, NeighboursHangTogetherWhicheverWayTheyAreTurned) {
  Quads quads;
  quads.add(square(0, 0));
  quads.add(square(1, 0));
  auto turned = square(2, 0);
  std::ranges::reverse(turned);
  quads.add(turned);
  quads.add(square(9, 0));
  EXPECT_EQ(quads.sheets(), (Polygons{{0, 1, 2}, {3}}));
}

/// Both polygons at a fold lie on the same side of it in the picture.
TEST(CoverSheets, AFoldParts) {
  Quads quads;
  quads.add(square(0, 0));
  quads.add({glm::dvec3{1, 0, 0}, {0, 0, 1}, {0, 1, 1}, {1, 1, 0}});
  EXPECT_EQ(quads.sheets(), (Polygons{{0}, {1}}));
}

/// Of two equal walls, either may be the one that is joined with the neighbour.
TEST(CoverSheets, WhatIsThereTwiceDoesNotPart) {
  Quads quads;
  quads.add(square(0, 0));
  quads.add(square(0, 0));
  quads.add(square(1, 0));
  const Polygons sheets = quads.sheets();
  ASSERT_EQ(sheets.size(), 2U);
  const auto with_neighbour = std::ranges::find_if(sheets, [](const auto& s) { return s.back() == 2; });
  ASSERT_NE(with_neighbour, sheets.end());
  EXPECT_EQ(with_neighbour->size(), 2U);
}

TEST(CoverSheets, WhatIsSeenEdgeOnIsInNone) {
  Quads quads;
  quads.add({glm::dvec3{0, 0, 0}, {1, 0, 0}, {1, 0, 1}, {0, 0, 1}});
  quads.add(square(0, 0));
  EXPECT_EQ(quads.sheets(), (Polygons{{1}}));
}

/// Very many polygons share an edge. Their rings are cut, which loses connections but no polygon.
TEST(CoverSheets, ManyAlongOneEdgeAreAllInASheet) {
  Quads quads;
  for (int i = 0; i < 100; ++i) {
    quads.add({glm::dvec3{0, 0, 0}, {0, 1, 0}, {i % 2 == 0 ? 1.0 : -1.0, 1, i}, {i % 2 == 0 ? 1.0 : -1.0, 0, i}});
  }
  std::size_t polygons = 0;
  for (const auto& sheet : quads.sheets()) polygons += sheet.size();
  EXPECT_EQ(polygons, 100U);
}

TEST(LocalIndex, CountsWhatIsNewAndForgetsAll) {
  std::mt19937 random(5);
  LocalIndex index;
  for (const std::size_t size : {3U, 1000U, 10U, 5000U}) {
    index.clear();
    std::vector<std::uint32_t> things;
    for (std::size_t i = 0; i < size; ++i) {
      const auto thing = static_cast<std::uint32_t>(random() % (2 * size));
      const auto known = std::ranges::find(things, thing);
      const auto number = static_cast<std::uint32_t>(known - things.begin());
      EXPECT_EQ(index.find(thing), known == things.end() ? LocalIndex::kNone : number);
      EXPECT_EQ(index.number(thing), number);
      if (known == things.end()) things.push_back(thing);
      EXPECT_EQ(index.size(), things.size());
    }
  }
}

}  // namespace cover_sheets_test
