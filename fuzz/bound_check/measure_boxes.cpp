// SPDX-License-Identifier: MIT
// What ProjectedBoxes computes in floats holds a box and its error. How much is left of the error tells how much was needed.
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "cover/projected_boxes.h"
#include "measure_culler.h"
#include "model/bounds.h"
#include "true_picture.h"

namespace occlude::bound_check {
namespace {

using culler::ConservativeViewport;
using Share = std::optional<double>;

/// A box in a picture, as it was computed and as it is, relative to the eye along the axes of the picture.
struct SeenBox {
  ConservativeViewport picture;
  culler::BoxPicture floats;
  double margin;
  culler::ProjectedBoxes computed;
  std::array<Vector, 8> corners;
};

std::optional<SeenBox> any_box(Choices& choices, bool is_moved) {
  const ConservativeViewport picture = any_picture(choices, is_moved);
  const auto corner = any_point(choices, picture);
  if (!corner) return std::nullopt;
  const glm::dvec3 size = picture.depth() * choices.scale(-40, 0) * choices.point();
  kernel::Aabb box = culler::empty_box();
  culler::grow(box, culler::to_kernel(*corner));
  culler::grow(box, culler::to_kernel(*corner + size));
  if (culler::depth(box, picture.eye()) > picture.depth() * (1 - 0x1p-50)) return std::nullopt;
  const double margin = choices.chance(0.5) ? choices.scale(-10, 3) : 0;
  SeenBox seen{picture, {picture, {margin, margin}}, margin, {}, {}};
  seen.computed.add(seen.floats, box);
  seen.computed.project(seen.floats);
  if (seen.computed.most[0] == std::numeric_limits<float>::infinity()) return std::nullopt;
  const TruePicture truth(picture);
  for (unsigned i = 0; i < 8; ++i) seen.corners[i] = truth.see(bound_check::vector_of(culler::corner(box, i)));
  return seen;
}

template <class Function>
Exact least_of(const std::array<Vector, 8>& corners, const Function& function) {
  Exact least = function(corners[0]);
  for (const Vector& corner : corners) least = std::min(least, Exact(function(corner)));
  return least;
}
template <class Function>
Exact most_of(const std::array<Vector, 8>& corners, const Function& function) {
  return -least_of(corners, [&](const Vector& corner) { return Exact(-function(corner)); });
}

/// The bounds of projected_boxes.cpp, from the exact values of what is bounded.
struct Bounds {
  double moved, nearest, place;
};
Bounds bounds_of(const SeenBox& box, const TruePicture& truth) {
  double sum = 0;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    sum += std::max(std::fabs(box.computed.low[axis][0]), std::fabs(box.computed.high[axis][0]));
  }
  const culler::BoxPicture& p = box.floats;
  const double moved = (sum * 6 * 0x1p-24 + p.moved) * (1 + 0x1p-20);
  const double nearest = CGAL::to_double(least_of(box.corners, [](const Vector& c) { return c.z(); }));
  double aside = 0;
  for (const Vector& c : box.corners) {
    aside = std::max({aside, std::fabs(CGAL::to_double(Exact(truth.x(c) - Exact(p.middle_x)))),
                      std::fabs(CGAL::to_double(Exact(truth.y(c) - Exact(p.middle_y))))});
  }
  const double scale = std::max(p.scale_x, p.scale_y);
  const double shifted = p.is_perspective ? (scale + aside) * moved / (nearest - moved) : scale * moved;
  return {moved, nearest, shifted * (1 + 0x1p-20) + (aside + p.width + p.height) * 0x1p-20};
}

/// The farthest that corners may be moved in any way that a choice makes, in the coordinates of see().
Vector any_move_seen(Choices& choices, const ConservativeViewport& picture, bool is_across) {
  const double turn = choices.real(-4, 4);
  const Vector direction = is_across ? Vector(Exact(std::cos(turn)), 0, Exact(std::sin(turn)))
                                     : Vector(0, Exact(std::cos(turn)), Exact(std::sin(turn)));
  return Exact(picture.rounding()) * unit(direction);
}

Share positions_of_boxes(Choices& choices, bool is_moved) {
  auto box = any_box(choices, is_moved);
  if (!box) return std::nullopt;
  const TruePicture truth(box->picture);
  const Bounds bounds = bounds_of(*box, truth);
  const bool is_across = choices.chance(0.5);
  const Vector move = any_move_seen(choices, box->picture, is_across);
  for (Vector& corner : box->corners) corner = corner + move;
  const auto place = [&](const Vector& corner) { return is_across ? truth.x(corner) : truth.y(corner); };
  const culler::ProjectedBoxes& computed = box->computed;
  const Exact low = least_of(box->corners, place), high = most_of(box->corners, place);
  // The pixels hold the box and its margin, up to a pixel beside the picture.
  const int first = (is_across ? computed.x0 : computed.y0)[0], end = (is_across ? computed.x1 : computed.y1)[0];
  const int count = is_across ? box->picture.width() : box->picture.height();
  const bool holds = Exact(first) <= std::max(Exact(low - Exact(box->margin)), Exact(-1)) &&
                     Exact(end) >= std::min(Exact(high + Exact(box->margin)), Exact(count + 1));
  if (!holds) return std::numeric_limits<double>::infinity();
  return share_used(bounds.place, std::min(Exact(low - Exact((is_across ? computed.low_x : computed.low_y)[0])),
                                           Exact(Exact((is_across ? computed.high_x : computed.high_y)[0]) - high)));
}

Share nearness_of_boxes(Choices& choices, bool is_moved) {
  const auto box = any_box(choices, is_moved);
  if (!box) return std::nullopt;
  const TruePicture truth(box->picture);
  const auto [moved, nearest, place] = bounds_of(*box, truth);
  // As far towards the eye as a point may be moved.
  const Exact forward = root(truth.forward() * truth.forward()) * Exact(is_moved ? box->picture.rounding() : 0);
  const Vector towards(0, 0, -forward);
  const Exact still = most_of(box->corners, [&](const Vector& c) { return truth.nearness(c); });
  const Exact most = most_of(box->corners, [&](const Vector& c) { return truth.nearness(Vector(c + towards)); });
  const double bound = box->picture.is_perspective() ? 1 / (nearest - moved) : moved - nearest;
  const Exact room = Exact(bound) + Exact(0x1p-21) * CGAL::abs(Exact(bound)) - still;
  return share_used(room, Exact(box->computed.most[0]) - most);
}

}  // namespace

std::vector<Measured> measure_boxes(int cases, std::uint64_t seed) {
  const auto measure = [&](const char* bound, auto measured, bool is_moved) {
    return search(bound, "seen_boxes", cases, seed, [=](Choices& choices) { return measured(choices, is_moved); });
  };
  return {
      measure("positions of boxes, in floats", positions_of_boxes, false),
      measure("positions of boxes that are moved", positions_of_boxes, true),
      measure("nearness of boxes, in floats", nearness_of_boxes, false),
      measure("nearness of boxes that are moved", nearness_of_boxes, true),
  };
}

}  // namespace occlude::bound_check
