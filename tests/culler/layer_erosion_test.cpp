// SPDX-License-Identifier: MIT
// What a layer takes over from the next nearer one, held against a search of all pixels that rays pass.
#include "cover/layer_erosion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iostream>
#include <limits>
#include <random>
#include <vector>

#include "camera/frame_view.h"
#include "cover/conservative_viewport.h"
#include "cover/cover_tile.h"
#include "scenes.h"
#include "seed.h"

namespace occlude::culler {
namespace layer_erosion_test {

constexpr int kWidth = 96, kHeight = 64;
constexpr std::size_t kPixels = std::size_t{kWidth} * kHeight, kTiles = kPixels / kTilePixels;
constexpr float kOpen = -std::numeric_limits<float>::infinity();

std::size_t tile_at(int x, int y) { return static_cast<std::size_t>(y / kTile * (kWidth / kTile) + x / kTile); }
std::size_t pixel_of(int x, int y) {
  return tile_at(x, y) * kTilePixels + static_cast<std::size_t>(y % kTile * kTile + x % kTile);
}

/// Two layers, as a picture of several eyes keeps them.
struct TwoLayers {
  std::vector<float> nearness = std::vector<float>(2 * kPixels), nearest = std::vector<float>(2 * kTiles),
                     farthest = std::vector<float>(2 * kTiles);
  std::vector<std::uint8_t> has_changed = std::vector<std::uint8_t>(2 * kTiles, 0);

  [[nodiscard]] LayerErosion::Layers layers() {
    return {nearness.data(), nearest.data(), farthest.data(), has_changed.data()};
  }

  void find_extremes() {
    for (std::size_t tile = 0; tile < 2 * kTiles; ++tile) {
      const auto first = nearness.begin() + static_cast<std::ptrdiff_t>(tile * kTilePixels), end = first + kTilePixels;
      nearest[tile] = *std::max_element(first, end);
      farthest[tile] = *std::min_element(first, end);
    }
  }
};

/// Closes a rectangle of a layer, and notes that.
void close_some(std::mt19937& random, TwoLayers& layers, std::size_t layer, int most_more, float nearness) {
  const auto some = [&](int count) { return static_cast<int>(random() % static_cast<unsigned>(count)); };
  const int x0 = some(kWidth), y0 = some(kHeight);
  const int x1 = std::min(x0 + 8 + some(most_more), kWidth), y1 = std::min(y0 + 8 + some(most_more), kHeight);
  for (int y = y0; y < y1; ++y) {
    for (int x = x0; x < x1; ++x) {
      float& pixel = layers.nearness[layer * kPixels + pixel_of(x, y)];
      pixel = std::max(pixel, nearness);
      layers.has_changed[layer * kTiles + tile_at(x, y)] = 1;
    }
  }
}

/// Large rectangles of different nearnesses, so that much is closed and there are borders of all kinds.
TwoLayers some_layers(std::mt19937& random, float never) {
  TwoLayers layers;
  std::fill(layers.nearness.begin(), layers.nearness.begin() + kPixels, kOpen);
  std::fill(layers.nearness.begin() + kPixels, layers.nearness.end(), never);
  for (int i = 0; i < 24; ++i) {
    const std::size_t layer = random() % 3 == 0 ? 0 : 1;
    close_some(random, layers, layer, 64, never * static_cast<float>(uniform(random, 0.5, 4)));
  }
  layers.find_extremes();
  return layers;
}

TEST(LayerErosion, TakesOverWhatIsClosedInAllPixelsThatRaysPass) {
  const std::uint32_t seed = seed_of(1);
  std::cout << "seed " << seed << "\n";
  std::mt19937 random(seed);
  std::size_t taken = 0, left = 0, changed = 0;
  for (int i = 0; i < 400; ++i) {
    Camera camera;
    camera.fov_y_deg = uniform(random, 30, 100);
    camera.near_plane = 0.5;
    const double size = uniform(random, 0.01, 1);
    camera.eyes = random() % 2 == 0 ? EyeRegion::ball(size) : EyeRegion::box({size, 0, 0}, {0, 0.1, 0}, {0, 0, 0.2 * size});
    const ConservativeViewport picture(FrameView(camera, 1000), {kWidth, kHeight, 8}, 0);
    FocusLayers in_focus;
    in_focus.count = 2;
    in_focus.focus[0] = static_cast<float>(uniform(random, 0, 0.5) * picture.most_focus());
    in_focus.focus[1] = static_cast<float>(picture.most_focus());
    LayerErosion erosion;
    erosion.begin(picture, in_focus);
    const float never = in_focus.start(1);
    const TwoLayers before = some_layers(random, never);
    TwoLayers after = before;
    std::fill(after.has_changed.begin(), after.has_changed.begin() + kTiles, std::uint8_t{0});
    erosion.erode(0, never, after.layers());
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const PixelRectangle r = erosion.through(0, {x, y, x + 1, y + 1});
        float least = std::numeric_limits<float>::infinity();
        for (int v = r.y0; v < r.y1; ++v) {
          for (int u = r.x0; u < r.x1; ++u) {
            const bool is_inside = u >= 0 && v >= 0 && u < kWidth && v < kHeight;
            least = std::min(least, is_inside ? before.nearness[kPixels + pixel_of(u, v)] : kOpen);
          }
        }
        if (!(least > never)) least = kOpen;
        const float old = before.nearness[pixel_of(x, y)], now = after.nearness[pixel_of(x, y)];
        if (now == old) {
          // Only little may be left: else the whole tile would have come nearer.
          if (least > old * 1.0625F) ++left;
          continue;
        }
        ++taken;
        ASSERT_EQ(after.has_changed[tile_at(x, y)], 1);
        ASSERT_EQ(now, std::max(old, least)) << "picture " << i << ", pixel " << x << " " << y;
      }
    }
    TwoLayers expected = after;
    expected.find_extremes();
    ASSERT_EQ(after.nearest, expected.nearest);
    ASSERT_EQ(after.farthest, expected.farthest);
    ASSERT_TRUE(std::equal(after.nearness.begin() + kPixels, after.nearness.end(), before.nearness.begin() + kPixels));
    ASSERT_TRUE(std::all_of(after.has_changed.begin() + kTiles, after.has_changed.end(), [](auto b) { return b == 0; }));

    // What has changed since then is as good as all.
    for (int k = 0; k < 3; ++k) close_some(random, after, 1, 16, never * static_cast<float>(uniform(random, 1, 4)));
    after.find_extremes();
    TwoLayers whole = after;
    std::ranges::fill(whole.has_changed, std::uint8_t{1});
    const std::vector<float> once = after.nearness;
    erosion.erode(0, never, after.layers());
    erosion.erode(0, never, whole.layers());
    ASSERT_EQ(after.nearness, whole.nearness) << "picture " << i;
    if (after.nearness != once) ++changed;
  }
  EXPECT_GT(changed, 100U);
  EXPECT_GT(taken, 100000U);
  EXPECT_EQ(left, 0U);
}

}  // namespace layer_erosion_test
}  // namespace occlude::culler
