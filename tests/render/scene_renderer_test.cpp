// SPDX-License-Identifier: MIT
#include "occlude/render/scene_renderer.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <span>
#include <tuple>
#include <vector>

#include "occlude/render/offscreen_context.h"

namespace occlude::render {
namespace scene_renderer_test {

using culler::Camera;
using culler::PolygonSoup;
using culler::SoupView;
using glm::dvec3;

constexpr int kWidth = 64, kHeight = 36;

class SceneRendererTest : public testing::Test {
 protected:
  /// A camera at `eye` that looks along +x.
  [[nodiscard]] static Camera camera_at(const dvec3& eye) {
    Camera camera;
    camera.eye = eye;
    camera.target = eye + dvec3(1, 0, 0);
    return camera;
  }
  /// Adds the quadrilateral at x, with y to the left of a camera looking along +x and z up.
  static void add_wall(PolygonSoup& soup, double x, double y0, double y1, double z0, double z1) {
    const std::array<std::uint32_t, 4> loop = {soup.add_vertex({x, y0, z0}), soup.add_vertex({x, y1, z0}),
                                               soup.add_vertex({x, y1, z1}), soup.add_vertex({x, y0, z1})};
    soup.add_polygon(loop);
  }
  [[nodiscard]] static std::uint32_t count(SoupView soup) { return static_cast<std::uint32_t>(soup.size()); }
  [[nodiscard]] static std::size_t pixels(const ItemBuffer& items, std::uint32_t item) {
    return static_cast<std::size_t>(std::ranges::count(items.pixels, item));
  }
  [[nodiscard]] static ItemBuffer items_of(SoupView soup, const Camera& camera) {
    const PolygonRange all{0, count(soup)};
    return SceneRenderer(soup, kWidth, kHeight).item_buffer(camera, std::span(&all, 1));
  }
  /// Crossing walls before the camera, many of them hidden.
  [[nodiscard]] static PolygonSoup clutter(std::size_t polygons) {
    std::mt19937 random(7);
    const auto uniform = [&](double low, double high) {
      return low + (high - low) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
    };
    PolygonSoup soup;
    for (std::size_t p = 0; p < polygons; ++p) {
      const dvec3 centre(uniform(2, 40), uniform(-20, 20), uniform(-12, 12));
      std::array<std::uint32_t, 4> loop;
      const dvec3 u(uniform(-3, 3), uniform(-3, 3), 0), v(uniform(-1, 1), 0, uniform(1, 4));
      const std::array<dvec3, 4> corners = {centre - u - v, centre + u - v, centre + u + v, centre - u + v};
      for (std::size_t i = 0; i < 4; ++i) loop[i] = soup.add_vertex(corners[i]);
      soup.add_polygon(loop);
    }
    return soup;
  }

  std::unique_ptr<OffscreenContext> context_ = make_offscreen_context();
};

TEST_F(SceneRendererTest, AWallCoversItsPixels) {
  // At distance 1 the picture is 2 tan 30 high; the wall takes its left upper quarter.
  const double top = 0.57735026918962576, left = top * 16 / 9;
  PolygonSoup soup;
  add_wall(soup, 10, 0, 20 * left, 0, 20 * top);
  SceneRenderer renderer(soup, kWidth, kHeight);
  const PolygonRange all{0, 1};
  renderer.draw(camera_at({0, 0, 0}), std::span(&all, 1));
  const ItemBuffer items = items_of(soup, camera_at({0, 0, 0}));
  const Image image = renderer.image();
  const Rgba sky = image.at(kWidth - 1, kHeight - 1);
  ASSERT_EQ(items.width, kWidth);
  ASSERT_EQ(items.height, kHeight);
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const bool covered = x < kWidth / 2 && y < kHeight / 2;
      EXPECT_EQ(items.at(x, y), covered ? 0 : kNothing) << x << ' ' << y;
      EXPECT_EQ(image.at(x, y) == sky, !covered) << x << ' ' << y;
      EXPECT_EQ(image.at(x, y).a, 255);
    }
  }
}

TEST_F(SceneRendererTest, NothingDrawnIsSkyAndNoItem) {
  PolygonSoup soup;
  add_wall(soup, -10, -5, 5, -5, 5);  // behind the eye
  EXPECT_EQ(pixels(items_of(soup, camera_at({0, 0, 0})), kNothing), std::size_t{kWidth * kHeight});
}

