// SPDX-License-Identifier: MIT
// Compiled once for every instruction set, chosen at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cover/cover_tile.cpp"
#include <hwy/foreach_target.h>
// foreach_target.h goes first.
#include <hwy/highway.h>

#include <algorithm>
#include <bit>
#include <limits>

#include "cover/cover_tile.h"

HWY_BEFORE_NAMESPACE();
namespace occlude::culler {
namespace {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// At most eight: tiles that lie side by side, or the boxes of a block.
using FloatTag = hn::CappedTag<float, kTile>;
using IntegerTag = hn::RebindToSigned<FloatTag>;
using Floats = hn::Vec<FloatTag>;
using Integers = hn::Vec<IntegerTag>;
using Mask = hn::Mask<FloatTag>;

/// At most sixteen: pixels of two rows of a tile.
using RowsTag = hn::CappedTag<float, 2 * kTile>;

constexpr FloatTag kFloats;
constexpr RowsTag kRows;
constexpr IntegerTag kIntegers;

/// A bit for each lane of a mask, which has at most sixteen.
template <class Tag>
HWY_INLINE unsigned bits_of(Tag d, hn::Mask<Tag> mask) {
  std::uint8_t bits[8] = {};
  hn::StoreMaskBits(d, mask, bits);
  return bits[0] | unsigned{bits[1]} << 8U;
}
/// The reverse. Bits beyond the lanes are ignored.
template <class Tag>
HWY_INLINE hn::Mask<Tag> mask_of(Tag d, std::uint64_t lanes) {
  const std::uint8_t bits[8] = {static_cast<std::uint8_t>(lanes), static_cast<std::uint8_t>(lanes >> 8U)};
  return hn::LoadMaskBits(d, bits);
}

/// A bit for each of the numbers from `first` to before `end` that is at most `most`: bit i for number i. Those after `end`
/// may have one, too, up to a multiple of the lanes. REQUIRES: `first` is such a multiple, and end <= 64.
template <class Tag>
HWY_INLINE std::uint64_t at_most(Tag d, const float* numbers, float most, std::size_t first, std::size_t end) {
  std::uint64_t result = 0;
  for (std::size_t i = first; i < end; i += hn::Lanes(d)) {
    result |= std::uint64_t{bits_of(d, hn::Le(hn::LoadU(d, numbers + i), hn::Set(d, most)))} << i;
  }
  return result;
}

/// How many pixels of a tile have a nearness of at most `most`, of those in the columns of a mask and in rows from `first`
/// to before `end`. REQUIRES: 0 <= first < end <= kTile.
HWY_INLINE int open_in_tile(const float* pixels, float most, std::uint64_t columns, int first, int end) {
  const auto at = [](int row) { return static_cast<std::size_t>(row) * kTile; };
  const std::uint64_t open = at_most(kRows, pixels, most, at(first) & -hn::Lanes(kRows), at(end));
  return std::popcount(open & pixels_of(columns, first, end));
}

int open_pixels(const TilePicture& picture, const PixelRectangle& r, float most, int enough) {
  if (r.x0 >= r.x1 || r.y0 >= r.y1) return 0;  // a box beside the picture
  const int first = r.x0 / kTile, end = (r.x1 + kTile - 1) / kTile;
  int found = 0;
  for (int ty = r.y0 / kTile; ty * kTile < r.y1; ++ty) {
    const int row0 = std::max(r.y0 - ty * kTile, 0), row1 = std::min(r.y1 - ty * kTile, kTile);
    for (int tx = first; tx < end; tx += kTile) {
      const int tile = ty * picture.tiles_across + tx;
      std::uint64_t left = at_most(kFloats, picture.farthest + tile, most, 0, kTile) & from_to(0, end - tx);
      for (; left != 0; left &= left - 1) {
        const int i = std::countr_zero(left), x = (tx + i) * kTile;
        const float* const pixels = picture.nearness + (tile + i) * static_cast<int>(kTilePixels);
        found += open_in_tile(pixels, most, from_to(r.x0 - x, r.x1 - x), row0, row1);
        if (found >= enough) return found;
      }
    }
  }
  return found;
}

/// Several boxes, of which a few numbers often tell.
class Boxes {
 public:
  Boxes(const TilePicture& picture, const BoxPixels& boxes, std::size_t first)
      : picture_(picture),
        most_(hn::LoadU(kFloats, &boxes.most[first])),
        x0_(hn::LoadU(kIntegers, &boxes.x0[first])),
        y0_(hn::LoadU(kIntegers, &boxes.y0[first])),
        x1_(hn::LoadU(kIntegers, &boxes.x1[first])),
        y1_(hn::LoadU(kIntegers, &boxes.y1[first])),
        first_tile_(hn::LoadU(kIntegers, &boxes.first_tile[first])) {}

