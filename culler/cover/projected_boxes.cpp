// SPDX-License-Identifier: MIT
// Compiled once for each instruction set. The best one is chosen at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "cover/projected_boxes.cpp"
#include <hwy/foreach_target.h>
// foreach_target.h must come first.
#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>

#include "cover/projected_boxes.h"

HWY_BEFORE_NAMESPACE();
namespace occlude::culler {
namespace {
namespace HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

/// One box per lane. Nothing is fused, so the results do not depend on the number of lanes.
using FloatTag = hn::CappedTag<float, ProjectedBoxes::kMost>;
using IntegerTag = hn::RebindToSigned<FloatTag>;
using Lanes = hn::Vec<FloatTag>;

constexpr FloatTag kD;

// With u = 2^-24. A coordinate relative to the eye rounds by u of it, a coordinate of an axis by u, their product by u, and
// the sum of three products twice. With axes of length 1 that is 5 u of the sum of the coordinates. One more u is for
// second-order terms.
constexpr float kSeenError = 6 * 0x1p-24F;
// A quotient rounds twice; the scale, its product and the sum round once each: 5 u of a position. Subtracting the bound and
// the margin, and adding 1 to find the pixel, round by 3 u of the sum of position, bound and margin. The bound is below
// kMostError, and kBoundRounded accounts for its share. That is 8 u; the constant is 16 u.
constexpr float kPlaceError = 0x1p-20F;
// It allows for 16 roundings. The bound of a distance, times this, rounds seven times: the coordinates once, their sum
// twice, its product once, BoxPicture::moved once, the sum of these once, and the product with this factor once. The bound
// of a position, times this again, rounds twelve times more: how far aside it is four times, the sum with the scale once,
// the distance that divides once, the quotient, its product and the product with this factor once each, the sum of both
// terms once, and the two sums in which it is used once each.
constexpr float kBoundRounded = 1 + 0x1p-20F;
// How far eyes reach is a sum of four products, each with two roundings, of numbers that are rounded once: 7 u of their
// sum, for which there is a bound of twice its size. That of a ball is a root, whose square rounds no more, times a radius
// that is rounded by 2 u. The difference of two nearnesses rounds by 3 u of them.
constexpr float kReachRounded = 0x1p-21F;
// A box with a larger error, in pixels, is treated as one of unknown position.
constexpr float kMostError = 0x1p20F;

/// The least and the largest value over the corners of a box.
struct Range {
  Lanes low, high;

