// SPDX-License-Identifier: MIT
// Compiled once for every instruction set, chosen at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cover_tile.cpp"
#include <hwy/foreach_target.h>
// foreach_target.h goes first.
#include <hwy/highway.h>

#include <algorithm>

#include "cover_tile.h"

HWY_BEFORE_NAMESPACE();
namespace occlude::culler {
namespace {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// At most eight pixels: a row of a tile.
using Floats = hn::CappedTag<float, kTile>;

int open_pixels(const TilePicture& picture, const PixelRectangle& r, float most, int enough) {
  const Floats d;
  const hn::RebindToSigned<Floats> di;
  const auto limit = hn::Set(d, most);
  const int lanes = static_cast<int>(hn::Lanes(d));
  int found = 0;
  for (int y = r.y0 & -kTile; y < r.y1; y += kTile) {
    const int row0 = std::max(r.y0 - y, 0), row1 = std::min(r.y1 - y, kTile);
    for (int x = r.x0 & -kTile; x < r.x1; x += kTile) {
      const int tile = y / kTile * picture.tiles_across + x / kTile;
      if (picture.farthest[tile] > most) continue;
      const float* const pixels = picture.nearness + tile * static_cast<int>(kTilePixels);
      for (int i = 0; i < kTile; i += lanes) {
        // For each column, minus the number of its open pixels.
        auto open = hn::Zero(di);
        for (int row = row0; row < row1; ++row) {
          open = hn::Add(open, hn::BitCast(di, hn::VecFromMask(d, hn::Le(hn::LoadU(d, pixels + row * kTile + i), limit))));
        }
        const auto column = hn::Add(hn::Iota(di, 0), hn::Set(di, x + i));
        const auto is_asked = hn::And(hn::Gt(column, hn::Set(di, r.x0 - 1)), hn::Lt(column, hn::Set(di, r.x1)));
        found -= hn::GetLane(hn::SumOfLanes(di, hn::IfThenElseZero(is_asked, open)));
      }
      if (found >= enough) return found;
    }
  }
  return found;
}

float bring_nearer(float* pixels, std::uint64_t mask, float nearness) {
  const Floats d;
  const auto near = hn::Set(d, nearness);
  auto least = hn::Set(d, hwy::HighestValue<float>());
  for (std::size_t i = 0; i < kTilePixels; i += hn::Lanes(d)) {
    const std::uint8_t bits[8] = {static_cast<std::uint8_t>(mask >> i)};
    const auto old = hn::LoadU(d, pixels + i);
    const auto now = hn::IfThenElse(hn::LoadMaskBits(d, bits), hn::Max(old, near), old);
    hn::StoreU(now, d, pixels + i);
    least = hn::Min(least, now);
  }
  return hn::GetLane(hn::MinOfLanes(d, least));
}

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace occlude::culler
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace occlude::culler {
namespace {
HWY_EXPORT(open_pixels);
HWY_EXPORT(bring_nearer);
}  // namespace

int open_pixels(const TilePicture& picture, const PixelRectangle& r, float most, int enough) {
  return HWY_DYNAMIC_DISPATCH(open_pixels)(picture, r, most, enough);
}

float bring_nearer(float* pixels, std::uint64_t mask, float nearness) {
  return HWY_DYNAMIC_DISPATCH(bring_nearer)(pixels, mask, nearness);
}

}  // namespace occlude::culler
#endif
