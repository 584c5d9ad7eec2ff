// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "occlude/render/frame_painter.h"
#include "occlude/render/offscreen_context.h"
#include "occlude/render/plate_renderer.h"

namespace occlude::render {
namespace plate_test {

using culler::Camera;
using culler::PolygonRange;
using culler::PolygonSoup;
using culler::SoupView;
using glm::dvec3;

constexpr int kWidth = 160, kHeight = 90;
constexpr std::span<const PlateLayer> kNoLayers;

double lightness(const Rgba& pixel) { return 0.2126 * pixel.r + 0.7152 * pixel.g + 0.0722 * pixel.b; }

class PlateTest : public testing::Test {
 protected:
  [[nodiscard]] static Camera camera_at(const dvec3& eye, const dvec3& target) {
    Camera camera;
    camera.eye = eye;
    camera.target = target;
    return camera;
  }
  static void add_quad(PolygonSoup& soup, const dvec3& corner, const dvec3& u, const dvec3& v) {
    const std::array<std::uint32_t, 4> loop = {soup.add_vertex(corner), soup.add_vertex(corner + u),
                                               soup.add_vertex(corner + u + v), soup.add_vertex(corner + v)};
    soup.add_polygon(loop);
  }
  /// A wall before a camera that looks along +x.
  [[nodiscard]] static PolygonSoup wall() {
    PolygonSoup soup;
    add_quad(soup, {10, -100, -100}, {0, 200, 0}, {0, 0, 200});
    return soup;
  }
  [[nodiscard]] static Image draw(SoupView soup, const Camera& camera, std::span<const PlateLayer> layers,
                                  std::span<const Line> lines = {}, std::span<const LegendEntry> legend = {}) {
    SceneRenderer renderer(soup, kWidth, kHeight);
    return PlateRenderer(soup, renderer).draw(camera, layers, {.lines = lines, .legend = legend});
  }
  [[nodiscard]] static Image draw(SoupView soup, const Camera& camera, Style style) {
    const PolygonRange all = soup.all();
    const PlateLayer layer{std::span(&all, 1), style};
    return draw(soup, camera, std::span(&layer, 1));
  }

