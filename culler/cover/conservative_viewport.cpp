// SPDX-License-Identifier: MIT
#include "cover/conservative_viewport.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>

namespace occlude::culler {
namespace {

/// In units of 2^-53 of the depth. The difference of two coordinates rounds once, its product with an axis once, and the sum
/// of the products twice. The terms together are no larger than the depth, so that is 4; the axes are a little longer than
/// 1. A cut adds the roundings of a difference of two such numbers, of a product and of a sum: 5 more. The forward
/// coordinate of a cut differs from near() by no more than that. Parallel rays run along `forward`, to which the other axes
/// are perpendicular up to a few roundings: 2 more. That is 11 in all; the constant is 16.
constexpr double kSeenError = 0x1p-49;
/// In units of 2^-53 of the lengths that are added, a corner of a swept edge rounds by fewer than 64: its direction and
/// length by 8, the moves by 4 and the line over them by 16, each of which is added once along and once across.
constexpr double kSweptError = 0x1p-46;

/// The part of an edge that is no more than `reach` from the middle of the picture, across and up: the nearness of its
/// nearest point. None if there is no such part. Finding where the edge enters and leaves rounds by a few 2^-53 of its
/// length, and so the nearness by as much of that of the ends.
std::optional<double> nearness_within(const PixelPosition& a, const PixelPosition& b, double nearness_a, double nearness_b,
                                      const PixelPosition& reach) {
  double enters = 0, leaves = 1;
  const auto clip = [&](double from, double to, double most) {
    for (const double side : {-1.0, 1.0}) {
      const double here = most - side * from, there = most - side * to;  // negative: beyond the side
      if (here < 0 && there < 0) return false;
      if (here < 0) enters = std::max(enters, here / (here - there));
      if (there < 0) leaves = std::min(leaves, here / (here - there));
    }
    return true;
  };
  constexpr double kRounded = 0x1p-48;
  if (!clip(a.x, b.x, reach.x) || !clip(a.y, b.y, reach.y) || enters > leaves + kRounded) return std::nullopt;
  const auto at = [&](double share) { return nearness_a + share * (nearness_b - nearness_a); };
  return std::max(at(enters), at(leaves)) + kRounded * std::max(nearness_a, nearness_b);
}

}  // namespace

ConservativeViewport::ConservativeViewport(const FrameView& view, const Size& size, double rounding)
    : eye_(view.eye),
      is_perspective_(view.is_perspective),
      width_(size.width),
      height_(size.height),
      middle_{size.width / 2.0, size.height / 2.0},
      depth_(view.depth),
      near_(view.near),
      error_(kSeenError * view.depth),
      rounding_(rounding + view.eye_uncertainty),
      moved_(error_ + rounding_),
      is_oblique_(view.is_oblique),
      near_normal_(view.near_normal),
      near_distance_(view.near_distance),
      eyes_(view.eyes),
      is_of_region_(!view.eyes.is_point()) {
  right_ = view.axes.right;
  up_ = view.axes.up;
  forward_ = view.axes.forward;
  if (!is_perspective_) {
    // Where `up` is nearly parallel to the line of sight, cancellation leaves `right` not quite perpendicular to it.
    right_ -= glm::dot(right_, forward_) * forward_;
    up_ -= glm::dot(up_, forward_) * forward_;
  }
  eyes_forward_ = reach({0, 0, 1});
  eyes_aside_ = std::max(reach({1, 0, 0}), reach({0, 1, 0}));
  eye_moves_ = EyeMoves(eyes_, {right_, up_, forward_});
  scale_ = {(middle_.x - size.border) / view.half_width, (middle_.y - size.border) / view.half_height};
}

EyePoint ConservativeViewport::cut(const EyePoint& a, const EyePoint& b) const {
  const double share = (near_ - a.forward) / (b.forward - a.forward);
  return {a.right + share * (b.right - a.right), a.up + share * (b.up - a.up), near_};
}

/// Along a direction in the picture, in pixels.
EyeMoves::Range ConservativeViewport::moves(const PixelPosition& direction, const BoundedPosition& position) const {
  const PixelPosition at = slope(position.place.x, position.place.y);
  return eye_moves_.along(direction.x * scale_.x, direction.y * scale_.y, at.x, at.y, 1 / position.forward);
}

/// Seen from an eye e, a point that is off by a distance m is off by m (1 + |s|) / (g - m) in the slope s of its ray, where
/// g is how far it is from e along the line of sight: as place_error(). The ray has the position f e.xy + s (1 - f e.z). So
/// its slope is no more than what that position and f e.xy are aside, over 1 - f e.z. The bound grows with f, and with f -
/// k, which is no larger than the nearness k or most_focus().
double ConservativeViewport::moved_error(const MovingPosition& position) const {
  const double focus = most_focus(), ahead = focus * eyes_forward_, forward = position.still.forward;
  const double scale = std::max(scale_.x, scale_.y), share = std::max(position.nearness, focus);
  const auto from_middle = [&](double place, double middle, const EyeMoves::Range& moves) {
    return std::fabs(place - middle) + share * std::max(-moves.low, moves.high);
  };
  const double aside = std::max(from_middle(position.still.place.x, middle_.x, position.x),
                                from_middle(position.still.place.y, middle_.y, position.y));
  const double of_eyes = focus * eyes_aside_ * scale, from_eyes = forward - eyes_forward_;
  const double moved = (1 + ahead) * (scale + (aside + of_eyes) / (1 - ahead)) * (moved_ / (from_eyes - moved_));
  // Moves round by up to 2^-46 of their terms. These may exceed what is aside by as much as the point is farther from the
  // middle of the eyes than from the nearest one.
  return kBoundRounded * moved + kPlaceError * (forward / from_eyes) * (aside + scale + of_eyes + width_ + height_);
}

/// What passes the plane of the first focus at a place is moved as a point there. The moves round by up to 2^-46 of their
/// terms; the slope, the difference of the two and their product add a few 2^-53.
EyeMoves::Range ConservativeViewport::ray_moves(const PixelPosition& direction, const PixelPosition& place, double from,
                                                double to) const {
  const PixelPosition at = slope(place.x, place.y);
  const EyeMoves::Range moves =
      eye_moves_.along(direction.x * scale_.x, direction.y * scale_.y, at.x, at.y, from).times(to - from);
  const double aside = std::max(std::fabs(at.x), std::fabs(at.y));
  const double terms = std::max(scale_.x, scale_.y) * (eyes_aside_ + aside * eyes_forward_) / (1 - from * eyes_forward_);
  const double rounding = 0x1p-40 * std::fabs(to - from) * terms;
  return {moves.low - rounding, moves.high + rounding};
}

MovingPosition ConservativeViewport::moving(const EyePoint& seen) const {
  MovingPosition position{corner(seen), 1 / seen.forward, {}, {}};
  position.x = moves({1, 0}, position.still);
  position.y = moves({0, 1}, position.still);
  position.still.error = moved_error(position);
  return position;
}

MovingEdge ConservativeViewport::moving(const BoundedPosition& from, const BoundedPosition& to) const {
  const double x = to.place.x - from.place.x, y = to.place.y - from.place.y, length = std::sqrt(x * x + y * y);
  const PixelPosition along = length > 0 ? PixelPosition{x / length, y / length} : PixelPosition{1, 0};
  const PixelPosition across{-along.y, along.x};
  return {along, length, {moves(along, from), moves(across, from)}, {moves(along, to), moves(across, to)}};
}

namespace {

/// A straight line over two intervals, at least as high as the first one's number over the first and the second one's over
/// the second.
class LineOver {
 public:
  struct Step {
    EyeMoves::Range at;
    double height;
  };
  LineOver(const Step& a, const Step& b) : height_(std::max(a.height, b.height)) {
    const Step &high = a.height >= b.height ? a : b, &low = a.height >= b.height ? b : a;
    const bool falls = low.at.high > high.at.high, rises = low.at.low < high.at.low;
    if (falls == rises) return;
    from_ = falls ? high.at.high : high.at.low;
    slope_ = (low.height - high.height) / (falls ? low.at.high - from_ : low.at.low - from_);
  }
  [[nodiscard]] double at(double t) const { return height_ + slope_ * (t - from_); }