TEST_F(SceneRendererTest, TheNearerPolygonHidesTheFartherInEitherOrder) {
  for (const bool near_first : {true, false}) {
    PolygonSoup soup;
    add_wall(soup, near_first ? 10 : 20, -1e3, 1e3, -1e3, 1e3);
    add_wall(soup, near_first ? 20 : 10, -1e3, 1e3, -1e3, 1e3);
    EXPECT_EQ(pixels(items_of(soup, camera_at({0, 0, 0})), near_first ? 0 : 1), std::size_t{kWidth * kHeight});
  }
}

/// A wall of glass before a wall, and one behind it.
TEST_F(SceneRendererTest, SeeThroughPolygonsHideNothingAndAreHidden) {
  PolygonSoup soup;
  add_wall(soup, 5, -1, 1, -1, 1);
  soup.see_through_from(0);
  add_wall(soup, 10, -9, 9, -9, 9);
  add_wall(soup, 15, -99, 99, -5, 5);
  soup.see_through_from(2);
  const ItemBuffer items = items_of(soup, camera_at({0, 0, 0}));
  PolygonSoup wall;
  add_wall(wall, 10, -9, 9, -9, 9);
  const ItemBuffer alone = items_of(wall, camera_at({0, 0, 0}));
  EXPECT_TRUE(alone.before.pixels.empty());
  EXPECT_TRUE(alone.see_through.empty());
  ASSERT_GT(pixels(alone, kNothing), 0U);
  for (std::size_t i = 0; i < items.pixels.size(); ++i) {
    ASSERT_EQ(items.pixels[i], alone.pixels[i] == kNothing ? kNothing : 1U);
    ASSERT_EQ(items.before.pixels[i] == 2, alone.pixels[i] == kNothing && items.before.pixels[i] != kNothing);
  }
  const auto count_before = [&](std::uint32_t p) { return std::ranges::count(items.before.pixels, p); };
  EXPECT_GT(count_before(0), 0);
  EXPECT_GT(count_before(2), 0);
  EXPECT_EQ(items.see_through, (std::vector<std::uint32_t>{static_cast<std::uint32_t>(count_before(0)), 0,
                                                           static_cast<std::uint32_t>(count_before(2))}));
  EXPECT_EQ(items.pixels_of(3)[1], pixels(items, 1));
  EXPECT_EQ(items.pixels_of(3)[0], items.see_through[0]);
}

/// Each of many panes, one behind another, is seen in as many pixels as if it were alone.
TEST_F(SceneRendererTest, SeeThroughPolygonsDoNotHideEachOther) {
  PolygonSoup panes;
  for (int i = 0; i < 9; ++i) add_wall(panes, 2 + i, -1, 1, -1, 1);
  PolygonSoup glass = panes;
  glass.see_through_from(0);
  const ItemBuffer items = items_of(glass, camera_at({0, 0, 0}));
  for (std::uint32_t p = 0; p < panes.size(); ++p) {
    const PolygonRange only{p, 1};
    const ItemBuffer alone = SceneRenderer(panes, kWidth, kHeight).item_buffer(camera_at({0, 0, 0}), std::span(&only, 1));
    EXPECT_EQ(items.see_through[p], pixels(alone, p)) << p;
  }
  EXPECT_EQ(pixels(items, kNothing), items.pixels.size());
}

TEST_F(SceneRendererTest, GlassTintsWhatIsBehindIt) {
  PolygonSoup soup;
  add_wall(soup, 10, -99, 99, -99, 99);
  add_wall(soup, 5, -1, 1, -1, 1);
  soup.see_through_from(1);
  add_wall(soup, 20, -99, 99, -99, 99);
  soup.see_through_from(2);
  SceneRenderer renderer(soup, kWidth, kHeight);
  const auto picture = [&](std::vector<PolygonRange> ranges) {
    renderer.draw(camera_at({0, 0, 0}), ranges);
    return renderer.image();
  };
  const Image all = picture({{0, 3}}), visible = picture({{0, 2}}), wall = picture({{0, 1}}), pane = picture({{1, 1}});
  EXPECT_EQ(all.pixels, visible.pixels) << "hidden glass leaves no trace";
  const Rgba tinted = all.at(kWidth / 2, kHeight / 2), behind = wall.at(kWidth / 2, kHeight / 2);
  EXPECT_NE(tinted, behind);
  EXPECT_NE(tinted, pane.at(kWidth / 2, kHeight / 2));
  EXPECT_EQ(tinted.a, 255);
  EXPECT_EQ(all.at(0, 0), wall.at(0, 0)) << "beside the pane";
}