  /// Those that are in the picture and beyond the near plane.
  [[nodiscard]] Mask in_picture() const {
    const Integers zero = hn::Zero(kIntegers);
    const auto beside = hn::Or(hn::Lt(x0_, zero), hn::Gt(x1_, hn::Set(kIntegers, picture_.width())));
    const auto above = hn::Or(hn::Lt(y0_, zero), hn::Gt(y1_, hn::Set(kIntegers, picture_.height())));
    return hn::AndNot(hn::RebindMask(kFloats, hn::Or(beside, above)), hn::Lt(most_, hn::Inf(kFloats)));
  }

  /// Those of the asked boxes that touch a pixel.
  [[nodiscard]] Mask touching(Mask asked) const {
    return hn::And(asked, hn::RebindMask(kFloats, hn::And(hn::Lt(x0_, x1_), hn::Lt(y0_, y1_))));
  }

  /// Those of the asked boxes that an upper corner shows to be open. Nine of ten visible boxes of a town are among them.
  /// REQUIRES: the asked boxes touch pixels of the picture; so below.
  [[nodiscard]] Mask open_in_upper_corner(Mask asked) const { return open_in_row(asked, previous(y1_)); }
  [[nodiscard]] Mask open_in_lower_corner(Mask asked) const { return open_in_row(asked, y0_); }

  /// Those of the asked boxes that have no pixels but their corners. The corners decide them exactly.
  [[nodiscard]] Mask of_corners_alone(Mask asked) const {
    const Integers two = hn::Set(kIntegers, 2);
    const auto is_larger = hn::Or(hn::Gt(hn::Sub(x1_, x0_), two), hn::Gt(hn::Sub(y1_, y0_), two));
    return hn::AndNot(hn::RebindMask(kFloats, is_larger), asked);
  }

  /// Those of the asked boxes that are behind all pixels of their tiles, which are at most two across and up.
  [[nodiscard]] Mask behind_tiles(Mask asked) const {
    const Integers left = tile(x0_), right = tile(previous(x1_)), low = tile(y0_), top = tile(previous(y1_));
    const Integers two = hn::Set(kIntegers, 2);
    const auto are_few = hn::And(hn::Lt(hn::Sub(right, left), two), hn::Lt(hn::Sub(top, low), two));
    const Mask few = hn::And(asked, hn::RebindMask(kFloats, are_few));
    const Floats lower = hn::Min(farthest(few, left, low), farthest(few, right, low));
    const Floats upper = hn::Min(farthest(few, left, top), farthest(few, right, top));
    return hn::And(few, hn::Gt(hn::Min(lower, upper), most_));
  }

 private:
  static Integers previous(Integers i) { return hn::Sub(i, hn::Set(kIntegers, 1)); }
  static Integers tile(Integers pixel) { return hn::ShiftRight<kTileBits>(pixel); }
  static Integers in_tile(Integers pixel) { return hn::And(pixel, hn::Set(kIntegers, kTile - 1)); }
  [[nodiscard]] Integers tile_index(Integers across, Integers up) const {
    return hn::Add(first_tile_, hn::Add(hn::Mul(up, hn::Set(kIntegers, picture_.tiles_across)), across));
  }

  /// Those of the asked boxes that are open in their first or last pixel of a row.
  [[nodiscard]] Mask open_in_row(Mask asked, Integers y) const {
    const Floats nearness = hn::Min(pixel(asked, x0_, y), pixel(asked, previous(x1_), y));
    return hn::And(asked, hn::Le(nearness, most_));
  }

  /// The nearness of a pixel for each of the asked boxes.
  [[nodiscard]] Floats pixel(Mask asked, Integers x, Integers y) const {
    const Integers at = hn::Add(hn::ShiftLeft<kTileBits>(in_tile(y)), in_tile(x));
    return gather(picture_.nearness, asked, hn::Add(hn::ShiftLeft<2 * kTileBits>(tile_index(tile(x), tile(y))), at));
  }
  /// The least nearness in a tile for each of the asked boxes.
  [[nodiscard]] Floats farthest(Mask asked, Integers across, Integers up) const {
    return gather(picture_.farthest, asked, tile_index(across, up));
  }
  [[nodiscard]] static Floats gather(const float* numbers, Mask asked, Integers index) {
    return hn::GatherIndex(kFloats, numbers, hn::IfThenElseZero(hn::RebindMask(kIntegers, asked), index));
  }

