// SPDX-License-Identifier: MIT
// Compiled once for each instruction set. The best one is chosen at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cover/layer_erosion.cpp"
#include <hwy/foreach_target.h>
// foreach_target.h must come first.
#include <hwy/highway.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "cover/cover_tile.h"
#include "cover/layer_erosion.h"

#ifndef OCCLUDE_LAYER_EROSION_ONCE
#define OCCLUDE_LAYER_EROSION_ONCE
namespace occlude::culler {
namespace {

constexpr std::size_t kMostReach = LayerErosion::Reach::kMost;

/// A tile is left as it is if none of its pixels would come nearer by more than this share. The same sheet is found a little
/// nearer in one layer than in the other, so that without this limit nearly all that is closed in both would be taken over.
constexpr float kWorthShare = 1.0F / 16;

/// The tiles in which so many pixels beside a tile may be.
std::size_t tiles_of(int pixels) { return static_cast<std::size_t>(pixels + kTile - 1) / kTile; }

/// The numbers of two layers, tile after tile, and room.
struct Erosion {
  std::size_t tiles_across, tiles_up;
  const LayerErosion::Reach *across, *up;
  float never;
  const float *from, *nearest_from;  ///< of the nearer layer
  float *to, *nearest_to, *farthest_to;
  std::uint8_t* wanted;  ///< of each tile, whether it may come nearer
  std::uint8_t* asked;   ///< of each tile of the nearer layer, whether a tile needs its pixels across
  float* strip;          ///< a row of tiles of the nearer layer, pixel row by pixel row, with open pixels before and after
  float* rows;           ///< for each pixel of it, row by row, the least of those that the rays of such a column pass

  [[nodiscard]] std::size_t width() const { return tiles_across * kTile; }
  [[nodiscard]] std::size_t stride() const { return width() + 2 * kMostReach; }
};

}  // namespace
}  // namespace occlude::culler
#endif

