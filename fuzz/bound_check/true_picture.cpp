// SPDX-License-Identifier: MIT
#include "true_picture.h"

#include "camera/frame_view.h"
#include "camera/single_precision.h"

namespace occlude::bound_check {
namespace {

/// What is left of an axis across the rays.
Vector across(const Vector& axis, const Vector& rays) { return axis - (axis * rays) / (rays * rays) * rays; }

}  // namespace

Vector unit(const Vector& v) { return v / (root(v * v) * (1 + Exact(0x1p-101))); }

TruePicture::TruePicture(const culler::ConservativeViewport& picture)
    : is_perspective_(picture.is_perspective()),
      eye_(vector_of(picture.eye())),
      right_(vector_of(picture.right())),
      up_(vector_of(picture.up())),
      forward_(vector_of(picture.forward())),
      middle_x_(picture.middle().x),
      middle_y_(picture.middle().y),
      scale_x_(picture.scale().x),
      scale_y_(picture.scale().y) {
  if (is_perspective_) return;
  right_ = across(right_, forward_);
  up_ = across(up_, forward_);
}

Vector TruePicture::see(const Vector& point) const {
  const Vector y = point - eye_;
  return {right_ * y, up_ * y, forward_ * y};
}

Exact TruePicture::nearness(const Vector& a, const Vector& b, const Vector& c, const Exact& x, const Exact& y) const {
  const Vector n = CGAL::cross_product(b - a, c - a);
  const Exact h = n * a;
  return is_perspective_ ? Exact((n * Vector(x, y, 1)) / h) : Exact((n.x() * x + n.y() * y - h) / n.z());
}

culler::ConservativeViewport any_picture(Choices& choices, bool is_moved) {
  culler::Camera camera;
  camera.eye = choices.chance(0.5) ? choices.scale(-10, 20) * choices.point() : glm::dvec3(0, 0, 0);
  const double depth = choices.scale(-10, 10);
  camera.target = camera.eye + depth * choices.point();
  camera.up = choices.point();
  if (choices.chance(0.2)) camera.projection = culler::Projection::orthographic;
  camera.fov_y_deg = choices.chance(0.3) ? 0.001 + choices.scale(-10, 0) : choices.real(0.01, 179);
  camera.height = depth * choices.scale(-10, 2);
  camera.aspect = choices.scale(-3, 3);
  camera.near_plane = depth * choices.scale(-40, -1);
  if (!fault(camera).empty()) camera = {};
  const int width = 8 * static_cast<int>(choices.real(5, 80)), height = 8 * static_cast<int>(choices.real(5, 80));
  return {culler::FrameView(camera, depth), {width, height, 16}, is_moved ? culler::kSinglePrecision * depth : 0};
}

std::optional<glm::dvec3> any_point(Choices& choices, const culler::ConservativeViewport& picture) {
  const double depth = picture.depth();
  glm::dvec3 v = depth * choices.point();
  if (choices.chance(0.5)) {  // beyond the near plane by little or much
    const double along = glm::dot(v, picture.forward()) / glm::dot(picture.forward(), picture.forward());
    const double aside = choices.scale(-30, 0);
    v = aside * (v - along * picture.forward()) + (picture.near() + depth * choices.scale(-40, -1)) * picture.forward();
  }
  const double reach = std::fabs(v.x) + std::fabs(v.y) + std::fabs(v.z);
  if (reach > depth) v *= depth / reach;
  const glm::dvec3 point = picture.eye() + v;
  const Vector y = vector_of(point) - vector_of(picture.eye());
  if (CGAL::abs(y.x()) + CGAL::abs(y.y()) + CGAL::abs(y.z()) > Exact(depth)) return std::nullopt;
  if (picture.is_perspective() && picture.eye_point(point).forward < picture.near()) return std::nullopt;
  return point;
}

}  // namespace occlude::bound_check