TEST_F(SceneRendererTest, BothSidesAreOpaque) {
  PolygonSoup soup;
  add_wall(soup, 10, 1e3, -1e3, -1e3, 1e3);
  EXPECT_EQ(pixels(items_of(soup, camera_at({0, 0, 0})), 0), std::size_t{kWidth * kHeight});
  Camera back = camera_at({20, 0, 0});
  back.target = {0, 0, 0};
  EXPECT_EQ(pixels(items_of(soup, back), 0), std::size_t{kWidth * kHeight});
}

TEST_F(SceneRendererTest, ItemsAreExactToTheLastNumber) {
  // More polygons than 16 bits can number. All but the last few are degenerate, at one point.
  PolygonSoup soup;
  const std::uint32_t point = soup.add_vertex({5, 0, 0});
  const std::array<std::uint32_t, 3> degenerate = {point, point, point};
  constexpr std::uint32_t kMany = (1 << 17) + 1;
  for (std::uint32_t i = 0; i < kMany; ++i) soup.add_polygon(degenerate);
  for (int strip = 0; strip < 4; ++strip) add_wall(soup, 10, 100, -100, -100.0 + 50 * strip, -50.0 + 50 * strip);
  const ItemBuffer items = items_of(soup, camera_at({0, 0, 0}));
  EXPECT_EQ(pixels(items, kMany + 1) + pixels(items, kMany + 2), std::size_t{kWidth * kHeight});
  EXPECT_EQ(items.at(5, 0), kMany + 2);
  EXPECT_EQ(items.at(5, kHeight - 1), kMany + 1);
}

TEST_F(SceneRendererTest, OnlyTheRangesGivenAreDrawn) {
  PolygonSoup soup;
  for (int i = 0; i < 6; ++i) add_wall(soup, 10, -6.0 + 2 * i, -4.0 + 2 * i, -4, 4);
  SceneRenderer renderer(soup, kWidth, kHeight);
  const std::vector<PolygonRange> ranges = {{0, 1}, {1, 1}, {3, 0}, {4, 2}};
  const ItemBuffer items = renderer.item_buffer(camera_at({0, 0, 0}), ranges);
  for (const std::uint32_t drawn : {0U, 1U, 4U, 5U}) EXPECT_GT(pixels(items, drawn), 20U) << drawn;
  for (const std::uint32_t left_out : {2U, 3U}) EXPECT_EQ(pixels(items, left_out), 0U) << left_out;
}

TEST_F(SceneRendererTest, DepthSeparatesFiveCentimetresAtTwoKilometres) {
  for (const bool near_first : {true, false}) {
    PolygonSoup soup;
    add_wall(soup, near_first ? 2000 : 2000.05, -3e3, 3e3, -3e3, 3e3);
    add_wall(soup, near_first ? 2000.05 : 2000, -3e3, 3e3, -3e3, 3e3);
    EXPECT_EQ(pixels(items_of(soup, camera_at({0, 0, 0})), near_first ? 0 : 1), std::size_t{kWidth * kHeight});
  }
}

TEST_F(SceneRendererTest, AModelFarFromTheOriginLooksTheSame) {
  const PolygonSoup soup = clutter(200);
  PolygonSoup moved = soup;
  const dvec3 offset(4e6, -3e6, 1e5);
  for (dvec3& v : moved.vertices) v += offset;
  const ItemBuffer here = items_of(soup, camera_at({0, 0, 0})), there = items_of(moved, camera_at(offset));
  // Doubles round at 4e6 to 5e-10: no pixel but one on an edge may change.
  std::size_t different = 0;
  for (std::size_t i = 0; i < here.pixels.size(); ++i) different += here.pixels[i] != there.pixels[i];
  EXPECT_LE(different, 2U);
}

TEST_F(SceneRendererTest, TheEyeKeepsWhatFloatCannotHold) {
  // Floats are 1/256 apart at 40000. The wall lies 7/64 before the eye and its right edge 1/512 to the right of the
  // picture's middle, which is 0.56 pixels: the first column right of the middle is covered.
  PolygonSoup soup;
  add_wall(soup, 40000 + 8.0 / 64, 40000, 50000, -100, 100);
  const ItemBuffer items = items_of(soup, camera_at({40000 + 1.0 / 64, 40000 + 1.0 / 512, 0}));
  EXPECT_EQ(items.at(kWidth / 2, 5), 0U);
  EXPECT_EQ(items.at(kWidth / 2 + 1, 5), kNothing);
}

