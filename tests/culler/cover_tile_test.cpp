// SPDX-License-Identifier: MIT
// Pixels of tiles, several at a time, as one by one; on every instruction set.
#include "cover/cover_tile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <random>
#include <span>
#include <vector>

#include "base/rounded_float.h"
#include "only_target.h"

namespace cover_tile_test {

using namespace occlude;
using namespace occlude::culler;

constexpr std::uint32_t kSeed = 29;
constexpr int kAcross = 11, kUp = 3;

class CoverTile : public testing::TestWithParam<std::int64_t> {
 protected:
  CoverTile() : nearness_(kAcross * kUp * kTilePixels), farthest_(kAcross * kUp + kTile, -1) {
    for (std::size_t tile = 0; tile < kAcross * kUp; ++tile) {
      const int kind = pick(0, 3);  // all near, a few far, all far, any
      float* const pixels = &nearness_[tile * kTilePixels];
      for (std::size_t i = 0; i < kTilePixels; ++i) {
        pixels[i] = static_cast<float>(kind == 0 ? 9 : kind == 1 ? (pick(0, 40) == 0 ? 1 : 9) : kind == 2 ? 1 : pick(0, 9));
        if (pick(0, 60) == 0 && kind != 0) pixels[i] = -std::numeric_limits<float>::infinity();
      }
      farthest_[tile] = *std::min_element(pixels, pixels + kTilePixels);
    }
  }

  int pick(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }
  [[nodiscard]] TilePicture picture() const { return {nearness_.data(), farthest_.data(), kAcross, kUp}; }
  /// How many pixels of the rectangle are at most `most`, one by one.
  [[nodiscard]] int count(const PixelRectangle& r, float most) const {
    int found = 0;
    for (int y = r.y0; y < r.y1; ++y) {
      for (int x = r.x0; x < r.x1; ++x) {
        const int tile = y / kTile * kAcross + x / kTile, pixel = y % kTile * kTile + x % kTile;
        found += nearness_[static_cast<std::size_t>(tile) * kTilePixels + static_cast<std::size_t>(pixel)] <= most ? 1 : 0;
      }
    }
    return found;
  }
  PixelRectangle rectangle() {
    const int x0 = pick(0, kAcross * kTile - 1), y0 = pick(0, kUp * kTile - 1), most = pick(0, 1) == 0 ? 4 : 100;
    return {x0, y0, std::min(x0 + pick(1, most), kAcross * kTile), std::min(y0 + pick(1, most), kUp * kTile)};
  }