  HWY_INLINE void hold(Lanes x) {
    low = hn::Min(low, x);
    high = hn::Max(high, x);
  }
};

/// The coordinates of the eight corners along an axis of the picture.
struct Corners {
  HWY_INLINE Corners(const std::array<float, 3>& axis, const Lanes* low, const Lanes* high) {
    const Lanes x = hn::Set(kD, axis[0]), y = hn::Set(kD, axis[1]), z = hn::Set(kD, axis[2]);
    const Lanes x0 = hn::Mul(x, low[0]), x1 = hn::Mul(x, high[0]), y0 = hn::Mul(y, low[1]), y1 = hn::Mul(y, high[1]);
    const Lanes z0 = hn::Mul(z, low[2]), z1 = hn::Mul(z, high[2]);
    const Lanes xy[4] = {hn::Add(x0, y0), hn::Add(x1, y0), hn::Add(x0, y1), hn::Add(x1, y1)};
    for (int i = 0; i < 4; ++i) {
      at[i] = hn::Add(xy[i], z0);
      at[i + 4] = hn::Add(xy[i], z1);
    }
  }
  Lanes at[8];
};

HWY_INLINE Lanes larger_than(Lanes x, float share) { return hn::Add(x, hn::Mul(hn::Abs(x), hn::Set(kD, share))); }

/// Does what pixel_at() does.
HWY_INLINE hn::Vec<IntegerTag> pixel(Lanes x, float count) {
  const Lanes one = hn::Set(kD, 1.0F);
  const Lanes within = hn::Min(hn::Max(x, hn::Set(kD, -1.0F)), hn::Set(kD, count));
  return hn::Sub(hn::ConvertTo(IntegerTag(), hn::Add(within, one)), hn::Set(IntegerTag(), 1));
}

/// Stores the pixels that are between these positions and no farther from them than the error and the margin.
HWY_INLINE void store_pixels(const BoxPicture& p, const Range& x, const Range& y, BoxPixels& boxes, std::size_t i) {
  const IntegerTag di;
  const Lanes wider_x = hn::Set(kD, p.wider_x), wider_y = hn::Set(kD, p.wider_y);
  const auto next = hn::Set(di, 1);
  hn::StoreU(pixel(hn::Sub(x.low, wider_x), p.width), di, &boxes.x0[i]);
  hn::StoreU(pixel(hn::Sub(y.low, wider_y), p.height), di, &boxes.y0[i]);
  hn::StoreU(hn::Add(pixel(hn::Add(x.high, wider_x), p.width), next), di, &boxes.x1[i]);
  hn::StoreU(hn::Add(pixel(hn::Add(y.high, wider_y), p.height), next), di, &boxes.y1[i]);
}

/// Two layers and their numbers: the nearest whose focus is not nearer than a nearness, and the farthest whose focus is.
struct Bracket {
  Lanes far_focus, near_focus, far_layer, near_layer;
};

HWY_INLINE Bracket bracket_of(const FocusLayers& layers, Lanes nearness) {
  const std::size_t last = layers.count - 1;
  Bracket b{hn::Set(kD, layers.focus[0]), hn::Set(kD, layers.focus[last]), hn::Zero(kD),
            hn::Set(kD, static_cast<float>(last))};
  // From near to far, so that near_focus is the least that is nearer.
  for (std::size_t k = layers.count; k-- > 0;) {
    const Lanes focus = hn::Set(kD, layers.focus[k]), layer = hn::Set(kD, static_cast<float>(k));
    const auto is_nearer = hn::Gt(focus, nearness);
    b.near_focus = hn::IfThenElse(is_nearer, focus, b.near_focus);
    b.near_layer = hn::IfThenElse(is_nearer, layer, b.near_layer);
  }
  for (std::size_t k = 0; k < layers.count; ++k) {
    const Lanes focus = hn::Set(kD, layers.focus[k]), layer = hn::Set(kD, static_cast<float>(k));
    const auto is_beyond = hn::Le(focus, nearness);
    b.far_focus = hn::IfThenElse(is_beyond, focus, b.far_focus);
    b.far_layer = hn::IfThenElse(is_beyond, layer, b.far_layer);
  }
  return b;
}

/// How far the eyes reach along (1, 0, -slope) or (0, 1, -slope) in the axes of the picture.
HWY_INLINE Lanes reach_of(const BoxPicture& p, std::size_t axis, Lanes slope) {
  const std::array<float, 3>& ball = axis == 0 ? p.right_of_ball : p.up_of_ball;
  const Lanes at_middle = hn::Set(kD, ball[0]), once = hn::Mul(slope, hn::Set(kD, ball[1])),
              twice = hn::Mul(hn::Mul(slope, slope), hn::Set(kD, ball[2]));
  const Lanes size = hn::Add(hn::Add(at_middle, hn::Abs(once)), twice);
  const Lanes square = hn::Add(hn::Add(hn::Add(at_middle, once), twice), hn::Mul(size, hn::Set(kD, kReachRounded)));
  Lanes reach = hn::Mul(hn::Set(kD, p.radius), hn::Sqrt(hn::Max(square, hn::Zero(kD))));
  for (const std::array<float, 3>& h : p.half_edges) {
    reach = hn::Add(reach, hn::Abs(hn::Sub(hn::Set(kD, h[axis]), hn::Mul(slope, hn::Set(kD, h[2])))));
  }
  return hn::Add(reach, hn::Mul(hn::Set(kD, kReachRounded * p.eyes_reach), hn::Add(hn::Set(kD, 1.0F), hn::Abs(slope))));
}

/// Where the boxes are in the layer with this focus: each corner is moved by the eyes. `error` is that of the positions
/// from the middle of the eyes. Long, and asked twice: to inline it took compilers a minute under sanitizers, and saved
/// nothing.
HWY_NOINLINE void store_layer(const BoxPicture& p, const Corners& right, const Corners& up, const Corners& forward,
                              Lanes moved, Lanes error, Lanes focus, Lanes layer, BoxPixels& boxes, std::size_t i) {
  const Lanes one = hn::Set(kD, 1.0F), infinity = hn::Inf(kD), ahead = hn::Set(kD, p.eyes_forward);
  Range x{infinity, hn::Neg(infinity)}, y = x;
  Lanes most_share = hn::Zero(kD);
  for (int c = 0; c < 8; ++c) {
    const Lanes shrink = hn::Div(one, forward.at[c]);
    const Lanes slope_x = hn::Mul(right.at[c], shrink), slope_y = hn::Mul(up.at[c], shrink);
    const Lanes nearest = hn::Sub(forward.at[c], moved), nearness = hn::Div(one, nearest);
    // The nearness is between that and less by 2 moved / nearest of itself.
    const Lanes inexact = hn::Add(hn::Mul(nearness, hn::Mul(hn::Set(kD, 2.0F), hn::Mul(moved, nearness))),
                                  hn::Mul(hn::Add(nearness, focus), hn::Set(kD, kReachRounded)));
    const Lanes share = hn::Mul(hn::Mul(hn::Add(hn::Abs(hn::Sub(focus, nearness)), inexact), hn::Set(kD, kBoundRounded)),
                                hn::Div(nearest, hn::Sub(nearest, ahead)));
    most_share = hn::Max(most_share, share);
    const Lanes move_x = hn::Mul(share, reach_of(p, 0, slope_x)), move_y = hn::Mul(share, reach_of(p, 1, slope_y));
    x.hold(hn::Sub(slope_x, move_x));
    x.hold(hn::Add(slope_x, move_x));
    y.hold(hn::Sub(slope_y, move_y));
    y.hold(hn::Add(slope_y, move_y));
  }
  const Lanes wider = hn::Mul(error, hn::Add(hn::Set(kD, kBoundRounded), hn::Mul(most_share, ahead)));
  const auto place = [&](const Range& range, float scale, float middle) {
    const Lanes low = hn::Mul(range.low, hn::Set(kD, scale)), high = hn::Mul(range.high, hn::Set(kD, scale));
    const Lanes rounded =
        hn::Mul(hn::Add(hn::Max(hn::Abs(low), hn::Abs(high)), hn::Set(kD, p.width + p.height)), hn::Set(kD, kPlaceError));
    const Lanes all = hn::Add(wider, rounded), at = hn::Set(kD, middle);
    return Range{hn::Sub(hn::Add(at, low), all), hn::Add(hn::Add(at, high), all)};
  };
  store_pixels(p, place(x, p.scale_x, p.middle_x), place(y, p.scale_y, p.middle_y), boxes, i);
  const IntegerTag di;
  hn::StoreU(hn::Mul(hn::ConvertTo(di, layer), hn::Set(di, p.tiles_of_layer)), di, &boxes.first_tile[i]);
}

template <bool is_perspective>
HWY_INLINE void project_lanes(const BoxPicture& p, ProjectedBoxes& boxes, std::size_t i) {
  const Lanes zero = hn::Zero(kD), one = hn::Set(kD, 1.0F), infinity = hn::Inf(kD);
  Lanes low[3], high[3];
  Lanes sum = zero, squared = zero;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    low[axis] = hn::Load(kD, &boxes.low[axis][i]);
    high[axis] = hn::Load(kD, &boxes.high[axis][i]);
    sum = hn::Add(sum, hn::Max(hn::Abs(low[axis]), hn::Abs(high[axis])));
    const Lanes outside = hn::Max(hn::Max(low[axis], hn::Neg(high[axis])), zero);
    squared = hn::Add(squared, hn::Mul(outside, outside));
  }
  const Corners forward(p.forward, low, high), right(p.right, low, high), up(p.up, low, high);
  Lanes nearest = forward.at[0];
  for (int c = 1; c < 8; ++c) nearest = hn::Min(nearest, forward.at[c]);
  Range x{infinity, hn::Neg(infinity)}, y = x;
  for (int c = 0; c < 8; ++c) {
    if constexpr (is_perspective) {
      const Lanes shrink = hn::Div(one, forward.at[c]);
      x.hold(hn::Mul(right.at[c], shrink));
      y.hold(hn::Mul(up.at[c], shrink));
    } else {
      x.hold(right.at[c]);
      y.hold(up.at[c]);
    }
  }
  const Lanes scale_x = hn::Set(kD, p.scale_x), scale_y = hn::Set(kD, p.scale_y);
  x = {hn::Mul(x.low, scale_x), hn::Mul(x.high, scale_x)};
  y = {hn::Mul(y.low, scale_y), hn::Mul(y.high, scale_y)};