 private:
  double height_, from_ = 0, slope_ = 0;
};

}  // namespace

/// From each eye the edge is straight. So it lies in the convex hull of what its ends may be: each end is in a rectangle
/// along the edge. Where the edge is short the ends may pass each other. The sides of the quadrangle lead past both
/// rectangles.
SweptEdge ConservativeViewport::swept(const MovingEdge& edge, const BoundedPosition& from, const BoundedPosition& to,
                                      double focus) const {
  const double of_from = focus - 1 / from.forward, of_to = focus - 1 / to.forward;
  const EyeMoves::Range from_along = edge.from.along.times(of_from), from_across = edge.from.across.times(of_from);
  const EyeMoves::Range past_end = edge.to.along.times(of_to), to_across = edge.to.across.times(of_to);
  const EyeMoves::Range to_along{edge.length + past_end.low, edge.length + past_end.high};
  const double begin = std::min(from_along.low, to_along.low), end = std::max(from_along.high, to_along.high);
  const LineOver above({from_along, from_across.high}, {to_along, to_across.high});
  const LineOver below({from_along, -from_across.low}, {to_along, -to_across.low});
  const PixelPosition& direction = edge.direction;
  const auto at = [&](double t, double side) {
    return PixelPosition{from.place.x + t * direction.x - side * direction.y,
                         from.place.y + t * direction.y + side * direction.x};
  };
  const std::array<double, 4> sides{-below.at(begin), -below.at(end), above.at(end), above.at(begin)};
  double size = std::fabs(from.place.x) + std::fabs(from.place.y) + edge.length + std::fabs(begin) + std::fabs(end);
  for (const double side : sides) size += std::fabs(side);
  return {{at(begin, sides[0]), at(end, sides[1]), at(end, sides[2]), at(begin, sides[3])},
          std::max(from.error, to.error) + kSweptError * size};
}

/// Each end is within its own error of where it was found, so that no position of the edge is farther from the edge that was
/// found than the larger error. Here is a bound that depends on what is in the picture. Take points of both edges that
/// divide them in the same ratio in space. Their coordinates differ by no more than those of the ends. So place_error()
/// bounds how far their positions are apart: with f the distance along the line of sight where the point was found, it is
/// (scale + aside) r, where r = moved / (f - moved), and a rounding that both ends bound. Along the edge, 1 / f is linear in
/// the picture.
///  - A position that was found A from the middle is off by no more than (scale + A) r + rounding, r that of the nearer end.
///    Where r < 1, this is less than A - half from (half + scale r + rounding) / (1 - r) on: what was found to be farther
///    aside is not in the picture.
///  - What was found to be farther from the picture than a bound of this kind is not in it either.
/// Each bound leaves a shorter part of the edge, and so gives a smaller one. Three leave a few pixels.
double ConservativeViewport::error_in_picture(const BoundedPosition& a, const BoundedPosition& b) const {
  const double most = std::max(a.error, b.error), nearest = std::min(a.forward, b.forward);
  const auto share_at = [&](double forward) { return kBoundRounded * (moved_ / (forward - moved_)); };
  if (!is_perspective_ || !(nearest > moved_) || !(share_at(nearest) < 1)) return most;
  const auto from_middle = [&](const BoundedPosition& c) {
    return PixelPosition{c.place.x - middle_.x, c.place.y - middle_.y};
  };
  const PixelPosition from = from_middle(a), to = from_middle(b);
  const double aside = std::max({std::fabs(from.x), std::fabs(from.y), std::fabs(to.x), std::fabs(to.y)});
  const double scale = std::max(scale_.x, scale_.y), rounding = kPlaceError * (aside + width_ + height_);
  const double half = std::max(middle_.x, middle_.y), share = share_at(nearest);
  const double beside = kBoundRounded * (half + scale * share + rounding) / (1 - share);
  PixelPosition reach{beside, beside};
  double error = std::numeric_limits<double>::infinity();
  for (int bound = 0; bound < 3; ++bound) {
    const auto nearness = nearness_within(from, to, 1 / a.forward, 1 / b.forward, reach);
    if (!nearness) return std::min(most, rounding);
    const double farther_than = 1 / *nearness;
    if (!(farther_than > moved_)) break;
    error = std::min(error, kBoundRounded * (scale + std::max(reach.x, reach.y)) * share_at(farther_than) + rounding);
    reach = {std::min(reach.x, middle_.x + error), std::min(reach.y, middle_.y + error)};
  }
  return std::min(most, error);
}

double ConservativeViewport::area(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) const {
  const glm::dvec3 from_eye = a - eye_, normal = glm::cross(b - a, c - a);
  const auto forward = [&](const glm::dvec3& point) { return glm::dot(point - eye_, forward_); };
  const double p = forward(a), q = forward(b), r = forward(c);
  if (std::min({p, q, r}) < near_) return std::numeric_limits<double>::infinity();
  const double doubled = is_perspective_ ? glm::dot(normal, from_eye) / (p * q * r) : glm::dot(normal, forward_);
  return std::fabs(doubled * scale_.x * scale_.y) / 2;
}

}  // namespace occlude::culler
