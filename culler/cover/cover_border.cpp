// SPDX-License-Identifier: MIT
// Compiled once for each instruction set. The best one is chosen at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cover/cover_border.cpp"
#include <hwy/foreach_target.h>
// foreach_target.h must come first.
#include <hwy/highway.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>

#include "base/rounded_float.h"
#include "cover/cover_border.h"
#include "cover/cover_outline.h"
#include "cover/projected_edge.h"

#ifndef OCCLUDE_COVER_BORDER_ONCE
#define OCCLUDE_COVER_BORDER_ONCE
namespace occlude::culler {
namespace {

/// The tiles that a border is drawn into.
struct BorderTiles {
  BorderTile* tiles;
  int across;
  std::uint32_t border;

  /// The tile at a place. It is emptied when this border first asks for it.
  BorderTile& at(int x, int y) const {
    BorderTile& tile = tiles[y * across + x];
    if (tile.border != border) tile = {.border = border};
    return tile;
  }
};

/// A piece of an edge in floats. It starts at (x, y), goes right by `slope` for each row upwards, and is `rise` rows high.
struct EdgePart {
  double y;
  float x, slope, rise;
  float error, wide;  ///< bounds of its vertical and its horizontal error
  int row0, row1;     ///< rows of the picture to draw
  float left, right;  ///< columns to draw
};

/// A convex quadrangle. Each side starts at (x, y), goes right by `slope` for each row upwards, and is `rise` rows high.
struct QuadrangleRows {
  std::array<double, 4> x, y, slope, rise;
  double error, wide;  ///< bounds of their vertical and their horizontal error
  int row0, row1;      ///< rows of the picture to draw
  double left, right;  ///< columns to draw
};

/// An edge as a function of columns: its height in the middle of the first one, and the change for each further one.
struct EdgeColumns {
  double y, slope;
  int column0, column1;  ///< to draw
  int row0, row1;
};

}  // namespace
}  // namespace occlude::culler
#endif