  // As ConservativeViewport::place_error(): the error is larger for what is nearer and for what is farther aside.
  const Lanes moved =
      hn::Mul(hn::Add(hn::Mul(sum, hn::Set(kD, kSeenError)), hn::Set(kD, p.moved)), hn::Set(kD, kBoundRounded));
  const Lanes least = hn::Sub(nearest, moved);
  const Lanes aside = hn::Max(hn::Max(hn::Abs(x.low), hn::Abs(x.high)), hn::Max(hn::Abs(y.low), hn::Abs(y.high)));
  const Lanes scale = hn::Max(scale_x, scale_y);
  const Lanes shifted = is_perspective ? hn::Mul(hn::Add(scale, aside), hn::Div(moved, least)) : hn::Mul(scale, moved);
  const Lanes error = hn::Add(hn::Mul(shifted, hn::Set(kD, kBoundRounded)),
                              hn::Mul(hn::Add(aside, hn::Set(kD, p.width + p.height)), hn::Set(kD, kPlaceError)));
  const Lanes middle_x = hn::Set(kD, p.middle_x), middle_y = hn::Set(kD, p.middle_y);
  const Lanes low_x = hn::Sub(hn::Add(middle_x, x.low), error), high_x = hn::Add(hn::Add(middle_x, x.high), error);
  const Lanes low_y = hn::Sub(hn::Add(middle_y, y.low), error), high_y = hn::Add(hn::Add(middle_y, y.high), error);
  hn::StoreU(low_x, kD, &boxes.low_x[i]);
  hn::StoreU(low_y, kD, &boxes.low_y[i]);
  hn::StoreU(high_x, kD, &boxes.high_x[i]);
  hn::StoreU(high_y, kD, &boxes.high_y[i]);

