// SPDX-License-Identifier: MIT
// Compiled once for every instruction set, chosen at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cover_tile.cpp"
#include <hwy/foreach_target.h>
// foreach_target.h goes first.
#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <limits>

#include "cover_tile.h"

HWY_BEFORE_NAMESPACE();
namespace occlude::culler {
namespace {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// At most eight pixels: a row of a tile.
using Floats = hn::CappedTag<float, kTile>;

/// The numbers of at most `most` among `count` numbers, as bits. REQUIRES: count is a multiple of eight, at most 64.
template <int count>
HWY_INLINE std::uint64_t at_most(const float* numbers, float most) {
  const Floats d;
  std::uint64_t result = 0;
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    std::uint8_t bits[8] = {};
    hn::StoreMaskBits(d, hn::Le(hn::LoadU(d, numbers + i), hn::Set(d, most)), bits);
    result |= std::uint64_t{bits[0]} << i;
  }
  return result;
}

/// A bit for each whole number from `first` to before `end`, of those from 0 to 7.
HWY_INLINE std::uint64_t from_to(int first, int end) {
  const auto below = [](int n) { return (std::uint64_t{1} << std::clamp(n, 0, kTile)) - 1; };
  return below(end) & ~below(first);
}

/// The bits of a row of a tile, in each row from `first` to before `end`.
HWY_INLINE std::uint64_t in_rows(std::uint64_t row, int first, int end) {
  const int rows = std::min(end, kTile) - std::max(first, 0);
  constexpr std::uint64_t kEachRow = 0x0101'0101'0101'0101;
  return (row * kEachRow >> (kTile * (kTile - rows))) << (kTile * std::max(first, 0));
}

int open_pixels(const TilePicture& picture, const PixelRectangle& r, float most, int enough) {
  if (r.x0 >= r.x1 || r.y0 >= r.y1) return 0;  // a box beside the picture
  const int first = r.x0 / kTile, end = (r.x1 + kTile - 1) / kTile;
  int found = 0;
  for (int ty = r.y0 / kTile; ty * kTile < r.y1; ++ty) {
    for (int tx = first; tx < end; tx += kTile) {
      const int tile = ty * picture.tiles_across + tx;
      std::uint64_t left = at_most<kTile>(picture.farthest + tile, most) & from_to(0, end - tx);
      for (; left != 0; left &= left - 1) {
        const int i = std::countr_zero(left), x = (tx + i) * kTile;
        const std::uint64_t asked = in_rows(from_to(r.x0 - x, r.x1 - x), r.y0 - ty * kTile, r.y1 - ty * kTile);
        const float* const pixels = picture.nearness + (tile + i) * static_cast<int>(kTilePixels);
        found += std::popcount(at_most<kTilePixels>(pixels, most) & asked);
        if (found >= enough) return found;
      }
    }
  }
  return found;
}

/// Whether box i is in the picture and beyond the near plane, and no pixel that it touches is open.
HWY_INLINE bool is_hidden(const TilePicture& picture, const SeenBoxes& boxes, std::size_t i) {
  const PixelRectangle r{boxes.x0[i], boxes.y0[i], boxes.x1[i], boxes.y1[i]};
  const bool is_in_picture = r.x0 >= 0 && r.y0 >= 0 && r.x1 <= picture.width() && r.y1 <= picture.height();
  return is_in_picture && boxes.most[i] < std::numeric_limits<float>::infinity() &&
         HWY_NAMESPACE::open_pixels(picture, r, boxes.most[i], 1) == 0;
}

kernel::BoxBits hidden(const TilePicture& picture, const SeenBoxes& boxes, kernel::BoxBits asked) {
  unsigned hidden = 0;
  for (unsigned left = asked; left != 0; left &= left - 1) {
    const auto i = static_cast<unsigned>(std::countr_zero(left));
    hidden |= (is_hidden(picture, boxes, i) ? 1U : 0U) << i;
  }
  return static_cast<kernel::BoxBits>(hidden);
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
HWY_EXPORT(hidden);
HWY_EXPORT(bring_nearer);
}  // namespace

int open_pixels(const TilePicture& picture, const PixelRectangle& r, float most, int enough) {
  return HWY_DYNAMIC_DISPATCH(open_pixels)(picture, r, most, enough);
}

kernel::BoxBits hidden(const TilePicture& picture, const SeenBoxes& boxes, kernel::BoxBits asked) {
  return HWY_DYNAMIC_DISPATCH(hidden)(picture, boxes, asked);
}

float bring_nearer(float* pixels, std::uint64_t mask, float nearness) {
  return HWY_DYNAMIC_DISPATCH(bring_nearer)(pixels, mask, nearness);
}

}  // namespace occlude::culler
#endif
