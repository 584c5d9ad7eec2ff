// SPDX-License-Identifier: MIT
// Compiled once for each instruction set. The best one is chosen at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cover/layer_erosion.cpp"
#include <hwy/foreach_target.h>
// foreach_target.h must come first.
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
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

/// Strips of the least of 1, 2, 4, ... numbers, up to as many as rays of a pixel may pass.
constexpr std::size_t kStrips = std::bit_width(2 * kMostReach + 1);

/// The tiles in which so many pixels beside a tile may be.
std::size_t tiles_of(int pixels) { return static_cast<std::size_t>(pixels + kTile - 1) / kTile; }

/// The numbers of two layers, tile after tile, and room.
struct Erosion {
  std::size_t tiles_across, tiles_up;
  const LayerErosion::Reach *across, *up;
  float never;
  const float *from, *nearest_from;  ///< of the nearer layer
  float *to, *nearest_to, *farthest_to;
  std::uint8_t *changed_from, *changed_to;
  std::uint8_t* wanted;  ///< of each tile, whether it may come nearer
  std::uint8_t* asked;   ///< of each tile of the nearer layer, whether a tile needs its pixels across
  /// kStrips: a row of tiles of the nearer layer, pixel row by pixel row, with open pixels before and after; and for each
  /// place of it the least of the 2, 4, ... from there on.
  float* strip;
  float* rows;  ///< for each pixel of it, row by row, the least of those that the rays of such a column pass

