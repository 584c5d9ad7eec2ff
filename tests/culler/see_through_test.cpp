// SPDX-License-Identifier: MIT
// See-through polygons hide nothing, and are hidden as all others.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "forged_parts.h"
#include "frame/culler_access.h"
#include "occlude/culler/culler.h"
#include "occlude/culler/inner_boxes.h"
#include "occlude/culler/scene.h"
#include "scenes.h"

namespace see_through_test {

using namespace occlude::culler;

constexpr Camera kCamera{.eye = {0, 0, 0}, .target = {1, 0, 0}, .near_plane = 0.1};

enum class Wall { opaque, glass, glass_before_opaque, opaque_before_glass, half_glass };

/// Small things at x = 20, behind one wall or two at x = 10, 11 or 15, each of two triangles.
PolygonSoup room(Wall wall) {
  PolygonSoup soup;
  const auto add_panels = [&](double x, bool is_opaque, bool is_half = false) {
    const std::size_t first = soup.size();
    add(soup, {{x, -8, -8}, {x, 8, -8}, {x, 8, 8}});
    const std::size_t second = soup.size();
    add(soup, {{x, -8, -8}, {x, 8, 8}, {x, -8, 8}});
    if (!is_opaque) soup.see_through_from(first);
    if (is_half) soup.see_through_from(second);
  };
  switch (wall) {
    case Wall::opaque:
      add_panels(10, true);
      break;
    case Wall::glass:
      add_panels(10, false);
      break;
    case Wall::half_glass:
      add_panels(10, true, true);
      break;
    case Wall::glass_before_opaque:
      add_panels(11, true), add_panels(10, false);
      break;
    case Wall::opaque_before_glass:
      add_panels(10, true), add_panels(15, false);
      break;
  }
  for (int y = -4; y < 4; ++y) {
    for (int z = -4; z < 4; ++z) add(soup, {{20, y, z}, {20, y + 0.5, z}, {20, y, z + 0.5}});
  }
  return soup;
}

constexpr std::size_t kThings = 64;

std::size_t drawn(Wall wall, Method method) {
  const Culler culler(room(wall), {.hierarchy = {.leaf_size = 1}});
  View view;
  return culler.cull(kCamera, {.method = method, .occluders = 8}, view).stats.drawn_polygons;
}

TEST(SeeThrough, HidesNothingAndIsHidden) {
  for (const Method method : {Method::frusta, Method::cover}) {
    SCOPED_TRACE(method == Method::cover ? "cover" : "frusta");
    EXPECT_EQ(drawn(Wall::opaque, method), 2);
    EXPECT_EQ(drawn(Wall::glass, method), 2 + kThings);
    EXPECT_EQ(drawn(Wall::glass_before_opaque, method), 4);
    EXPECT_EQ(drawn(Wall::opaque_before_glass, method), 2) << "glass that is hidden is culled";
    EXPECT_GT(drawn(Wall::half_glass, method), 2 + kThings / 3) << "what only both panels hide shows";
    EXPECT_LT(drawn(Wall::half_glass, method), 2 + kThings);
  }
}

TEST(SeeThrough, NoBoxIsInsideOfGlass) {
  PolygonSoup soup;
  soup.add_box({0, 0, 0}, {1, 1, 1});
  EXPECT_EQ(find_inner_boxes(soup, {}).boxes.size(), 1);
  soup.see_through_from(5);
  EXPECT_TRUE(find_inner_boxes(soup, {}).boxes.empty());
}

TEST(SeeThrough, AMeshOfAScene) {
  for (const bool is_opaque : {true, false}) {
    PolygonSoup wall;
    add_wall(wall, 10, -8, 8, -8, 8);
    if (!is_opaque) wall.see_through_from(0);
    Scene scene;
    scene.add(occlude::kernel::Aabb{{20, -1, -1}, {21, 1, 1}});
    scene.add(std::make_shared<const OccluderMesh>(wall), {});
    scene.update();
    SceneView view;
    EXPECT_EQ(scene.cull(kCamera, {}, view).drawn.size(), is_opaque ? 0 : 1);
  }
}

TEST(SeeThrough, StaysSoInParts) {
  const Culler culler(room(Wall::half_glass), {.hierarchy = {.leaf_size = 1}});
  const Culler stored(culler.parts());
  View view, other;
  for (const Method method : {Method::frusta, Method::cover}) {
    EXPECT_EQ(stored.cull(kCamera, {.method = method}, view).drawn, culler.cull(kCamera, {.method = method}, other).drawn);
  }
}

TEST(SeeThrough, RefusesPartsInWhichGlassHides) {
  const Culler opaque(room(Wall::opaque), {.hierarchy = {.leaf_size = 1}});
  const std::size_t polygons = opaque.hierarchy().soup().size();
  ForgedParts forged(opaque);
  ASSERT_EQ(forged.refusal(), "");
  // As if the panels were glass, of which all else is as if they were opaque.
  std::vector<std::uint8_t> marks(polygons);
  for (std::size_t p = 0; p < polygons; ++p) marks[p] = opaque.hierarchy().original(p) < 2;
  forged.set("see-through", marks);
  EXPECT_EQ(forged.refusal(), "part \"region corners\": a region is not made of its polygons");
  for (const std::string& name : std::vector(forged.names())) {
    if (Culler::method_of(name) == Method::frusta) forged.erase(name);
  }
  EXPECT_EQ(forged.refusal(), "part \"cover corners\": the triangles are not those of the polygons");
  marks[0] = 2;
  forged.set("see-through", marks);
  EXPECT_EQ(forged.refusal(), "the soup's `see_through` is not 0 or 1 for each polygon");
  marks.pop_back();
  forged.set("see-through", marks);
  EXPECT_EQ(forged.refusal(), "the soup's `see_through` is not 0 or 1 for each polygon");
}

/// As if one panel of two were glass, and its own region had no corners, but the region that joins both were as before.
TEST(SeeThrough, RefusesPartsInWhichGlassIsJoined) {
  const Culler opaque(room(Wall::opaque), {.hierarchy = {.leaf_size = 1}});
  const std::size_t polygons = opaque.hierarchy().soup().size();
  ASSERT_GT(occluders_of(opaque).regions().size(), polygons) << "the panels are joined";
  ForgedParts forged(opaque);
  std::vector<std::uint8_t> marks(polygons);
  std::size_t panel = 0;
  while (opaque.hierarchy().original(panel) != 1) ++panel;
  marks[panel] = 1;
  forged.set("see-through", marks);
  auto corners = forged.get<std::uint32_t>("region corners"), first = forged.get<std::uint32_t>("region first corner");
  const auto begin = corners.begin() + first[panel];
  corners.erase(begin, begin + 3);
  for (std::size_t r = panel + 1; r < first.size(); ++r) first[r] -= 3;
  forged.set("region corners", corners);
  forged.set("region first corner", first);
  EXPECT_EQ(forged.refusal(), "part \"region corners\": a region is not made of its polygons");
}

/// As if a region of space listed a see-through polygon.
TEST(SeeThrough, RefusesPartsInWhichGlassIsListed) {
  PolygonSoup soup = room(Wall::opaque);
  soup.see_through_from(2);
  const Culler culler(soup, {.hierarchy = {.leaf_size = 1}, .occluders = {.shells = false}});
  ForgedParts forged(culler);
  ASSERT_EQ(forged.refusal(), "");
  std::uint32_t glass = 0;
  while (culler.hierarchy().soup().is_opaque(glass)) ++glass;
  const auto first = forged.get<std::uint64_t>("list first");
  const auto filled = std::ranges::adjacent_find(first, std::less());
  ASSERT_NE(filled, first.end());
  forged.edit<std::uint32_t>("listed", [&](auto& entries) {
    const std::span list(entries.begin() + static_cast<std::ptrdiff_t>(filled[0]),
                         entries.begin() + static_cast<std::ptrdiff_t>(filled[1]));
    list.back() = glass;
    std::ranges::sort(list);
  });
  EXPECT_EQ(forged.refusal(), "part \"listed\": the lists are not of these regions and occluders");
}

TEST(Soup, FacesAreNumberedInTheOrderOfTheInput) {
  PolygonSoup soup;
  for (const glm::dvec3& v :
       std::vector<glm::dvec3>{{0, 0, 0}, {0, 4, 0}, {0, 4, 8}, {0, 6, 8}, {0, 6, 0}, {0, 10, 0}, {0, 10, 10}, {0, 0, 10}}) {
    soup.add_vertex(v);
  }
  const std::vector<std::uint32_t> doorway{0, 1, 2, 3, 4, 5, 6, 7}, square{0, 5, 6, 7}, tie{0, 6, 5, 7};
  EXPECT_EQ(soup.add_face(square), FaceShape::fan);
  EXPECT_EQ(soup.add_face(doorway), FaceShape::pieces);
  EXPECT_EQ(soup.add_face(tie), FaceShape::crossing);
  EXPECT_EQ(soup.add_face(square), FaceShape::fan);
  ASSERT_EQ(soup.size(), 1 + 6 + 1 + 1);
  EXPECT_EQ(soup.face_count(), 4);
  EXPECT_EQ(soup.faces, (std::vector<std::uint32_t>{0, 1, 1, 1, 1, 1, 1, 2, 3}));
  EXPECT_EQ(soup.see_through, (std::vector<std::uint8_t>{0, 0, 0, 0, 0, 0, 0, 1, 0}));
  const Culler culler(soup);
  for (std::size_t p = 0; p < soup.size(); ++p) {
    EXPECT_EQ(culler.hierarchy().face(p), soup.face(culler.hierarchy().original(p)));
    EXPECT_EQ(culler.hierarchy().soup().is_opaque(p), soup.is_opaque(culler.hierarchy().original(p)));
  }
  soup.faces[8] = 4;
  EXPECT_THROW(Culler{soup}, std::invalid_argument);
}

}  // namespace see_through_test
