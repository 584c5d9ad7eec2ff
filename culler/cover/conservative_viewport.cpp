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
      near_distance_(view.near_distance) {
  right_ = view.axes.right;
  up_ = view.axes.up;
  forward_ = view.axes.forward;
  if (!is_perspective_) {
    // Where `up` is nearly parallel to the line of sight, cancellation leaves `right` not quite perpendicular to it.
    right_ -= glm::dot(right_, forward_) * forward_;
    up_ -= glm::dot(up_, forward_) * forward_;
  }
  scale_ = {(middle_.x - size.border) / view.half_width, (middle_.y - size.border) / view.half_height};
}

EyePoint ConservativeViewport::cut(const EyePoint& a, const EyePoint& b) const {
  const double share = (near_ - a.forward) / (b.forward - a.forward);
  return {a.right + share * (b.right - a.right), a.up + share * (b.up - a.up), near_};
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