HWY_BEFORE_NAMESPACE();
namespace occlude::culler {
namespace {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

using RowTag = hn::CappedTag<float, kTile>;
using Row = hn::Vec<RowTag>;

constexpr RowTag kRow;

/// The least at a place and at all places from `low` to `high` beside it, `step` numbers apart.
HWY_INLINE Row least_of(const float* at, const LayerErosion::Reach& reach, std::ptrdiff_t step) {
  Row least = hn::LoadU(kRow, at);
  for (std::ptrdiff_t k = reach.low; k <= reach.high; ++k) least = hn::Min(least, hn::LoadU(kRow, at + k * step));
  return least;
}

/// Unpacks a tile into the strip.
HWY_INLINE void unpack(const Erosion& e, std::size_t tile_row, std::size_t x) {
  const Row open = hn::Set(kRow, kOpen), never = hn::Set(kRow, e.never);
  const float* const tile = e.from + (tile_row * e.tiles_across + x) * kTilePixels;
  float* const column = e.strip + kMostReach + x * kTile;
  for (std::size_t i = 0; i < kTilePixels; i += hn::Lanes(kRow)) {
    const Row nearness = hn::LoadU(kRow, tile + i);
    hn::StoreU(hn::IfThenElse(hn::Gt(nearness, never), nearness, open), kRow, column + i / kTile * e.stride() + i % kTile);
  }
}

/// For each pixel of the tiles of a row that are asked, finds the least across.
HWY_INLINE void find_least_across(const Erosion& e, std::size_t tile_row) {
  const std::uint8_t* const asked = e.asked + tile_row * e.tiles_across;
  std::size_t unpacked = 0;
  for (std::size_t x = 0; x < e.tiles_across; ++x) {
    if (asked[x] == 0) continue;
    const LayerErosion::Reach& reach = e.across[x];
    const std::size_t left = tiles_of(-reach.low), end = std::min(x + 1 + tiles_of(reach.high), e.tiles_across);
    for (unpacked = std::max(unpacked, x - std::min(x, left)); unpacked < end; ++unpacked) unpack(e, tile_row, unpacked);
    for (std::size_t i = 0; i < kTilePixels; i += hn::Lanes(kRow)) {
      const std::size_t row = i / kTile, column = x * kTile + i % kTile;
      const Row least = least_of(e.strip + row * e.stride() + kMostReach + column, reach, 1);
      hn::StoreU(least, kRow, e.rows + (tile_row * kTile + row) * e.width() + column);
    }
  }
}

/// Brings the pixels of a tile nearer, in rows from `first` to before `end`.
HWY_INLINE void bring_nearer(const Erosion& e, std::size_t tile_row, std::size_t x, std::size_t first, std::size_t end) {
  const std::size_t number = tile_row * e.tiles_across + x;
  float* const tile = e.to + number * kTilePixels;
  const auto step = static_cast<std::ptrdiff_t>(e.width());
  Row farthest = hn::Set(kRow, hwy::HighestValue<float>()), nearest = hn::Set(kRow, kOpen);
  for (std::size_t i = 0; i < kTilePixels; i += hn::Lanes(kRow)) {
    const std::size_t row = tile_row * kTile + i / kTile;
    Row nearness = hn::LoadU(kRow, tile + i);
    if (row >= first && row < end) {
      nearness = hn::Max(nearness, least_of(e.rows + row * e.width() + x * kTile + i % kTile, e.up[tile_row], step));
      hn::StoreU(nearness, kRow, tile + i);
    }
    farthest = hn::Min(farthest, nearness);
    nearest = hn::Max(nearest, nearness);
  }
  e.farthest_to[number] = hn::GetLane(hn::MinOfLanes(kRow, farthest));
  e.nearest_to[number] = hn::GetLane(hn::MaxOfLanes(kRow, nearest));
}

/// Finds the tiles that may come nearer, and those of the nearer layer that are asked for them.
HWY_INLINE void find_wanted(const Erosion& e) {
  std::fill(e.asked, e.asked + e.tiles_across * e.tiles_up, std::uint8_t{0});
  for (std::size_t y = 0; y < e.tiles_up; ++y) {
    const LayerErosion::Reach& up = e.up[y];
    const std::size_t below = std::min(y, tiles_of(-up.low)), above = std::min(e.tiles_up - 1 - y, tiles_of(up.high));
    for (std::size_t x = 0; x < e.tiles_across; ++x) {
      const std::size_t tile = y * e.tiles_across + x;
      const float nearest = e.nearest_from[tile];
      const bool is_wanted = nearest > e.never && nearest > e.farthest_to[tile] * (1 + kWorthShare) &&
                             !e.across[x].is_too_far() && !up.is_too_far();
      e.wanted[tile] = is_wanted ? 1 : 0;
      if (!is_wanted) continue;
      for (std::size_t of = y - below; of <= y + above; ++of) e.asked[of * e.tiles_across + x] = 1;
    }
  }
}

void erode(const Erosion& e) {
  find_wanted(e);
  for (std::size_t y = 0; y < e.tiles_up; ++y) find_least_across(e, y);
  const auto height = static_cast<std::ptrdiff_t>(e.tiles_up * kTile);
  for (std::size_t y = 0; y < e.tiles_up; ++y) {
    // Rays of other rows pass pixels beyond the picture.
    const std::ptrdiff_t first = -e.up[y].low, end = height - e.up[y].high;
    if (first >= end) continue;
    for (std::size_t x = 0; x < e.tiles_across; ++x) {
      if (e.wanted[y * e.tiles_across + x] == 0) continue;
      bring_nearer(e, y, x, static_cast<std::size_t>(first), static_cast<std::size_t>(end));
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace occlude::culler
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace occlude::culler {
namespace {
HWY_EXPORT(erode);
}  // namespace

void LayerErosion::begin(const ConservativeViewport& picture, const FocusLayers& layers) {
  tiles_across_ = static_cast<std::size_t>(picture.width() / kTile);
  tiles_up_ = static_cast<std::size_t>(picture.height() / kTile);
  for (std::size_t layer = 0; layer + 1 < layers.count; ++layer) {
    const double focus = layers.focus[layer], nearer = layers.focus[layer + 1];
    // The move is the greatest, or least, of linear functions of the position. So within a tile it is greatest, or least, at
    // a side.
    const auto find = [&](std::vector<Reach>& reaches, std::size_t tiles, const auto& moves_at) {
      reaches.clear();
      EyeMoves::Range left = moves_at(0);
      for (std::size_t i = 0; i < tiles; ++i) {
        const EyeMoves::Range right = moves_at(static_cast<double>((i + 1) * kTile));
        const double low = std::floor(std::min(left.low, right.low)), high = std::ceil(std::max(left.high, right.high));
        const bool is_near = low >= -Reach::kMost && high <= Reach::kMost;
        reaches.push_back(is_near ? Reach{static_cast<int>(low), static_cast<int>(high)} : Reach{});
        left = right;
      }
    };
    find(across_[layer], tiles_across_, [&](double x) { return picture.ray_moves_across(x, focus, nearer); });
    find(up_[layer], tiles_up_, [&](double y) { return picture.ray_moves_up(y, focus, nearer); });
  }
  strip_.assign(kTile * (tiles_across_ * kTile + 2 * kMostReach), kOpen);
  rows_.resize(tiles_across_ * tiles_up_ * kTilePixels);
  wanted_.resize(2 * tiles_across_ * tiles_up_);
}

void LayerErosion::erode(std::size_t layer, float never, const Layers& layers) {
  const std::size_t tiles = tiles_across_ * tiles_up_;
  HWY_DYNAMIC_DISPATCH(erode)
  ({tiles_across_, tiles_up_, across_[layer].data(), up_[layer].data(), never, layers.nearness + tiles * kTilePixels,
    layers.nearest + tiles, layers.nearness, layers.nearest, layers.farthest, wanted_.data(), wanted_.data() + tiles,
    strip_.data(), rows_.data()});
}

PixelRectangle LayerErosion::through(std::size_t layer, const PixelRectangle& pixels) const {
  const auto find = [](const std::vector<Reach>& reaches, int first, int end) {
    Reach all{first, end};
    for (int tile = first / kTile; tile * kTile < end; ++tile) {
      const Reach& reach = reaches[static_cast<std::size_t>(tile)];
      all.low = std::min(all.low, std::max(first, tile * kTile) + reach.low);
      all.high = std::max(all.high, std::min(end, (tile + 1) * kTile) + reach.high);
    }
    return all;
  };
  const Reach across = find(across_[layer], pixels.x0, pixels.x1), up = find(up_[layer], pixels.y0, pixels.y1);
  return {across.low, up.low, across.high, up.high};
}

}  // namespace occlude::culler
#endif