HWY_BEFORE_NAMESPACE();
namespace occlude::culler {
namespace {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// A lane for each row or column of a tile. Nothing is fused, so the results do not depend on the number of lanes.
using FloatTag = hn::CappedTag<float, kTile>;
using IntegerTag = hn::RebindToSigned<FloatTag>;
using Floats = hn::Vec<FloatTag>;
using Integers = hn::Vec<IntegerTag>;

constexpr FloatTag kD;
constexpr IntegerTag kDi;

template <class Numbers>
HWY_INLINE Numbers clamp(Numbers x, Numbers low, Numbers high) {
  return hn::Min(hn::Max(x, low), high);
}
HWY_INLINE Integers clamp_to_tile(Integers x) { return hn::Min(hn::Max(x, hn::Zero(kDi)), hn::Set(kDi, kTile)); }

/// Touches pixels in the rows of a tile from y upwards: in each row the columns from x0 to before x1.
HWY_INLINE void touch_rows(const BorderTiles& tiles, int y, Integers x0, Integers x1) {
  const hn::Rebind<std::uint32_t, IntegerTag> du;
  const hn::Rebind<std::uint8_t, IntegerTag> bytes;
  const int first = hn::GetLane(hn::MinOfLanes(kDi, x0)), end = hn::GetLane(hn::MaxOfLanes(kDi, x1));
  const auto one = hn::Set(du, 1);
  for (int x = first & -kTile; x < end; x += kTile) {
    const Integers low = clamp_to_tile(hn::Sub(x0, hn::Set(kDi, x)));
    const Integers high = hn::Max(low, clamp_to_tile(hn::Sub(x1, hn::Set(kDi, x))));
    const auto bits = hn::Sub(hn::Shl(one, hn::BitCast(du, high)), hn::Shl(one, hn::BitCast(du, low)));
    std::uint64_t rows = 0;
    std::uint8_t row_bytes[kTile] = {};
    hn::StoreU(hn::U8FromU32(bits), bytes, row_bytes);
    // The first row is the lowest byte, which a big-endian machine reads as the highest.
    if constexpr (std::endian::native == std::endian::big) std::ranges::reverse(row_bytes);
    std::memcpy(&rows, row_bytes, sizeof rows);
    tiles.at(x / kTile, y / kTile).touched |= rows << (y % kTile * kTile);
  }
}

void touch(const BorderTiles& tiles, const EdgePart& edge) {
  const Floats zero = hn::Zero(kD), one = hn::Set(kD, 1.0F), rise = hn::Set(kD, edge.rise), slope = hn::Set(kD, edge.slope);
  const Floats x = hn::Set(kD, edge.x), error = hn::Set(kD, edge.error), wide = hn::Set(kD, edge.wide);
  const Floats left = hn::Set(kD, edge.left), right = hn::Set(kD, edge.right);
  const int lanes = static_cast<int>(hn::Lanes(kD));
  for (int y = edge.row0 & -lanes; y < edge.row1; y += lanes) {
    const Floats row = hn::Add(hn::Set(kD, static_cast<float>(y - edge.y)), hn::Iota(kD, 0));
    const Floats from = hn::Sub(row, error), to = hn::Add(hn::Add(row, one), error);
    const Floats first = hn::Add(x, hn::Mul(clamp(from, zero, rise), slope));
    const Floats last = hn::Add(x, hn::Mul(clamp(to, zero, rise), slope));
    const Integers rows = hn::Add(hn::Set(kDi, y), hn::Iota(kDi, 0));
    const auto is_drawn = hn::And(
        hn::And(hn::Ge(to, zero), hn::Le(from, rise)),
        hn::RebindMask(kD, hn::And(hn::Gt(rows, hn::Set(kDi, edge.row0 - 1)), hn::Lt(rows, hn::Set(kDi, edge.row1)))));
    const Floats low = clamp(hn::Sub(hn::Min(first, last), wide), left, right);
    const Floats high = clamp(hn::Add(hn::Add(hn::Max(first, last), wide), one), left, right);
    touch_rows(tiles, y, hn::ConvertTo(kDi, hn::IfThenElse(is_drawn, low, right)),
               hn::ConvertTo(kDi, hn::IfThenElse(is_drawn, high, left)));
  }
}

/// In each row, touches what is between the sides. In floats, a side that leads far beyond the tiles would be too inexact.
void fill(const BorderTiles& tiles, const QuadrangleRows& q) {
  const hn::CappedTag<double, kTile> d;
  const hn::Rebind<std::int32_t, decltype(d)> to;
  const auto zero = hn::Zero(d), infinity = hn::Inf(d), error = hn::Set(d, q.error), wide = hn::Set(d, q.wide);
  const auto left = hn::Set(d, q.left), right = hn::Set(d, q.right), one = hn::Set(d, 1.0);
  const int lanes = static_cast<int>(hn::Lanes(d));
  for (int y = q.row0 & -kTile; y < q.row1; y += kTile) {
    std::int32_t first[kTile], end[kTile];
    for (int i = 0; i < kTile; i += lanes) {
      const auto row = hn::Add(hn::Set(d, static_cast<double>(y + i)), hn::Iota(d, 0));
      auto low = infinity, high = hn::Neg(infinity);
      for (std::size_t s = 0; s < 4; ++s) {
        const auto from = hn::Sub(hn::Sub(row, hn::Set(d, q.y[s])), error);
        const auto upto = hn::Add(hn::Add(hn::Sub(row, hn::Set(d, q.y[s])), one), error);
        const auto rise = hn::Set(d, q.rise[s]), slope = hn::Set(d, q.slope[s]), x = hn::Set(d, q.x[s]);
        const auto is_there = hn::And(hn::Ge(upto, zero), hn::Le(from, rise));
        const auto a = hn::Add(x, hn::Mul(clamp(from, zero, rise), slope));
        const auto b = hn::Add(x, hn::Mul(clamp(upto, zero, rise), slope));
        low = hn::IfThenElse(is_there, hn::Min(low, hn::Min(a, b)), low);
        high = hn::IfThenElse(is_there, hn::Max(high, hn::Max(a, b)), high);
      }
      const auto is_drawn = hn::And(hn::Le(low, high), hn::And(hn::Ge(row, hn::Set(d, static_cast<double>(q.row0))),
                                                               hn::Lt(row, hn::Set(d, static_cast<double>(q.row1)))));
      low = hn::IfThenElse(is_drawn, clamp(hn::Sub(low, wide), left, right), right);
      high = hn::IfThenElse(is_drawn, clamp(hn::Add(hn::Add(high, wide), one), left, right), left);
      hn::StoreU(hn::DemoteTo(to, low), to, first + i);
      hn::StoreU(hn::DemoteTo(to, high), to, end + i);
    }
    for (int i = 0; i < kTile; i += static_cast<int>(hn::Lanes(kDi))) {
      touch_rows(tiles, y + i, hn::LoadU(kDi, first + i), hn::LoadU(kDi, end + i));
    }
  }
}

/// Turns in each column the first pixel whose middle is above the edge.
void turn(const BorderTiles& tiles, const EdgeColumns& edge) {
  // In floats a turn could come some rows beyond the end of an edge that is millions of pixels long.
  const hn::CappedTag<double, kTile> d;
  const hn::Rebind<std::int32_t, decltype(d)> rows_of;
  const hn::Rebind<std::uint32_t, decltype(d)> shifts_of;
  const hn::Rebind<std::uint64_t, decltype(d)> bits_of;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto half = hn::Set(d, 0.5), low = hn::Set(d, edge.row0), high = hn::Set(d, edge.row1);
  const auto slopes = hn::Mul(hn::Iota(d, 0), hn::Set(d, edge.slope));
  for (int x = edge.column0, end = x; x < edge.column1; x = end) {
    end = std::min({x + lanes, (x & -kTile) + kTile, edge.column1});  // of columns of one tile
    const auto y = hn::Add(hn::Set(d, edge.y + (x - edge.column0) * edge.slope), slopes);
    const auto rows = hn::DemoteTo(rows_of, clamp(hn::Add(y, half), low, high));
    const auto in_tile = hn::ShiftLeft<kTileBits>(hn::And(rows, hn::Set(rows_of, kTile - 1)));
    const auto shifts = hn::And(hn::Add(in_tile, hn::Iota(rows_of, x % kTile)), hn::Set(rows_of, kTilePixels - 1));
    const auto bits = hn::Shl(hn::Set(bits_of, 1), hn::PromoteTo(bits_of, hn::BitCast(shifts_of, shifts)));
    const auto turn_in = [&](int tile, std::uint64_t parity_flips) {
      if (tile < edge.row1 / kTile) tiles.at(x / kTile, tile).parity_flips ^= parity_flips;
    };
    const auto count = static_cast<std::size_t>(end - x);
    const auto tile_rows = hn::ShiftRight<kTileBits>(rows);
    const int first = hn::GetLane(tile_rows);
    const auto are_elsewhere = hn::And(hn::FirstN(rows_of, count), hn::Ne(tile_rows, hn::Set(rows_of, first)));
    if (hn::AllFalse(rows_of, are_elsewhere)) {
      // The bits differ, so their sum has them all.
      turn_in(first, hn::GetLane(hn::SumOfLanes(bits_of, hn::IfThenElseZero(hn::FirstN(bits_of, count), bits))));
      continue;
    }
    std::int32_t tile_of[kTile] = {};
    std::uint64_t bit[kTile] = {};
    hn::StoreU(tile_rows, rows_of, tile_of);
    hn::StoreU(bits, bits_of, bit);
    for (std::size_t i = 0; i < count; ++i) turn_in(tile_of[i], bit[i]);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace occlude::culler
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace occlude::culler {
namespace {
HWY_EXPORT(touch);
HWY_EXPORT(fill);
HWY_EXPORT(turn);

/// The pixels with an odd number of turns among them and those below them.
std::uint64_t turned_below(std::uint64_t parity_flips) {
  for (int rows = 1; rows < kTile; rows *= 2) parity_flips ^= parity_flips << (rows * kTile);
  return parity_flips;
}

constexpr double kLeastRise = 0x1p-20;
/// Slopes and heights are limited to this, so that sums stay finite. No edge in a picture is that steep or that far away.
constexpr double kMost = 0x1p1000;
}  // namespace

void CoverBorder::begin(const ConservativeViewport& picture, const PixelRectangle& tiles) {
  picture_ = picture;
  tiles_across_ = picture.width() / kTile;
  tiles_ = tiles;
  pixels_ = {tiles.x0 * kTile, tiles.y0 * kTile, tiles.x1 * kTile, tiles.y1 * kTile};
  const std::size_t count = static_cast<std::size_t>(tiles_across_) * static_cast<std::size_t>(picture.height() / kTile);
  if (++border_ == 0 || drawn_.size() != count) {
    drawn_.assign(count, {});
    border_ = 1;
  }
  enclosed_.resize(static_cast<std::size_t>(tiles_across_));
}

void CoverBorder::draw(const BoundedPosition& from, const BoundedPosition& to) {
  touch(from, to);
  turn(from, to);
}

/// Each end is within its own error of where the eyes move it, and the edge is between them.
void CoverBorder::draw(const MovedPosition& from, const MovedPosition& to, const SweptEdge& swept) {
  CoverOutline::Extent extent;
  extent.hold(from);
  extent.hold(to);
  if (extent.may_meet(pixels_)) touch(swept, {extent.low, extent.high});
  turn(from, to);
}

void CoverBorder::turn(const BoundedPosition& from, const BoundedPosition& to) {
  if (from.place.x <= to.place.x) {
    turn(from.place, to.place);
  } else {
    turn(to.place, from.place);
  }
}

/// Each end is within its own error of where it was found, and the edge is between them.
bool CoverBorder::may_touch(const BoundedPosition& from, const BoundedPosition& to) const {
  const auto beside = [](double a, double a_error, double b, double b_error, double low, double high) {
    return (a + a_error < low && b + b_error < low) || (a - a_error > high && b - b_error > high);
  };
  return !beside(from.place.x, from.error, to.place.x, to.error, pixels_.x0, pixels_.x1) &&
         !beside(from.place.y, from.error, to.place.y, to.error, pixels_.y0, pixels_.y1);
}

void CoverBorder::touch(const BoundedPosition& from, const BoundedPosition& to) {
  if (!may_touch(from, to)) return;
  const ProjectedEdge edge(from, to, picture_.edge_error(from, to));
  const auto part = edge.within({{static_cast<double>(pixels_.x0), static_cast<double>(pixels_.y0)},
                                 {static_cast<double>(pixels_.x1), static_cast<double>(pixels_.y1)}});
  if (!part) return;
  const auto& [low, high] = *part;
  // Floats round by u = 2^-24 of a number. The distance of a row from the edge's low end takes three roundings, a position
  // on the edge five. The bounds are more than twice that, which leaves room for second-order terms. An edge that is nearly
  // level gets a rise of kLeastRise, so that its slope stays in range; the error includes it.
  const double rise = std::max(high.y - low.y, kLeastRise);
  const double error = edge.error() + kLeastRise + 0x1p-21 * (rise + kTile);
  const double wide = edge.wide() + 0x1p-20 * (std::fabs(low.x) + std::fabs(high.x));
  const int row0 = std::max(pixel_at(low.y - error, picture_.height()), pixels_.y0);
  const int row1 = std::min(pixel_at(low.y + rise + error, picture_.height()) + 1, pixels_.y1);
  if (row0 >= row1) return;
  HWY_DYNAMIC_DISPATCH(touch)
  ({drawn_.data(), tiles_across_, border_},
   {low.y, static_cast<float>(low.x), static_cast<float>((high.x - low.x) / rise), static_cast<float>(rise),
    rounded_up(error), rounded_up(wide), row0, row1, static_cast<float>(pixels_.x0), static_cast<float>(pixels_.x1)});
}

/// Touches what is in the quadrangle and within the bounds.
void CoverBorder::touch(const SweptEdge& edge, const PixelBounds& within) {
  QuadrangleRows q{};
  double low = edge.corners[0].y, high = low, size = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    const PixelPosition &a = edge.corners[i], &b = edge.corners[(i + 1) % 4];
    const PixelPosition &from = a.y <= b.y ? a : b, &to = a.y <= b.y ? b : a;
    q.x[i] = from.x;
    q.y[i] = from.y;
    q.rise[i] = std::max(to.y - from.y, kLeastRise);
    q.slope[i] = (to.x - from.x) / q.rise[i];
    low = std::min(low, a.y);
    high = std::max(high, a.y);
    size = std::max(size, std::fabs(a.x) + std::fabs(a.y));
  }
  // In units of 2^-53 of the size, a distance of rows rounds by 3, and a position on a side by 10. A side that is nearly
  // level gets a rise of kLeastRise, which is part of the error.
  q.error = edge.error + kLeastRise + 0x1p-48 * size;
  q.wide = edge.error + 0x1p-48 * size;
  q.row0 = std::max(pixel_at(std::max(low - q.error, within.low.y), picture_.height()), pixels_.y0);
  q.row1 = std::min(pixel_at(std::min(high + kLeastRise + q.error, within.high.y), picture_.height()) + 1, pixels_.y1);
  q.left = std::max(pixel_at(within.low.x, picture_.width()), pixels_.x0);
  q.right = std::min(pixel_at(within.high.x, picture_.width()) + 1, pixels_.x1);
  if (q.row0 < q.row1 && q.left < q.right) HWY_DYNAMIC_DISPATCH(fill)({drawn_.data(), tiles_across_, border_}, q);
}

/// Turns the columns whose middle is beyond a.x and not beyond b.x. Their heights round ten times, by 2^-53 of what is below
/// 4 times the height of the farther end. The errors of the ends include that.
void CoverBorder::turn(const PixelPosition& a, const PixelPosition& b) {
  const double run = b.x - a.x;
  if (!(run > 0)) return;
  const auto first_from = [&](double x) { return std::clamp(first_middle(x, picture_.width()), pixels_.x0, pixels_.x1); };
  const int column0 = first_from(a.x), column1 = first_from(b.x);
  if (column0 >= column1) return;
  const double slope = std::clamp((b.y - a.y) / run, -kMost, kMost);
  const double y = std::clamp(a.y + (column0 + 0.5 - a.x) * slope, -kMost, kMost);
  HWY_DYNAMIC_DISPATCH(turn)
  ({drawn_.data(), tiles_across_, border_}, {y, slope, column0, column1, pixels_.y0, pixels_.y1});
}

/// Goes through the tiles row by row, from below.
void CoverBorder::find_closed(std::vector<std::uint64_t>& closed) {
  std::fill(enclosed_.begin() + tiles_.x0, enclosed_.begin() + tiles_.x1, 0);
  for (int y = tiles_.y0; y < tiles_.y1; ++y) {
    for (int x = tiles_.x0; x < tiles_.x1; ++x) {
      const auto at = static_cast<std::size_t>(y * tiles_across_ + x);
      const BorderTile& tile = drawn_[at];
      std::uint8_t& below = enclosed_[static_cast<std::size_t>(x)];
      const bool is_drawn = tile.border == border_;
      const std::uint64_t enclosed = (0x0101010101010101U * below) ^ (is_drawn ? turned_below(tile.parity_flips) : 0);
      closed[at] = is_drawn ? enclosed & ~tile.touched : enclosed;
      below = static_cast<std::uint8_t>(enclosed >> (kTilePixels - kTile));
    }
  }
}

}  // namespace occlude::culler
#endif
