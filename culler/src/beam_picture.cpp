// SPDX-License-Identifier: MIT
#include "beam_picture.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "single_precision.h"

namespace occlude::culler {
namespace {

/// In units of 2^-53: a difference of coordinates rounds once, its product with an axis once and the sum twice, of terms
/// that are no more than the depth together: 4, and the axes are a little longer than 1. A cut adds the rounding of a
/// difference of two such numbers, of a product and of a sum: 5 more, and what its forward is off near() by is as little.
/// Parallel rays run along `forward`, which the other axes are across up to a few roundings: 2 more. 11 in all, of 16.
constexpr double kSeenError = 0x1p-49;

/// Four roundings of a place, and as much again for what rounds where the place is used.
constexpr double kPlaceError = 0x1p-50;

/// A bound of a few roundings is out by less than this share of it.
constexpr double kBoundRounded = 1 + 0x1p-40;

int pixel(double x, int count) { return static_cast<int>(std::clamp(std::floor(x), -1.0, static_cast<double>(count))); }

}  // namespace

BeamPicture::BeamPicture(const Camera& camera, double depth, const Size& size, double rounding)
    : eye_(camera.eye),
      is_perspective_(camera.projection == Projection::perspective),
      width_(size.width),
      height_(size.height),
      middle_{size.width / 2.0, size.height / 2.0},
      depth_(depth),
      near_(camera.near + kDepthMargin * depth),
      error_(kSeenError * depth),
      rounding_(rounding) {
  const auto [right, up, forward] = camera.axes();
  right_ = right;
  up_ = up;
  forward_ = forward;
  const double half = is_perspective_ ? std::tan(glm::radians(camera.fov_y_deg) / 2) : camera.height / 2;
  scale_ = {(middle_.x - size.border) / (half * camera.aspect), (middle_.y - size.border) / half};
}

Seen BeamPicture::see(const glm::dvec3& point) const {
  const glm::dvec3 y = point - eye_;
  return {glm::dot(right_, y), glm::dot(up_, y), glm::dot(forward_, y)};
}

Seen BeamPicture::cut(const Seen& a, const Seen& b) const {
  const double share = (near_ - a.forward) / (b.forward - a.forward);
  return {a.right + share * (b.right - a.right), a.up + share * (b.up - a.up), near_};
}

Place BeamPicture::place(const Seen& seen) const {
  const double shrink = is_perspective_ ? 1 / seen.forward : 1;
  return {middle_.x + scale_.x * (seen.right * shrink), middle_.y + scale_.y * (seen.up * shrink)};
}

Place BeamPicture::slope(double x, double y) const { return {(x - middle_.x) / scale_.x, (y - middle_.y) / scale_.y}; }

/// With r and f the coordinates as computed, s and g as they are, both out by e: r / f - s / g is
/// ((r - s) f - r (f - g)) / (f g), at most e (1 + |r / f|) / (f - e).
double BeamPicture::place_error(const Place& place, double forward) const {
  const double aside = std::max(std::fabs(place.x - middle_.x), std::fabs(place.y - middle_.y));
  const double scale = std::max(scale_.x, scale_.y), e = error_ + rounding_;
  const double moved = is_perspective_ ? (scale + aside) * (e / (forward - e)) : scale * e;
  return kBoundRounded * moved + kPlaceError * (aside + width_ + height_);
}

/// 1 / f - 1 / g is (g - f) / (f g).
double BeamPicture::nearness_error(double forward) const {
  const double e = error_ + rounding_;
  if (!is_perspective_) return kBoundRounded * e;
  return (kBoundRounded * (e / (forward - e)) + 0x1p-52) / forward;
}

PixelRectangle BeamPicture::pixels(const Place& low, const Place& high, double wider) const {
  return {pixel(low.x - wider, width_), pixel(low.y - wider, height_), pixel(high.x + wider, width_) + 1,
          pixel(high.y + wider, height_) + 1};
}

PixelRectangle BeamPicture::clipped(const PixelRectangle& r) const {
  return {std::max(r.x0, 0), std::max(r.y0, 0), std::min(r.x1, width_), std::min(r.y1, height_)};
}

}  // namespace occlude::culler
