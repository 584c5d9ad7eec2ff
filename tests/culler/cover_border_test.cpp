// SPDX-License-Identifier: MIT
// Borders in the coarse picture: what an edge may touch is touched and little more, and the rest is closed where the border
// encloses it.
#include "cover/cover_border.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>
#include <vector>

#include "occlude/culler/cull_result.h"
#include "sanitized.h"

namespace cover_border_test {

using namespace occlude;
using namespace occlude::culler;

constexpr int kWidth = 48, kHeight = 32;

ConservativeViewport picture(int height = kHeight) {
  Camera camera;
  camera.aspect = 1.5;
  return {FrameView(camera, 100), {kWidth, height, 16}, 0};
}

/// The closed pixels of all tiles, row after row.
std::vector<std::uint64_t> closed_by(CoverBorder& border) {
  std::vector<std::uint64_t> closed(kWidth / kTile * kHeight / kTile);
  border.find_closed(closed);
  return closed;
}

bool has(const std::vector<std::uint64_t>& tiles, int x, int y) {
  const auto tile = static_cast<std::size_t>(y / kTile * (kWidth / kTile) + x / kTile);
  return (tiles[tile] >> (y % kTile * kTile + x % kTile) & 1U) != 0;
}

/// The Chebyshev distance of the segment from the pixel: 0 where they meet.
double distance(const PixelPosition& a, const PixelPosition& b, int x, int y) {
  // The distance is convex along the segment, so ternary search finds the least one.
  const auto at = [&](double t) {
    const double px = a.x + t * (b.x - a.x), py = a.y + t * (b.y - a.y);
    return std::max({x - px, px - (x + 1), y - py, py - (y + 1), 0.0});
  };
  double low = 0, high = 1;
  for (int i = 0; i < 100; ++i) {
    const double third = (high - low) / 3;
    (at(low + third) <= at(high - third) ? high : low) = at(low + third) <= at(high - third) ? high - third : low + third;
  }
  return std::min({at(low), at(0), at(1)});
}

class Edges {
 public:
  /// A position in the picture, at a corner of a pixel, in line with the last one along an axis, or far away.
  PixelPosition place() {
    const double size = std::vector<double>{1, 1, 1, 4, 1e3, 1e7}[random_() % 6];
    PixelPosition place{uniform(-0.2, 1.2) * kWidth, uniform(-0.2, 1.2) * kHeight};
    if (random_() % 4 == 0) place = {std::round(place.x), std::round(place.y)};
    place = {(place.x - 24) * size + 24, (place.y - 16) * size + 16};
    if (random_() % 4 == 0) place.x = last_.x;
    if (random_() % 4 == 0) place.y = last_.y + (random_() % 2 == 0 ? 0 : uniform(-1e-7, 1e-7));
    return last_ = place;
  }
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random_); }

 private:
  std::mt19937 random_{7};
  PixelPosition last_{};
};

/// All pixels are closed except those that an edge touches which is drawn twice and so turns nothing. So the pixels that
/// stay open are the touched ones.
TEST(CoverBorder, TouchesWhatComesNearAndLittleMore) {
  Edges edges;
  CoverBorder border;
  const ConservativeViewport picture = cover_border_test::picture();
  const PixelRectangle all{0, 0, kWidth / kTile, kHeight / kTile};
  std::size_t near = 0;
  for (int i = 0; i < 400; ++i) {
    const BoundedPosition a{edges.place(), i % 3 == 0 ? 0.25 : 1e-9}, b{edges.place(), 1e-9};
    border.begin(picture, all);
    // Everything is above an edge below the picture.
    border.draw({{-1e3, -9}, 1e-9}, {{1e3, -9}, 1e-9});
    border.draw(a, b);
    border.draw(b, a);
    const auto closed = closed_by(border);
    const double error = std::max(a.error, b.error);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const double away = distance(a.place, b.place, x, y);
        const bool is_touched = !has(closed, x, y);
        if (away <= error) {
          EXPECT_TRUE(is_touched) << i << ": " << x << " " << y;
        }
        if (away > error * 2 + 2e-4) {
          EXPECT_FALSE(is_touched) << i << ": " << x << " " << y << " is " << away << " away";
        }
        near += away <= error;
      }
    }
  }
  EXPECT_GT(near, 2000U);
}

TEST(CoverBorder, ClosesWhatItEnclosesAnOddNumberOfTimes) {
  Edges edges;
  CoverBorder border;
  const ConservativeViewport picture = cover_border_test::picture();
  std::size_t closed_pixels = 0;
  for (int i = 0; i < unless_sanitized(300, 60); ++i) {
    std::vector<BoundedPosition> loop(3 + static_cast<std::size_t>(i % 5));
    for (BoundedPosition& corner : loop) corner = {edges.place(), 1e-9};
    const PixelRectangle tiles = i % 2 == 0 ? PixelRectangle{0, 0, 6, 4} : PixelRectangle{1, 1, 5, 3};
    border.begin(picture, tiles);
    for (std::size_t k = 0; k < loop.size(); ++k) border.draw(loop[k], loop[(k + 1) % loop.size()]);
    const auto closed = closed_by(border);
    for (int y = tiles.y0 * kTile; y < tiles.y1 * kTile; ++y) {
      for (int x = tiles.x0 * kTile; x < tiles.x1 * kTile; ++x) {
        bool is_enclosed = false;
        bool is_touched = false;
        for (std::size_t k = 0; k < loop.size(); ++k) {
          const PixelPosition &a = loop[k].place, &b = loop[(k + 1) % loop.size()].place;
          is_touched = is_touched || distance(a, b, x, y) < 1e-2;
          const double side = (b.x - a.x) * (y + 0.5 - a.y) - (b.y - a.y) * (x + 0.5 - a.x);
          const bool is_above =
              (a.x <= x + 0.5 && b.x > x + 0.5 && side > 0) || (b.x <= x + 0.5 && a.x > x + 0.5 && side < 0);
          is_enclosed = is_enclosed != is_above;
        }
        if (is_touched) continue;
        EXPECT_EQ(has(closed, x, y), is_enclosed) << i << ": " << x << " " << y;
        closed_pixels += is_enclosed;
      }
    }
  }
  EXPECT_GT(closed_pixels, unless_sanitized(5000U, 1000U));
}

