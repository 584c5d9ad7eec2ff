// SPDX-License-Identifier: MIT
// A square hides a point behind one of its sides, where the point is moved from the middle of the shadow towards the border
// until a margin no longer keeps it. How far that is from the border tells what the margin has room for, and exact moves of
// all concerned tell what it needs.
#include <array>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "camera/frame_view.h"
#include "camera/shadow_margin.h"
#include "camera/single_precision.h"
#include "measure_culler.h"
#include "occlude/kernel/shadow_frustum.h"
#include "true_picture.h"

namespace occlude::bound_check {
namespace {

using Share = std::optional<double>;

/// The eye is at 0 and looks along x. The square stands across at x = `distance` and reaches from -half to half in y and z.
/// The point is at x = `depth`, z = 0.
struct Square {
  bool is_perspective;
  double distance, half, depth;

  [[nodiscard]] culler::FrameView view(double reach) const {
    culler::Camera camera;
    camera.near_plane = distance / 2;
    if (!is_perspective) camera.projection = culler::Projection::orthographic;
    return {camera, reach};
  }
  [[nodiscard]] kernel::ShadowFrustum shadow() const {
    const std::array<kernel::Vec3, 4> loop{
        {{distance, -half, -half}, {distance, half, -half}, {distance, half, half}, {distance, -half, half}}};
    const auto viewpoint = is_perspective ? kernel::Viewpoint::eye({0, 0, 0}) : kernel::Viewpoint::direction({1, 0, 0});
    return kernel::ShadowFrustum::make(viewpoint, loop, kernel::Near::surface).frustum.value();
  }
  /// The largest y in the shadow at some x, for an eye and a side (x, y) of the square that may have been moved.
  [[nodiscard]] Exact border(const Exact& x, const Vector& eye, const Vector& side) const {
    if (!is_perspective) return side.y();
    return side.y() + (side.y() - eye.y()) / (side.x() - eye.x()) * (x - side.x());
  }
  [[nodiscard]] Exact border() const { return border(depth, {0, 0, 0}, {Exact(distance), Exact(half), 0}); }
  /// The direction across the side of the shadow, outwards.
  [[nodiscard]] Vector outwards() const {
    return unit(is_perspective ? Vector(Exact(-half), Exact(distance), 0) : Vector(0, 1, 0));
  }
};

Square any_square(Choices& choices) {
  const double distance = choices.scale(-10, 10);
  return {choices.chance(0.7), distance, distance * choices.scale(-10, 2), distance * (1 + choices.scale(-3, 10))};
}

/// The share of what the margin takes off at the border that is needed; `needed` of it is exact.
Share needed_share(const Square& square, const culler::ShadowMargin& margin, const Exact& needed) {
  const kernel::ShadowFrustum shadow = square.shadow();
  const auto keeps = [&](double y) {
    const kernel::Vec3 point{square.depth, y, 0};
    return margin.keeps(shadow, kernel::Aabb{point, point});
  };
  double kept = 0, lost = CGAL::to_double(square.border()) * (1 - 0x1p-50);
  if (!keeps(kept) || keeps(lost)) return std::nullopt;
  for (int step = 0; step < 60; ++step) {
    const double middle = (kept + lost) / 2;
    (keeps(middle) ? kept : lost) = middle;
  }
  // A margin is computed in doubles, and has their rounding (shadow_margin.h).
  return share(needed - Exact(0x1p-45) * square.border(), square.border() - Exact(lost));
}

Share moves_in_the_picture(Choices& choices) {
  const Square square = any_square(choices);
  const culler::FrameView view = square.view(0);
  const double share = choices.scale(-16, -4);
  const Exact size = Exact(share) * Exact(view.height) * Exact(square.is_perspective ? square.depth : 1);
  return needed_share(square, {view, share}, size);
}

/// The renderer moves the side of the square and the point, both across the side of the shadow.
Share moves_in_floats(Choices& choices) {
  const Square square = any_square(choices);
  const double reach = square.depth * choices.scale(1, 12);
  const double share = 0x1p-80;  // so that there is a margin
  const Vector move = Exact(culler::kSinglePrecision * reach) * square.outwards();
  const Vector side = Vector(Exact(square.distance), Exact(square.half), 0) - move;
  if (side.x() <= 0 || side.y() <= 0) return std::nullopt;
  const Exact moved = square.border(Exact(square.depth) + move.x(), {0, 0, 0}, side) - move.y();
  return needed_share(square, {square.view(reach), share}, square.border() - moved);
}

/// The eye is beside where it was found to be, across the side of the shadow.
Share moves_of_the_eye(Choices& choices) {
  const Square square = any_square(choices);
  culler::FrameView view = square.view(0);
  view.eye_uncertainty = square.distance * choices.scale(-40, -1);
  const Vector side(Exact(square.distance), Exact(square.half), 0);
  const Exact moved = square.border(square.depth, Exact(view.eye_uncertainty) * square.outwards(), side);
  if (!square.is_perspective) return std::nullopt;
  return needed_share(square, {view, 0}, square.border() - moved);
}

}  // namespace

std::vector<Measured> measure_margins(int cases, std::uint64_t seed) {
  return {
      search("moves of a rasteriser in the picture", "shadow_margin", cases, seed, moves_in_the_picture),
      search("moves of a renderer in floats", "shadow_margin", cases, seed, moves_in_floats),
      search("moves of the eye", "shadow_margin", cases, seed, moves_of_the_eye),
  };
}

}  // namespace occlude::bound_check