  std::unique_ptr<OffscreenContext> context_ = make_offscreen_context();
};

/// Seen without colour, every two styles differ by a tenth of the range in lightness, or by their patterns.
TEST_F(PlateTest, StylesDifferWithoutColour) {
  struct Seen {
    double mean = 0, spread = 0;
  };
  std::vector<Seen> seen;
  for (const Style style : {Style::drawn, Style::culled, Style::out_of_view, Style::occluder, Style::missed}) {
    const Image image = draw(wall(), camera_at({0, 0, 0}, {1, 0, 0}), style);
    Seen all;
    for (const Rgba& pixel : image.pixels) all.mean += lightness(pixel);
    all.mean /= static_cast<double>(image.pixels.size());
    for (const Rgba& pixel : image.pixels) all.spread += std::fabs(lightness(pixel) - all.mean);
    all.spread /= static_cast<double>(image.pixels.size());
    seen.push_back(all);
  }
  // Both hatched styles differ in the direction of their stripes, which the next test sees.
  for (std::size_t i = 0; i < seen.size(); ++i) {
    for (std::size_t j = i + 1; j < seen.size(); ++j) {
      if (i == 1 && j == 4) continue;
      EXPECT_TRUE(std::fabs(seen[i].mean - seen[j].mean) > 25 || std::fabs(seen[i].spread - seen[j].spread) > 12) << i << j;
    }
  }
}

TEST_F(PlateTest, CulledAndMissedAreHatchedInOppositeDirections) {
  const auto differs = [&](Style style, int step) {
    const Image image = draw(wall(), camera_at({0, 0, 0}, {1, 0, 0}), style);
    double sum = 0;
    for (int y = 10; y < kHeight - 10; ++y) {
      for (int x = 10; x < kWidth - 10; ++x)
        sum += std::fabs(lightness(image.at(x, y)) - lightness(image.at(x + 1, y + step)));
    }
    return sum;
  };
  EXPECT_GT(differs(Style::culled, 1), 3 * differs(Style::culled, -1));
  EXPECT_GT(differs(Style::missed, -1), 3 * differs(Style::missed, 1));
}

TEST_F(PlateTest, OfPolygonsInSeveralLayersTheFirstCounts) {
  const PolygonSoup soup = wall();
  const PolygonRange all{0, 1};
  const std::array<PlateLayer, 2> layers{PlateLayer{std::span(&all, 1), Style::marked},
                                         PlateLayer{std::span(&all, 1), Style::plain}};
  EXPECT_EQ(draw(soup, camera_at({0, 0, 0}, {1, 0, 0}), layers).pixels,
            draw(soup, camera_at({0, 0, 0}, {1, 0, 0}), Style::marked).pixels);
}

/// Two triangles of a wall, with corners of their own, look like one quadrilateral.
TEST_F(PlateTest, AWallHasOneColour) {
  PolygonSoup parts;
  for (const bool is_upper : {false, true}) {
    const std::array<std::uint32_t, 3> loop = {parts.add_vertex({10, -100, -100}),
                                               parts.add_vertex(is_upper ? dvec3(10, 100, 100) : dvec3(10, 100, -100)),
                                               parts.add_vertex(is_upper ? dvec3(10, -100, 100) : dvec3(10, 100, 100))};
    parts.add_polygon(loop);
  }
  const Camera camera = camera_at({0, 0, 0}, {1, 0, 0});
  EXPECT_EQ(draw(parts, camera, Style::plain).pixels, draw(wall(), camera, Style::plain).pixels);
}

TEST_F(PlateTest, ABendIsAnEdgeBetweenTwoColours) {
  PolygonSoup soup;
  add_quad(soup, {10, 0, -100}, {0, 100, 0}, {0, 0, 200});
  add_quad(soup, {10, 0, -100}, {100, -100, 0}, {0, 0, 200});
  const Image image = draw(soup, camera_at({0, 0, 0}, {1, 0, 0}), Style::plain);
  const auto at = [&](int x) { return lightness(image.at(x, kHeight / 2)); };
  EXPECT_LT(std::min(at(kWidth / 2 - 1), at(kWidth / 2)), std::min(at(kWidth / 2 - 8), at(kWidth / 2 + 8)) - 8);
}

/// A roof over a floor: the sun stands in the south-west, so the shadow lies to the north-east of it.
TEST_F(PlateTest, TheSunCastsShadows) {
  PolygonSoup soup;
  add_quad(soup, {-20, -20, 0}, {40, 0, 0}, {0, 40, 0});
  add_quad(soup, {-3, -3, 6}, {6, 0, 0}, {0, 6, 0});
  Camera camera = camera_at({0, 0, 5.5}, {0, 0, 0});  // below the roof
  camera.up = {0, 1, 0};
  camera.fov_y_deg = 110;
  const Image image = draw(soup, camera, Style::plain);
  const auto at = [&](double x, double y) {  // on the floor
    const double scale = kHeight / 2.0 / (5.5 * std::tan(0.5 * 110 * 3.14159265 / 180));
    return lightness(image.at(static_cast<int>(kWidth / 2.0 + scale * x), static_cast<int>(kHeight / 2.0 - scale * y)));
  };
  // The shadow of the roof's middle falls on 6 * (0.57, 0.42) / 0.71.
  EXPECT_LT(at(4.8, 3.5), 0.8 * at(-5, -4));
  EXPECT_NEAR(at(-5, 4), at(-5, -4), 4);
}

TEST_F(PlateTest, CornersAreDarker) {
  PolygonSoup soup;  // a floor and a wall, both turned from the sun
  add_quad(soup, {0, -50, 0}, {20, 0, 0}, {0, 100, 0});
  add_quad(soup, {20, -50, 0}, {0, 100, 0}, {0, 0, 20});
  add_quad(soup, {-30, -80, 30}, {100, 0, 0}, {0, 160, 0});  // a ceiling keeps the sun out
  constexpr int kWide = 640, kHigh = 360;
  SceneRenderer renderer(soup, kWide, kHigh);
  const PolygonRange all{0, 3};
  const PlateLayer layer{std::span(&all, 1), Style::plain};
  const Image image = PlateRenderer(soup, renderer).draw(camera_at({12, 0, 8}, {20, 0, 0}), std::span(&layer, 1));
  const auto row = [&](int y) {
    double sum = 0;
    for (int x = kWide / 4; x < kWide * 3 / 4; ++x) sum += lightness(image.at(x, y)) / (kWide / 2.0);
    return sum;
  };
  // The corner is in the middle of the picture, with an edge of two rows.
  EXPECT_LT(row(kHigh / 2 + 3), row(kHigh / 2 + 40) - 8);
  EXPECT_LT(row(kHigh / 2 - 4), row(kHigh / 2 - 40) - 8);
}

TEST_F(PlateTest, LinesAreFaintBehindASurface) {
  const std::array<Line, 2> lines = {Line{{8, 100, 0}, {8, -100, 0}, {255, 0, 0, 255}},
                                     Line{{20, 100, 6}, {20, -100, 6}, {255, 0, 0, 255}}};
  const PolygonSoup soup = wall();
  const PolygonRange all{0, 1};
  const PlateLayer layer{std::span(&all, 1), Style::drawn};
  const Camera camera = camera_at({0, 0, 0}, {1, 0, 0});
  const Image without = draw(soup, camera, std::span(&layer, 1)), with = draw(soup, camera, std::span(&layer, 1), lines);
  double strong = 0, faint = 0;
  for (int y = 0; y < kHeight; ++y) {
    const double more = with.at(20, y).r - with.at(20, y).g - (without.at(20, y).r - without.at(20, y).g);
    (y >= kHeight / 2 - 2 ? strong : faint) += more;
  }
  EXPECT_GT(strong, 2 * faint);
  EXPECT_GT(faint, 5);
}

TEST_F(PlateTest, ALineThatComesFromBehindTheEyeIsCutAtTheNearPlane) {
  const Line line{{-20, 0.5, 0}, {40, 0.5, 0}, {255, 0, 0, 255}};
  PolygonSoup soup;
  add_quad(soup, {200, -1, -1}, {0, 2, 0}, {0, 0, 2});
  const Image image = draw(soup, camera_at({0, 0, 0}, {1, 0, 0}), kNoLayers, std::span(&line, 1));
  const auto is_red = [](const Rgba& pixel) { return pixel.r > pixel.b + 100; };
  EXPECT_TRUE(is_red(image.at(2, kHeight / 2)));  // y is to the left
  EXPECT_FALSE(is_red(image.at(kWidth - 3, kHeight / 2)));
}

TEST_F(PlateTest, TheLegendNamesStyles) {
  const std::array<LegendEntry, 2> legend{LegendEntry{Style::culled, "culled"}, LegendEntry{Style::drawn, "drawn"}};
  const PolygonSoup soup = wall();
  const Camera camera = camera_at({0, 0, 0}, {1, 0, 0});
  const Image with = draw(soup, camera, kNoLayers, {}, legend), without = draw(soup, camera, kNoLayers);
  std::size_t different = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      if (with.at(x, y) == without.at(x, y)) continue;
      ++different;
      EXPECT_LT(x, kWidth - 10);
    }
  }
  EXPECT_GT(different, 100U);
}