  [[nodiscard]] std::size_t width() const { return tiles_across * kTile; }
  [[nodiscard]] std::size_t stride() const { return width() + 2 * kMostReach; }
  /// Column `x` of a pixel row of a strip.
  [[nodiscard]] float* at(std::size_t which, std::size_t row, std::size_t x) const {
    return strip + (which * kTile + row) * stride() + kMostReach + x;
  }
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

/// The least of the numbers `from`, ..., `to` times `step` beside a place. REQUIRES: from <= to.
HWY_INLINE Row least_of(const float* at, std::ptrdiff_t from, std::ptrdiff_t to, std::ptrdiff_t step) {
  Row least = hn::LoadU(kRow, at + from * step);
  for (std::ptrdiff_t k = from + 1; k <= to; ++k) least = hn::Min(least, hn::LoadU(kRow, at + k * step));
  return least;
}

/// Unpacks a tile into the strip.
HWY_INLINE void unpack(const Erosion& e, std::size_t tile_row, std::size_t x) {
  const Row open = hn::Set(kRow, kOpen), never = hn::Set(kRow, e.never);
  const float* const tile = e.from + (tile_row * e.tiles_across + x) * kTilePixels;
  for (std::size_t i = 0; i < kTilePixels; i += hn::Lanes(kRow)) {
    const Row nearness = hn::LoadU(kRow, tile + i);
    hn::StoreU(hn::IfThenElse(hn::Gt(nearness, never), nearness, open), kRow, e.at(0, i / kTile, x * kTile + i % kTile));
  }
}

/// Makes the other strips of the first one, so that the last has the least of `most` or fewer, but more than half as many:
/// of the columns from `first` to before `end`.
HWY_INLINE void double_strips(const Erosion& e, std::size_t most, std::ptrdiff_t first, std::ptrdiff_t end) {
  for (std::size_t which = 1; std::size_t{1} << which <= most; ++which) {
    const std::ptrdiff_t half = std::ptrdiff_t{1} << (which - 1);
    for (std::size_t row = 0; row < kTile; ++row) {
      const float* const from = e.at(which - 1, row, 0);
      float* const to = e.at(which, row, 0);
      for (std::ptrdiff_t i = first; i <= end - 2 * half; i += static_cast<std::ptrdiff_t>(hn::Lanes(kRow))) {
        hn::StoreU(hn::Min(hn::LoadU(kRow, from + i), hn::LoadU(kRow, from + i + half)), kRow, to + i);
      }
    }
  }
}

/// For each pixel of the tiles of a row that are asked, finds the least across: of two powers of two that overlap.
HWY_INLINE void find_least_across(const Erosion& e, std::size_t tile_row) {
  const std::uint8_t* const asked = e.asked + tile_row * e.tiles_across;
  std::size_t unpacked = 0, most = 0;
  auto first = static_cast<std::ptrdiff_t>(e.width()), last = std::ptrdiff_t{0};
  for (std::size_t x = 0; x < e.tiles_across; ++x) {
    if (asked[x] == 0) continue;
    const LayerErosion::Reach& reach = e.across[x];
    const std::size_t left = tiles_of(-reach.low), end = std::min(x + 1 + tiles_of(reach.high), e.tiles_across);
    for (unpacked = std::max(unpacked, x - std::min(x, left)); unpacked < end; ++unpacked) unpack(e, tile_row, unpacked);
    most = std::max(most, reach.count());
    first = std::min(first, static_cast<std::ptrdiff_t>(x * kTile) + reach.low);
    last = std::max(last, static_cast<std::ptrdiff_t>(x * kTile + kTile - 1) + reach.high);
  }
  if (most == 0) return;
  double_strips(e, most, first, last + 1);
  for (std::size_t x = 0; x < e.tiles_across; ++x) {
    if (asked[x] == 0) continue;
    const LayerErosion::Reach& reach = e.across[x];
    const auto which = static_cast<std::size_t>(std::bit_width(reach.count()) - 1);
    const std::ptrdiff_t second = reach.high + 1 - (std::ptrdiff_t{1} << which);
    for (std::size_t i = 0; i < kTilePixels; i += hn::Lanes(kRow)) {
      const std::size_t row = i / kTile, column = x * kTile + i % kTile;
      const float* const at = e.at(which, row, column);
      const Row least = hn::Min(hn::LoadU(kRow, at + reach.low), hn::LoadU(kRow, at + second));
      hn::StoreU(least, kRow, e.rows + (tile_row * kTile + row) * e.width() + column);
    }
  }
}

/// The least of the pixels that the rays of each pixel of a column of a tile pass, from row `first` to before `end`: what
/// all rows have in common, and what each has below and above that.
HWY_INLINE void find_least_up(const float* column, std::ptrdiff_t step, const LayerErosion::Reach& up, std::ptrdiff_t first,
                              std::ptrdiff_t end, float* least) {
  const auto of_row = [&](std::ptrdiff_t row) { return least + (row - first) * kTile; };
  const std::ptrdiff_t last = end - 1;
  if (last + up.low > first + up.high) {
    for (std::ptrdiff_t row = first; row < end; ++row) {
      hn::StoreU(least_of(column, row + up.low, row + up.high, step), kRow, of_row(row));
    }
    return;
  }
  const Row common = least_of(column, last + up.low, first + up.high, step);
  Row below = common, above = common;
  hn::StoreU(common, kRow, of_row(last));
  for (std::ptrdiff_t row = last - 1; row >= first; --row) {
    below = hn::Min(below, hn::LoadU(kRow, column + (row + up.low) * step));
    hn::StoreU(below, kRow, of_row(row));
  }
  for (std::ptrdiff_t row = first + 1; row < end; ++row) {
    above = hn::Min(above, hn::LoadU(kRow, column + (row + up.high) * step));
    hn::StoreU(hn::Min(above, hn::LoadU(kRow, of_row(row))), kRow, of_row(row));
  }
}

/// Brings the pixels of a tile nearer, in rows from `first` to before `end`, of which it has some.
HWY_INLINE void bring_nearer(const Erosion& e, std::size_t tile_row, std::size_t x, std::ptrdiff_t first,
                             std::ptrdiff_t end) {
  const std::size_t number = tile_row * e.tiles_across + x;
  float* const tile = e.to + number * kTilePixels;
  const auto step = static_cast<std::ptrdiff_t>(e.width()), top = static_cast<std::ptrdiff_t>(tile_row * kTile);
  first = std::max(first, top);
  end = std::min(end, top + kTile);
  std::array<float, kTilePixels> least;
  least.fill(kOpen);
  for (std::size_t c = 0; c < kTile; c += hn::Lanes(kRow)) {
    find_least_up(e.rows + x * kTile + c, step, e.up[tile_row], first, end, least.data() + (first - top) * kTile + c);
  }
  Row farthest = hn::Set(kRow, hwy::HighestValue<float>()), nearest = hn::Set(kRow, kOpen);
  for (std::size_t i = 0; i < kTilePixels; i += hn::Lanes(kRow)) {
    const Row nearness = hn::Max(hn::LoadU(kRow, tile + i), hn::LoadU(kRow, least.data() + i));
    hn::StoreU(nearness, kRow, tile + i);
    farthest = hn::Min(farthest, nearness);
    nearest = hn::Max(nearest, nearness);
  }
  e.changed_to[number] = 1;
  e.farthest_to[number] = hn::GetLane(hn::MinOfLanes(kRow, farthest));
  e.nearest_to[number] = hn::GetLane(hn::MaxOfLanes(kRow, nearest));
}

/// Whether the nearer layer has changed in tiles of columns and rows from x0 and y0 to x1 and y1.
HWY_INLINE bool has_changed(const Erosion& e, std::size_t x0, std::size_t x1, std::size_t y0, std::size_t y1) {
  for (std::size_t y = y0; y <= y1; ++y) {
    for (std::size_t x = x0; x <= x1; ++x) {
      if (e.changed_from[y * e.tiles_across + x] != 0) return true;
    }
  }
  return false;
}

/// Finds the tiles that may come nearer, and those of the nearer layer that are asked for them.
HWY_INLINE void find_wanted(const Erosion& e) {
  std::fill(e.asked, e.asked + e.tiles_across * e.tiles_up, std::uint8_t{0});
  for (std::size_t y = 0; y < e.tiles_up; ++y) {
    const LayerErosion::Reach& up = e.up[y];
    const std::size_t below = std::min(y, tiles_of(-up.low)), above = std::min(e.tiles_up - 1 - y, tiles_of(up.high));
    for (std::size_t x = 0; x < e.tiles_across; ++x) {
      const std::size_t tile = y * e.tiles_across + x;
      const LayerErosion::Reach& across = e.across[x];
      const float nearest = e.nearest_from[tile];
      const bool is_wanted = nearest > e.never && nearest > e.farthest_to[tile] * (1 + kWorthShare) &&
                             !across.is_too_far() && !up.is_too_far() &&
                             has_changed(e, x - std::min(x, tiles_of(-across.low)),
                                         std::min(x + tiles_of(across.high), e.tiles_across - 1), y - below, y + above);
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
    const auto top = static_cast<std::ptrdiff_t>(y * kTile);
    if (std::max(first, top) >= std::min(end, top + kTile)) continue;
    for (std::size_t x = 0; x < e.tiles_across; ++x) {
      if (e.wanted[y * e.tiles_across + x] == 0) continue;
      bring_nearer(e, y, x, first, end);
    }
  }
  std::fill(e.changed_from, e.changed_from + e.tiles_across * e.tiles_up, std::uint8_t{0});
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
  strip_.assign(kStrips * kTile * (tiles_across_ * kTile + 2 * kMostReach), kOpen);
  rows_.resize(tiles_across_ * tiles_up_ * kTilePixels);
  wanted_.resize(2 * tiles_across_ * tiles_up_);
}

void LayerErosion::erode(std::size_t layer, float never, const Layers& layers) {
  const std::size_t tiles = tiles_across_ * tiles_up_;
  HWY_DYNAMIC_DISPATCH(erode)
  ({tiles_across_, tiles_up_, across_[layer].data(), up_[layer].data(), never, layers.nearness + tiles * kTilePixels,
    layers.nearest + tiles, layers.nearness, layers.nearest, layers.farthest, layers.has_changed + tiles, layers.has_changed,
    wanted_.data(), wanted_.data() + tiles, strip_.data(), rows_.data()});
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