TEST_F(SceneRendererTest, HiddenPolygonsLeaveNoTrace) {
  const PolygonSoup soup = clutter(3000);
  SceneRenderer renderer(soup, kWidth, kHeight);
  const PolygonRange everything{0, count(soup)};
  renderer.draw(camera_at({0, 0, 0}), std::span(&everything, 1));
  const ItemBuffer all = items_of(soup, camera_at({0, 0, 0}));
  const Image picture = renderer.image();
  std::vector<bool> seen(soup.size());
  for (const std::uint32_t item : all.pixels) {
    if (item != kNothing) seen[item] = true;
  }
  std::vector<PolygonRange> visible;
  for (std::uint32_t p = 0; p < count(soup); ++p) {
    if (seen[p]) visible.push_back({p, 1});
  }
  ASSERT_LT(visible.size(), soup.size() / 2);
  renderer.draw(camera_at({0, 0, 0}), visible);
  EXPECT_EQ(renderer.item_buffer(camera_at({0, 0, 0}), visible).pixels, all.pixels);
  EXPECT_EQ(renderer.image().pixels, picture.pixels);
}

TEST_F(SceneRendererTest, OfCoplanarPolygonsTheFirstIsSeen) {
  PolygonSoup soup;
  add_wall(soup, 10, -100, 100, -100, 100);
  add_wall(soup, 10, -100, 100, -100, 100);
  EXPECT_EQ(pixels(items_of(soup, camera_at({0, 0, 0})), 0), std::size_t{kWidth * kHeight});
}

TEST_F(SceneRendererTest, NearAndFarPlanesClip) {
  PolygonSoup soup;
  add_wall(soup, 5, -100, 100, -100, 100);
  add_wall(soup, 10, -100, 100, -100, 100);
  add_wall(soup, 20, -100, 100, -100, 100);
  Camera camera = camera_at({0, 0, 0});
  camera.near_plane = 6;
  EXPECT_EQ(pixels(items_of(soup, camera), 1), std::size_t{kWidth * kHeight});
  camera.near_plane = 11;
  camera.far_plane = 19;
  EXPECT_EQ(pixels(items_of(soup, camera), kNothing), std::size_t{kWidth * kHeight});
  camera.far_plane = 21;
  EXPECT_EQ(pixels(items_of(soup, camera), 2), std::size_t{kWidth * kHeight});
}

TEST_F(SceneRendererTest, OrthographicSizesDoNotShrinkWithDistance) {
  PolygonSoup soup;
  add_wall(soup, 10, 0, 100, 0, 100);
  add_wall(soup, 9000, -100, 0, -100, 0);
  Camera camera = camera_at({0, 0, 0});
  camera.projection = culler::Projection::orthographic;
  camera.height = 36;
  const ItemBuffer items = items_of(soup, camera);
  EXPECT_EQ(pixels(items, 0), std::size_t{kWidth / 2 * kHeight / 2});
  EXPECT_EQ(pixels(items, 1), std::size_t{kWidth / 2 * kHeight / 2});
  EXPECT_EQ(items.at(0, 0), 0U);
  camera.far_plane = 8000;
  EXPECT_EQ(pixels(items_of(soup, camera), 1), 0U);
  camera.near_plane = 11;
  EXPECT_EQ(pixels(items_of(soup, camera), 0), 0U);
}

TEST_F(SceneRendererTest, PictureAndItemBufferShowTheSamePolygons) {
  const PolygonSoup soup = clutter(3000);
  Camera camera = camera_at({1.0 / 3, 1.0 / 7, 1.0 / 9});
  camera.projection = culler::Projection::orthographic;  // without haze each polygon has one colour
  camera.height = 20;
  SceneRenderer renderer(soup, 320, 180);
  const PolygonRange all{0, count(soup)};
  const ItemBuffer items = renderer.item_buffer(camera, std::span(&all, 1));
  renderer.draw(camera, std::span(&all, 1));
  const Image picture = renderer.image();
  std::map<std::uint32_t, Rgba> colours;
  std::set<std::tuple<int, int, int>> different;
  for (std::size_t i = 0; i < items.pixels.size(); ++i) {
    const Rgba& pixel = picture.pixels[i];
    const auto [colour, is_new] = colours.emplace(items.pixels[i], pixel);
    ASSERT_EQ(colour->second, pixel) << i;
    if (is_new) different.emplace(pixel.r, pixel.g, pixel.b);
  }
  EXPECT_GT(colours.size(), 200U);
  EXPECT_EQ(different.size(), colours.size());
}