  // False if one of them is NaN.
  const auto is_known = hn::And(hn::Gt(least, hn::Set(kD, p.near)), hn::Lt(error, hn::Set(kD, kMostError)));
  const Lanes nearness = is_perspective ? hn::Div(one, least) : hn::Neg(least);
  const Lanes most = hn::IfThenElse(is_known, larger_than(nearness, 0x1p-21F), infinity);
  hn::StoreU(most, kD, &boxes.most[i]);
  hn::StoreU(is_perspective ? squared : nearest, kD, &boxes.distance[i]);
  if (!is_perspective || !p.is_of_region) return store_pixels(p, {low_x, high_x}, {low_y, high_y}, boxes, i);
  const Bracket bracket = bracket_of(p.layers, most);
  store_layer(p, right, up, forward, moved, error, bracket.far_focus, bracket.far_layer, boxes, i);
  store_layer(p, right, up, forward, moved, error, bracket.near_focus, bracket.near_layer, boxes.nearer_layer, i);
  hn::StoreU(most, kD, &boxes.nearer_layer.most[i]);
  boxes.nearer_layer.size = boxes.size;
}

HWY_INLINE void take(const BoxPicture& picture, const kernel::BoxBlock& block, ProjectedBoxes& boxes) {
  const hn::CappedTag<double, ProjectedBoxes::kMost> d;
  const hn::Rebind<float, decltype(d)> to;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto eye = hn::Set(d, picture.eye[static_cast<int>(axis)]);
    for (std::size_t i = 0; i < ProjectedBoxes::kMost; i += hn::Lanes(d)) {
      hn::StoreU(hn::DemoteTo(to, hn::Sub(hn::Load(d, &block.min[axis][i]), eye)), to, &boxes.low[axis][i]);
      hn::StoreU(hn::DemoteTo(to, hn::Sub(hn::Load(d, &block.max[axis][i]), eye)), to, &boxes.high[axis][i]);
    }
  }
}