  const TilePicture& picture_;
  Floats most_;
  Integers x0_, y0_, x1_, y1_, first_tile_;
};

/// Those of the asked boxes, a lane each from `first`, that are hidden.
HWY_INLINE unsigned hidden_lanes(const TilePicture& picture, const BoxPixels& boxes, std::size_t first, unsigned asked) {
  const Boxes several(picture, boxes, first);
  const Mask in_picture = hn::And(several.in_picture(), mask_of(kFloats, asked));
  const Mask touching = several.touching(in_picture);
  unsigned hidden = bits_of(kFloats, hn::AndNot(touching, in_picture));  // these lie beside the picture
  if (hn::AllFalse(kFloats, touching)) return hidden;
  const Mask closed_above = hn::AndNot(several.open_in_upper_corner(touching), touching);
  if (hn::AllFalse(kFloats, closed_above)) return hidden;
  const Mask closed = hn::AndNot(several.open_in_lower_corner(closed_above), closed_above);
  const Mask small = several.of_corners_alone(closed);
  hidden |= bits_of(kFloats, small);
  const Mask left = hn::AndNot(small, closed);
  if (hn::AllFalse(kFloats, left)) return hidden;
  const Mask behind_tiles = several.behind_tiles(left);
  hidden |= bits_of(kFloats, behind_tiles);
  for (unsigned rest = bits_of(kFloats, hn::AndNot(behind_tiles, left)); rest != 0; rest &= rest - 1) {
    const auto lane = static_cast<unsigned>(std::countr_zero(rest));
    const std::size_t i = first + lane;
    const PixelRectangle touched{boxes.x0[i], boxes.y0[i], boxes.x1[i], boxes.y1[i]};
    hidden |= (HWY_NAMESPACE::open_pixels(picture.from(boxes.first_tile[i]), touched, boxes.most[i], 1) == 0 ? 1U : 0U)
              << lane;
  }
  return hidden;
}

kernel::BoxBits hidden(const TilePicture& picture, const BoxPixels& boxes, kernel::BoxBits asked) {
  unsigned hidden = 0;
  for (std::size_t first = 0; first < boxes.size; first += hn::Lanes(kFloats)) {
    hidden |= hidden_lanes(picture, boxes, first, unsigned{asked} >> first) << first;
  }
  return static_cast<kernel::BoxBits>(hidden);
}

/// Returns the least nearness of all pixels of the tile.
HWY_INLINE float bring_nearer_in_tile(float* pixels, std::uint64_t mask, float nearness) {
  const auto near = hn::Set(kRows, nearness);
  auto least = hn::Set(kRows, hwy::HighestValue<float>());
  for (std::size_t i = 0; i < kTilePixels; i += hn::Lanes(kRows)) {
    const auto old = hn::LoadU(kRows, pixels + i);
    const auto now = hn::IfThenElse(mask_of(kRows, mask >> i), hn::Max(old, near), old);
    hn::StoreU(now, kRows, pixels + i);
    least = hn::Min(least, now);
  }
  return hn::GetLane(hn::MinOfLanes(kRows, least));
}

void bring_nearer(float* pixels, std::span<float> farthest, const std::uint64_t* closed, const float* nearness) {
  for (std::size_t i = 0; i < farthest.size(); ++i) {
    const bool is_there = closed[i] != 0 && nearness[i] < std::numeric_limits<float>::infinity();
    if (!is_there || nearness[i] <= farthest[i]) continue;
    farthest[i] = bring_nearer_in_tile(pixels + i * kTilePixels, closed[i], nearness[i]);
  }
}

std::uint64_t pixels_up_to(const float* pixels, float most) { return at_most(kRows, pixels, most, 0, kTilePixels); }

/// A tile per lane. Nothing is fused, so the results do not depend on the number of lanes.
void lower(const TileNearness& picture, const PixelRectangle& tiles, const PlaneBound& plane, float least) {
  const hn::CappedTag<double, kTile> d;
  const hn::Rebind<float, decltype(d)> to;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const double* const slopes_x = picture.slopes_x + (plane.of_x > 0 ? 0 : 1);
  const double* const slopes_y = picture.slopes_y + (plane.of_y > 0 ? 0 : 1);
  const auto scale = hn::Set(d, plane.scale);
  for (int x = tiles.x0; x < tiles.x1; x += lanes) {
    const auto of_x = hn::Mul(hn::Set(d, plane.of_x), hn::LoadU(d, slopes_x + x));
    const auto are_there = hn::FirstN(to, static_cast<std::size_t>(tiles.x1 - x));
    for (int y = tiles.y0; y < tiles.y1; ++y) {
      const auto value = hn::Add(hn::Set(d, plane.constant + plane.of_y * slopes_y[y]), of_x);
      const auto bound = hn::Mul(value, scale);
      // As rounded_down(), which takes off 2^-24 more than a float rounds by.
      const auto rounding = hn::Add(hn::Mul(hn::Set(d, 0x1p-23), hn::Abs(bound)), hn::Set(d, 0x1p-149));
      const auto found = hn::Max(hn::DemoteTo(to, hn::Sub(bound, rounding)), hn::Set(to, least));
      float* const nearness = picture.nearness + y * picture.tiles_across + x;
      const auto old = hn::LoadU(to, nearness);
      hn::StoreU(hn::IfThenElse(are_there, hn::Min(old, found), old), to, nearness);
    }
  }
}

/// is_nearer(i, farthest) is asked about the tiles from i on.
template <class IsNearer>
HWY_INLINE TileRange nearer_range(std::span<const float> farthest, const IsNearer& is_nearer) {
  TileRange range{static_cast<int>(farthest.size()), 0};
  for (std::size_t i = 0; i < farthest.size(); i += hn::Lanes(kFloats)) {
    const Mask tiles = hn::FirstN(kFloats, farthest.size() - i);
    const unsigned bits = bits_of(kFloats, hn::And(tiles, is_nearer(i, hn::LoadU(kFloats, farthest.data() + i))));
    if (bits == 0) continue;
    range.first = std::min(range.first, static_cast<int>(i) + std::countr_zero(bits));
    range.end = static_cast<int>(i) + static_cast<int>(std::bit_width(bits));
  }
  return range;
}

TileRange nearer_than(std::span<const float> farthest, float nearness) {
  return nearer_range(farthest, [&](std::size_t, Floats far) HWY_ATTR { return hn::Gt(hn::Set(kFloats, nearness), far); });
}

TileRange each_nearer(std::span<const float> farthest, const float* nearness) {
  return nearer_range(farthest, [&](std::size_t i, Floats far) HWY_ATTR {
    const Floats near = hn::LoadU(kFloats, nearness + i);
    return hn::And(hn::Gt(near, far), hn::Lt(near, hn::Inf(kFloats)));
  });
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
HWY_EXPORT(lower);
HWY_EXPORT(nearer_than);
HWY_EXPORT(each_nearer);
HWY_EXPORT(bring_nearer);
HWY_EXPORT(pixels_up_to);
}  // namespace

int open_pixels(const TilePicture& picture, const PixelRectangle& r, float most, int enough) {
  return HWY_DYNAMIC_DISPATCH(open_pixels)(picture, r, most, enough);
}

kernel::BoxBits hidden(const TilePicture& picture, const BoxPixels& boxes, kernel::BoxBits asked) {
  return HWY_DYNAMIC_DISPATCH(hidden)(picture, boxes, asked);
}

void lower(const TileNearness& picture, const PixelRectangle& tiles, const PlaneBound& plane, float least) {
  HWY_DYNAMIC_DISPATCH(lower)(picture, tiles, plane, least);
}

TileRange nearer(std::span<const float> farthest, float nearness) {
  return HWY_DYNAMIC_DISPATCH(nearer_than)(farthest, nearness);
}

TileRange nearer(std::span<const float> farthest, const float* nearness) {
  return HWY_DYNAMIC_DISPATCH(each_nearer)(farthest, nearness);
}

void bring_nearer(float* pixels, std::span<float> farthest, const std::uint64_t* closed, const float* nearness) {
  HWY_DYNAMIC_DISPATCH(bring_nearer)(pixels, farthest, closed, nearness);
}

std::uint64_t pixels_up_to(const float* pixels, float most) { return HWY_DYNAMIC_DISPATCH(pixels_up_to)(pixels, most); }

}  // namespace occlude::culler
#endif