TEST_F(SceneRendererTest, TheItemBufferLeavesThePictureAsItWas) {
  const PolygonSoup soup = clutter(100);
  SceneRenderer renderer(soup, kWidth, kHeight);
  const std::vector<PolygonRange> all = {{0, count(soup)}};
  renderer.draw(camera_at({0, 0, 0}), all);
  const Image before = renderer.image();
  EXPECT_GT(pixels(renderer.item_buffer(camera_at({0, 3, 0}), all), kNothing), 0U);
  EXPECT_EQ(renderer.image().pixels, before.pixels);
  renderer.draw(camera_at({0, 0, 0}), all);
  EXPECT_EQ(renderer.image().pixels, before.pixels);
}

TEST_F(SceneRendererTest, ImpossibleSizesAreRefused) {
  PolygonSoup soup;
  add_wall(soup, 5, 0, 1, 0, 1);
  EXPECT_THROW(SceneRenderer(soup, 0, 10), std::runtime_error);
  EXPECT_THROW(SceneRenderer(soup, 10, 1 << 20), std::runtime_error);
}

TEST_F(SceneRendererTest, AnOffsetMovesItemBuffersByPartsOfAPixel) {
  PolygonSoup soup;
  Camera camera = camera_at({0, 0, 0});
  camera.projection = culler::Projection::orthographic;
  camera.height = kHeight;  // a pixel is 1 large, and the middle of the picture is the corner of four
  add_wall(soup, 5, -4, -0.7, 0.3, 3);
  SceneRenderer renderer(soup, kWidth, kHeight);
  const PolygonRange all{0, 1};
  const auto shows = [&](const glm::dvec2& offset, int x, int y) {
    return renderer.item_buffer(camera, std::span(&all, 1), offset).at(x, y) == 0;
  };
  const int right = kWidth / 2, above = kHeight / 2 - 1;
  EXPECT_FALSE(shows({0, 0}, right, above));
  EXPECT_TRUE(shows({-0.375, 0}, right, above));  // its side at 0.7 is now before the pixel's centre at 0.5
  EXPECT_FALSE(shows({0.375, 0}, right, above));
  EXPECT_TRUE(shows({0, 0}, right + 1, above));
  EXPECT_TRUE(shows({0, 0.125}, right + 1, above));
  EXPECT_FALSE(shows({0, 0.375}, right + 1, above));  // its lower side at 0.3 is above the centre
}

/// Polygons thinner than the grid to which vertices are rounded would have an arbitrary depth at a pixel.
TEST_F(SceneRendererTest, NothingHiddenShowsWhereItIsSeenEdgeOn) {
  PolygonSoup soup;
  // A slanted wall, and behind it strips in planes that almost pass through the eye. Each strip begins nearer to the eye
  // than the far end of the wall.
  const std::array<std::uint32_t, 4> wall = {soup.add_vertex({10, 8, -8}), soup.add_vertex({30, -24, -8}),
                                             soup.add_vertex({30, -24, 8}), soup.add_vertex({10, 8, 8})};
  soup.add_polygon(wall);
  std::mt19937 random(3);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
  };
  for (int i = 0; i < 20000; ++i) {
    const double y = uniform(-0.3, 0.3), tilt = uniform(-1e-3, 1e-3), z = uniform(-0.2, 0.2);
    const double low = uniform(20, 25), high = low + uniform(5, 20);
    const std::array<std::uint32_t, 4> strip = {
        soup.add_vertex({low, y * low, low * (z - 0.1)}), soup.add_vertex({high, y * high + tilt, high * (z - 0.1)}),
        soup.add_vertex({high, y * high + tilt, high * (z + 0.1)}), soup.add_vertex({low, y * low, low * (z + 0.1)})};
    soup.add_polygon(strip);
  }
  const ItemBuffer items = items_of(soup, camera_at({0, 0, 0}));
  EXPECT_EQ(std::ranges::count_if(items.pixels, [](std::uint32_t p) { return p != 0 && p != kNothing; }), 0);
  EXPECT_GT(pixels(items, 0), 100U);
}

}  // namespace scene_renderer_test
}  // namespace occlude::render
