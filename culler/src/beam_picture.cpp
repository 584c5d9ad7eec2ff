// SPDX-License-Identifier: MIT
#include "beam_picture.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <limits>

namespace occlude::culler {
namespace {

/// In units of 2^-53 of the depth. The difference of two coordinates rounds once, its product with an axis once, and the sum
/// of the products twice. The terms together are no larger than the depth, so that is 4; the axes are a little longer than
/// 1. A cut adds the roundings of a difference of two such numbers, of a product and of a sum: 5 more. The forward
/// coordinate of a cut differs from near() by no more than that. Parallel rays run along `forward`, to which the other axes
/// are perpendicular up to a few roundings: 2 more. That is 11 in all; the constant is 16.
constexpr double kSeenError = 0x1p-49;

}  // namespace

BeamPicture::BeamPicture(const FrameView& view, const Size& size, double rounding)
    : eye_(view.eye),
      is_perspective_(view.is_perspective),
      width_(size.width),
      height_(size.height),
      middle_{size.width / 2.0, size.height / 2.0},
      depth_(view.depth),
      near_(view.near),
      error_(kSeenError * view.depth),
      rounding_(rounding + view.moved),
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

Seen BeamPicture::cut(const Seen& a, const Seen& b) const {
  const double share = (near_ - a.forward) / (b.forward - a.forward);
  return {a.right + share * (b.right - a.right), a.up + share * (b.up - a.up), near_};
}

double BeamPicture::area(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) const {
  const glm::dvec3 from_eye = a - eye_, normal = glm::cross(b - a, c - a);
  const auto forward = [&](const glm::dvec3& point) { return glm::dot(point - eye_, forward_); };
  const double p = forward(a), q = forward(b), r = forward(c);
  if (std::min({p, q, r}) < near_) return std::numeric_limits<double>::infinity();
  const double doubled = is_perspective_ ? glm::dot(normal, from_eye) / (p * q * r) : glm::dot(normal, forward_);
  return std::fabs(doubled * scale_.x * scale_.y) / 2;
}

}  // namespace occlude::culler