  OnlyTarget only_{GetParam()};
  std::mt19937 random_{kSeed};
  std::vector<float> nearness_, farthest_;
};

INSTANTIATE_TEST_SUITE_P(Targets, CoverTile, testing::ValuesIn(hwy::SupportedAndGeneratedTargets()),
                         [](const auto& target) { return hwy::TargetName(target.param); });

TEST_P(CoverTile, CountsAsOneByOne) {
  int open = 0, closed = 0;
  for (int i = 0; i < 20000; ++i) {
    // One in twenty is empty, and across the side of a tile.
    const PixelRectangle r = i % 20 == 0 ? PixelRectangle{20, 23, 17, 20} : rectangle();
    const auto most = static_cast<float>(pick(0, 9));
    const int expected = count(r, most);
    EXPECT_EQ(open_pixels(picture(), r, most, std::numeric_limits<int>::max()), expected) << "seed " << kSeed;
    const int some = open_pixels(picture(), r, most, 3);
    EXPECT_EQ(std::min(some, 3), std::min(expected, 3)) << "it stops early";
    ++(expected > 0 ? open : closed);
  }
  EXPECT_GT(open, 1000);
  EXPECT_GT(closed, 1000);
}

TEST_P(CoverTile, HidesBoxesInThePictureOnly) {
  std::size_t hidden_boxes = 0;
  for (int i = 0; i < 5000; ++i) {
    ProjectedBoxes boxes;
    unsigned expected = 0;
    for (std::size_t k = 0; k < ProjectedBoxes::kMost; ++k) {
      const PixelRectangle r = rectangle();
      const int beyond = pick(0, 9);
      boxes.x0[k] = beyond == 0 ? -1 : r.x0;
      boxes.y0[k] = beyond == 1 ? -1 : r.y0;
      boxes.x1[k] = beyond == 2 ? kAcross * kTile + 1 : r.x1;
      boxes.y1[k] = beyond == 3 ? kUp * kTile + 1 : r.y1;
      boxes.most[k] = beyond == 4 ? std::numeric_limits<float>::infinity() : static_cast<float>(pick(0, 9));
      if (beyond > 4 && count(r, boxes.most[k]) == 0) expected |= 1U << k;
    }
    boxes.size = ProjectedBoxes::kMost;
    const auto asked = static_cast<kernel::BoxBits>(pick(0, 255));
    EXPECT_EQ(hidden(picture(), boxes, asked), expected & asked) << "seed " << kSeed;
    hidden_boxes += (expected & asked) != 0 ? 1 : 0;
  }
  EXPECT_GT(hidden_boxes, 1000U);
}

TEST_P(CoverTile, BringsNearerWhatIsClosed) {
  constexpr float kFar = std::numeric_limits<float>::infinity();
  std::size_t risen = 0;
  for (int i = 0; i < 1000; ++i) {
    constexpr std::size_t kTiles = 4;
    std::array<float, kTiles * kTilePixels> pixels;
    for (float& pixel : pixels) pixel = static_cast<float>(random_() % 16);
    std::array<float, kTiles> nearness, farthest, expected_farthest;
    std::array<std::uint64_t, kTiles> closed;
    std::array<float, kTiles* kTilePixels> expected = pixels;
    for (std::size_t t = 0; t < kTiles; ++t) {
      const int kind = pick(0, 3);  // all, none, any, few
      const auto any = [&] { return std::uint64_t{random_()} << 32U | random_(); };
      closed[t] = kind == 0 ? ~std::uint64_t{0} : kind == 1 ? 0 : kind == 2 ? any() : any() & any() & any();
      nearness[t] = pick(0, 7) == 0 ? kFar : static_cast<float>(random_() % 16);
      const auto tile = std::span(expected).subspan(t * kTilePixels, kTilePixels);
      farthest[t] = std::ranges::min(tile);
      for (std::size_t k = 0; k < kTilePixels; ++k) {
        if ((closed[t] >> k & 1U) != 0 && nearness[t] < kFar) tile[k] = std::max(tile[k], nearness[t]);
      }
      expected_farthest[t] = std::ranges::min(tile);
      risen += expected_farthest[t] > farthest[t] ? 1 : 0;
    }
    bring_nearer(pixels.data(), farthest, closed.data(), nearness.data());
    EXPECT_EQ(pixels, expected) << "case " << i << ", seed " << kSeed;
    EXPECT_EQ(farthest, expected_farthest) << "case " << i << ", seed " << kSeed;
  }
  EXPECT_GT(risen, 500U);
}

/// The farthest corner or, where it is nearer, the plane at its farthest. Tiles beside the rectangle stay as they are.
TEST_P(CoverTile, LowersTilesToThePlane) {
  constexpr int kTiles = 24, kRows = 3;
  std::uniform_real_distribution<double> number(-2, 2);
  std::size_t of_planes = 0;
  for (int i = 0; i < 2000; ++i) {
    std::array<float, kTiles * kRows + kTile> tiles;
    for (float& tile : tiles)
      tile = random_() % 4 == 0 ? std::numeric_limits<float>::infinity() : static_cast<float>(number(random_));
    std::array<double, kTiles + 1 + kTile> slopes_x{number(random_)};
    std::array<double, kRows + 1> slopes_y{number(random_)};
    for (std::size_t k = 1; k < slopes_x.size(); ++k) slopes_x[k] = slopes_x[k - 1] + 0.05;
    for (std::size_t k = 1; k < slopes_y.size(); ++k) slopes_y[k] = slopes_y[k - 1] + 0.05;
    const PlaneBound plane{number(random_), number(random_), number(random_), 0.9};
    const auto least = static_cast<float>(number(random_));
    const int x0 = pick(0, 5), y0 = pick(0, kRows - 1);
    const PixelRectangle part{x0, y0, x0 + pick(1, 18), y0 + pick(1, kRows - y0)};
    std::array<float, kTiles* kRows + kTile> expected = tiles;
    for (int y = part.y0; y < part.y1; ++y) {
      for (int x = part.x0; x < part.x1; ++x) {
        const auto at = [](const auto& slopes, int k, double slope) {
          const auto low = static_cast<std::size_t>(k);
          return std::min(slope * slopes[low], slope * slopes[low + 1]);
        };
        const double value = plane.constant + at(slopes_y, y, plane.of_y) + at(slopes_x, x, plane.of_x);
        const float bound = std::max(rounded_down(value * plane.scale), least);
        of_planes += bound > least ? 1 : 0;
        float& tile = expected[static_cast<std::size_t>(y * kTiles + x)];
        tile = std::min(tile, bound);
      }
    }
    lower({tiles.data(), kTiles, slopes_x.data(), slopes_y.data()}, part, plane, least);
    EXPECT_EQ(tiles, expected) << "case " << i << ", seed " << kSeed;
  }
  EXPECT_GT(of_planes, 5000U);
}

TEST_P(CoverTile, FindsWhereSomethingIsNearer) {
  std::size_t none = 0;
  for (int i = 0; i < 2000; ++i) {
    std::array<float, 32> farthest, nearness;
    for (float& tile : farthest) tile = static_cast<float>(pick(0, 9));
    for (float& tile : nearness)
      tile = pick(0, 9) < 7 ? static_cast<float>(pick(0, 3)) : std::numeric_limits<float>::infinity();
    const auto count = static_cast<std::size_t>(pick(1, 24));
    const auto row = std::span<const float>(farthest).first(count);
    const auto expect = [&](const TileRange& found, const auto& nearness_at) {
      TileRange expected{static_cast<int>(count), 0};
      for (int k = 0; k < static_cast<int>(count); ++k) {
        const float near = nearness_at(static_cast<std::size_t>(k));
        if (!(near > row[static_cast<std::size_t>(k)]) || near == std::numeric_limits<float>::infinity()) continue;
        expected = {std::min(expected.first, k), k + 1};
      }
      none += expected.end == 0 ? 1 : 0;
      EXPECT_EQ(found.first, expected.first) << "case " << i << ", seed " << kSeed;
      EXPECT_EQ(found.end, expected.end) << "case " << i << ", seed " << kSeed;
    };
    const auto everywhere = static_cast<float>(pick(0, 4));
    expect(nearer(row, everywhere), [&](std::size_t) { return everywhere; });
    expect(nearer(row, nearness.data()), [&](std::size_t k) { return nearness[k]; });
  }
  EXPECT_GT(none, 100U);
  EXPECT_LT(none, 3900U);
}

}  // namespace cover_tile_test