TEST_F(PlateTest, ALegendThatIsTooWideEndsAtTheEdge) {
  const LegendEntry entry{Style::culled, std::string(500, 'W')};
  EXPECT_EQ(draw(wall(), camera_at({0, 0, 0}, {1, 0, 0}), kNoLayers, {}, std::span(&entry, 1)).pixels.size(),
            std::size_t{kWidth * kHeight});
}

/// From above one looks into a closed room, and finds its floor, through walls that are higher than the eye of the picture,
/// too.
TEST_F(PlateTest, FromOutsideARoomIsCutOpen) {
  for (const double high : {4, 400}) {
    PolygonSoup soup;
    soup.add_box({0, 0, 0}, {10, 10, high});
    soup.add_box({7, 4, 0}, {9, 6, 1.5});
    const culler::Culler culler(soup, {.hierarchy = {.leaf_size = 16}});
    culler::View view;
    Camera camera = camera_at({2, 5, 1}, {8, 5, 1});
    camera.near_plane = 0.01;
    const culler::CullResult& result = culler.cull(camera, {}, view);
    FramePainter painter(culler, kWidth, kHeight);
    const PolygonRange box{6, 1};
    const auto marked_pixels = [&](const PolygonRange& polygon) {
      const Image image = painter.outside(camera, result, polygon);
      return std::ranges::count_if(image.pixels, [](const Rgba& p) { return p.r > p.g + 120 && p.b > p.g + 90; });
    };
    // Of the box in the room at least one side is seen from above: which, depends on the order of the tree.
    std::ptrdiff_t most = 0;
    for (std::uint32_t p = 0; p < culler.hierarchy().soup().size(); ++p) {
      if (culler.hierarchy().original(p) >= box.first) most = std::max(most, marked_pixels({p, 1}));
    }
    EXPECT_GT(most, 50) << high;
  }
}

}  // namespace plate_test
}  // namespace occlude::render