/// An edge may come from millions of pixels below, and end just beyond the middle of a column. The column turns there and
/// not some pixels above, where nothing is touched.
TEST(CoverBorder, SteepEdgesTurnWhereTheyEnd) {
  std::mt19937 random(11);
  const auto uniform = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  CoverBorder border;
  const ConservativeViewport picture = cover_border_test::picture();
  const PixelRectangle all{0, 0, kWidth / kTile, kHeight / kTile};
  std::size_t closed_pixels = 0;
  for (int i = 0; i < 2000; ++i) {
    const double rise = std::exp2(uniform(10, 45)), beyond = uniform(1, 4) / rise;
    const int column = static_cast<int>(random() % 40);
    const double error = 1e-9 + 0x1p-47 * rise;  // no corner that far away has less
    const BoundedPosition a{{column - uniform(0, 8), -rise}, error}, b{{column + 0.5 + beyond, uniform(2, 20)}, error},
        c{{b.place.x - uniform(-20, 20), b.place.y + uniform(0, 1e-3)}, error};
    border.begin(picture, all);
    border.draw(a, b);
    border.draw(b, c);
    border.draw(c, a);
    const auto closed = closed_by(border);
    for (int y = static_cast<int>(b.place.y) + 2; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) EXPECT_FALSE(has(closed, x, y)) << i << ": " << x << " " << y;
    }
    for (const std::uint64_t tile : closed) closed_pixels += static_cast<std::size_t>(std::popcount(tile));
  }
  EXPECT_GT(closed_pixels, 10000U);
}

/// In the highest picture, floats round a height by more than the error of an edge.
TEST(CoverBorder, TouchesTheRowThatALongEdgeReachesWithItsError) {
  std::mt19937 random(13);
  const auto uniform = [&](double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); };
  CoverBorder border;
  const ConservativeViewport picture = cover_border_test::picture(kMostCoverSide);
  constexpr int kTilesUp = kMostCoverSide / kTile;
  std::vector<std::uint64_t> closed(std::size_t{kWidth / kTile} * kTilesUp);
  for (int i = 0; i < 2000; ++i) {
    const int column = static_cast<int>(random() % kWidth), row = 2000 + static_cast<int>(random() % 2000);
    const double error = std::exp2(uniform(-22, -12));
    const BoundedPosition low{{uniform(0, kWidth), uniform(0, 1000)}, error},
        high{{column + 0.5, row - uniform(0, 0.99) * error}, error};
    border.begin(picture, {0, 0, kWidth / kTile, kTilesUp});
    border.draw({{-1e3, -9}, 1e-9}, {{1e3, -9}, 1e-9});
    border.draw(low, high);
    border.draw(high, low);
    border.find_closed(closed);
    EXPECT_FALSE(has(closed, column, row)) << i;
    EXPECT_TRUE(has(closed, column, row + 1)) << i;
  }
}

/// What was drawn before is gone.
TEST(CoverBorder, BeginsEmpty) {
  CoverBorder border;
  const ConservativeViewport picture = cover_border_test::picture();
  const PixelRectangle all{0, 0, kWidth / kTile, kHeight / kTile};
  border.begin(picture, all);
  border.draw({{-1e3, -9}, 1e-9}, {{1e3, 60}, 1e-9});
  closed_by(border);
  border.begin(picture, all);
  for (const std::uint64_t closed : closed_by(border)) EXPECT_EQ(closed, 0U);
}

/// A picture that is wider than the one before and has as many tiles. What is written beyond the row of a narrower one, the
/// memory's own checks find.
TEST(CoverBorder, BeginsWiderWithAsManyTiles) {
  constexpr int kTiles = 1 << 16;
  const auto begun = [](CoverBorder& border, int across) {
    const int up = kTiles / across;
    border.begin({FrameView(Camera{}, 100), {across * kTile, up * kTile, 0}, 0}, {0, 0, across, up});
    border.draw({{-9, -9}, 1e-9}, {{3.5, 99}, 1e-9});
    border.draw({{3.5, 99}, 1e-9}, {{9e3, -9}, 1e-9});
    border.draw({{9e3, -9}, 1e-9}, {{-9, -9}, 1e-9});
    std::vector<std::uint64_t> closed(kTiles);
    border.find_closed(closed);
    return closed;
  };
  CoverBorder border, wide;
  begun(border, 2);
  EXPECT_EQ(begun(border, kTiles / 2), begun(wide, kTiles / 2));
}

}  // namespace cover_border_test
