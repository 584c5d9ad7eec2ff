// SPDX-License-Identifier: MIT
#include "picture_margin.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <variant>

#include "occlude/kernel/overlap.h"
#include "stored_frustum.h"

namespace occlude::fuzz {
namespace {

using Real = long double;
using Vector = glm::vec<3, Real>;

/// The share of a model's depth by which positions in single precision may be wrong, as in shadow_margin.h.
constexpr Real kSinglePrecision = 0x1p-21L;

/// The culler takes as the depth of a model the sum of the reaches of its box along the axes. A corner of the box is at most
/// sqrt(3) times as far away as the farthest vertex, and the sum is at most sqrt(3) times the distance of that corner.
constexpr Real kMostDepth = 3;

/// The culler's distances are in doubles, from planes in doubles. They are wrong by far less than this share of the model's
/// depth, which itself is far less than the error of single precision.
constexpr Real kDoubtful = 0x1p-24L;

Vector vector(const glm::dvec3& v) { return {v.x, v.y, v.z}; }
Vector vector(const kernel::Vec3& v) { return {v.x, v.y, v.z}; }

std::vector<Vector> corners_of(const kernel::Aabb& box) {
  std::vector<Vector> corners;
  for (unsigned i = 0; i < 8; ++i) {
    corners.emplace_back(i & 1U ? box.max.x : box.min.x, i & 2U ? box.max.y : box.min.y, i & 4U ? box.max.z : box.min.z);
  }
  return corners;
}

std::vector<Vector> corners_of(const kernel::Obb& box) {
  std::vector<Vector> corners;
  for (unsigned i = 0; i < 8; ++i) {
    Vector& corner = corners.emplace_back(vector(box.center));
    for (unsigned k = 0; k < 3; ++k) corner += (i >> k & 1U ? Real{1} : Real{-1}) * vector(box.half_edges[k]);
  }
  return corners;
}

std::vector<Vector> corners_of(const culler::Box& box) {
  return std::visit([](const auto& kind) { return corners_of(kind); }, box);
}

struct PlaneAndPoint {
  Vector normal;  ///< of length 1, towards the inner side
  Vector point;
};

PlaneAndPoint plane_of(const kernel::ExactPlane& laid) {
  const Vector a = vector(laid.a_to) - vector(laid.a_from), b = vector(laid.b_to) - vector(laid.b_from);
  const Vector normal = laid.direct ? a : glm::cross(a, b);
  return {normal / std::sqrt(glm::dot(normal, normal)), vector(laid.origin)};
}

kernel::Aabb point_box(const Vector& x) {
  const kernel::Vec3 p{static_cast<double>(x.x), static_cast<double>(x.y), static_cast<double>(x.z)};
  return {p, p};
}

Real height_at_1(const culler::Camera& camera) {
  if (camera.projection == culler::Projection::orthographic) return camera.height;
  return 2 * std::tan(static_cast<Real>(camera.fov_y_deg) * std::numbers::pi_v<Real> / 360);
}

}  // namespace

PictureMargin::PictureMargin(const culler::Camera& camera, double share, double farthest, Doubt doubt)
    : is_none_(share == 0),
      is_perspective_(camera.projection == culler::Projection::perspective),
      eye_(vector(camera.eye)),
      right_(vector(camera.axes().right)),
      up_(vector(camera.axes().up)),
      forward_(vector(camera.axes().forward)),
      size_(share * height_at_1(camera)),
      rounding_(kSinglePrecision * farthest * (doubt == Doubt::culls ? 1 : kMostDepth)),
      doubtful_(kDoubtful * farthest),
      doubt_(doubt) {}

Real PictureMargin::depth(const Vector& x) const { return is_perspective_ ? glm::dot(x - eye_, forward_) : 1; }

Real PictureMargin::move(const kernel::ShadowFrustum& shadow, Real depth) const {
  if (!is_perspective_) return size_ + rounding_;
  Real most = 0;
  for (const kernel::Vec3& v : shadow.silhouette()) {
    const Real along = this->depth(vector(v));
    if (along <= rounding_) return std::numeric_limits<Real>::infinity();
    most = std::max(most, glm::length(vector(v) - eye_) / (along * (along - rounding_)));
  }
  return (size_ + rounding_ * most) * depth;
}

Real PictureMargin::slack(const kernel::ShadowFrustum& shadow, const std::vector<Vector>& corners) const {
  Real least = std::numeric_limits<Real>::infinity();
  for (std::size_t i = 0; i < shadow.plane_count(); ++i) {
    const auto [normal, point] = plane_of(std::get<kernel::ExactPlane>(kernel::stored(shadow)->recipes[i]));
    const Vector across = glm::dot(normal, right_) * right_ + glm::dot(normal, up_) * up_;
    const Real length = std::sqrt(glm::dot(across, across));
    for (const Vector& corner : corners) {
      Vector moved = corner;
      if (length > 0) moved -= move(shadow, depth(corner)) / length * across;
      least = std::min(least, glm::dot(normal, moved - point) - 2 * rounding_);
    }
  }
  return least;
}

bool PictureMargin::keeps(const kernel::ShadowFrustum& shadow, const culler::Box& box) const {
  if (is_none_) return true;
  return slack(shadow, corners_of(box)) > (doubt_ == Doubt::culls ? -doubtful_ : doubtful_);
}

bool PictureMargin::keeps(const kernel::ShadowUnion& shadows, const culler::Box& box) const {
  if (is_none_) return true;
  if (doubt_ == Doubt::draws) return false;
  // The least that a sound culler may ask: corners moved in some directions, slightly less far than the culler moves them,
  // are in one of the shadows.
  constexpr int kDirections = 8;
  constexpr Real kSafely = 1 - 0x1p-20L;
  for (const Vector& corner : corners_of(box)) {
    const Real by = std::min(move(shadows.first, depth(corner)), move(shadows.second, depth(corner))) + 2 * rounding_;
    for (int i = 0; i < kDirections; ++i) {
      const Real angle = 2 * std::numbers::pi_v<Real> * i / kDirections;
      const kernel::Aabb moved = point_box(corner + kSafely * by * (std::cos(angle) * right_ + std::sin(angle) * up_));
      const auto is_outside = [&](const kernel::ShadowFrustum& shadow) {
        return kernel::overlap_certified(shadow, moved).relation == kernel::Relation::outside;
      };
      if (is_outside(shadows.first) && is_outside(shadows.second)) return false;
    }
  }
  return true;
}

}  // namespace occlude::fuzz