void project(const BoxPicture& picture, ProjectedBoxes& boxes) {
  for (std::size_t i = 0; i < boxes.size; i += hn::Lanes(kD)) {
    if (picture.is_perspective) {
      project_lanes<true>(picture, boxes, i);
    } else {
      project_lanes<false>(picture, boxes, i);
    }
  }
}

void project_block(const BoxPicture& picture, const kernel::BoxBlock& block, ProjectedBoxes& boxes) {
  take(picture, block, boxes);
  HWY_NAMESPACE::project(picture, boxes);
}

}  // namespace HWY_NAMESPACE
}  // namespace
}  // namespace occlude::culler
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
#include "base/rounded_float.h"
#include "cover/cover_tile.h"

namespace occlude::culler {
namespace {
HWY_EXPORT(project);
HWY_EXPORT(project_block);

/// Floats below 2^-126 round by 2^-150 whatever their size. Three coordinates, three products with an axis, the sum of the
/// coordinates times its factor, and this bound itself do so: 8 of these. Twice that leaves room.
constexpr double kUnderflow = 16 * 0x1p-150;

std::array<float, 3> to_floats(const glm::dvec3& v) {
  return {static_cast<float>(v.x), static_cast<float>(v.y), static_cast<float>(v.z)};
}
}  // namespace

BoxPicture::BoxPicture(const ConservativeViewport& picture, const PixelPosition& margin, const FocusLayers& in_focus)
    : eye(picture.eye()),
      is_perspective(picture.is_perspective()),
      right(to_floats(picture.right())),
      up(to_floats(picture.up())),
      forward(to_floats(picture.forward())),
      middle_x(static_cast<float>(picture.middle().x)),
      middle_y(static_cast<float>(picture.middle().y)),
      scale_x(static_cast<float>(picture.scale().x)),
      scale_y(static_cast<float>(picture.scale().y)),
      width(static_cast<float>(picture.width())),
      height(static_cast<float>(picture.height())),
      near(rounded_up(picture.near())),
      moved(static_cast<float>(picture.error() + picture.rounding() + kUnderflow)),
      wider_x(rounded_up(margin.x)),
      wider_y(rounded_up(margin.y)),
      is_of_region(picture.is_of_region()),
      radius(rounded_up(picture.eyes().radius)),
      eyes_forward(rounded_up(picture.eyes_forward())),
      eyes_reach(rounded_up(2 * (picture.reach({1, 0, 0}) + picture.reach({0, 1, 0}) + picture.reach({0, 0, 1})))),
      layers(in_focus),
      tiles_of_layer(picture.width() / kTile * (picture.height() / kTile)) {
  const EyeRegion& eyes = picture.eyes();
  for (std::size_t i = 0; i < half_edges.size(); ++i) {
    const glm::dvec3& h = eyes.half_edges[i];
    half_edges[i] = to_floats({glm::dot(h, picture.right()), glm::dot(h, picture.up()), glm::dot(h, picture.forward())});
  }
  const auto of_ball = [&](const glm::dvec3& axis) {
    const glm::dvec3& along = picture.forward();
    return to_floats({glm::dot(axis, axis), -2 * glm::dot(axis, along), glm::dot(along, along)});
  };
  right_of_ball = of_ball(picture.right());
  up_of_ball = of_ball(picture.up());
}

void ProjectedBoxes::project(const BoxPicture& picture) {
  // Lanes without a box are projected, too.
  for (auto* const side : {&low, &high}) {
    for (Floats& axis : *side) std::fill(axis.begin() + static_cast<std::ptrdiff_t>(size), axis.end(), 0.0F);
  }
  HWY_DYNAMIC_DISPATCH(project)(picture, *this);
}

void ProjectedBoxes::project(const BoxPicture& picture, const kernel::BoxBlock& block) {
  size = kMost;
  HWY_DYNAMIC_DISPATCH(project_block)(picture, block, *this);
}

}  // namespace occlude::culler
#endif
