// SPDX-License-Identifier: MIT
#include "touching.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "vector_math.h"

namespace occlude::bench {
namespace {

/// Draws the numbers that place a touching point and size a box. They are whole or real.
class Draw {
 public:
  Draw(Numbers numbers, fuzz::Random& random) : whole_(numbers == Numbers::whole), random_(random) {}

  double in(int low, int high) { return whole_ ? random_.integer(low, high) : random_.real(low, high); }
  /// A position along an edge of the near face, strictly between 0 and 1.
  double share() { return whole_ ? random_.integer(1, 3) / 4.0 : random_.real(0.05, 0.95); }
  /// A part of the size of a box. It is whole when the size is.
  double part_of(double size) { return whole_ ? random_.integer(0, static_cast<int>(size)) : random_.real(0, size); }

 private:
  bool whole_;
  fuzz::Random& random_;
};

/// A point on the border of the frustum, and the sum of the inner normals of the planes through it.
struct BorderPoint {
  Vec3 point, inward;
};

enum class Feature { side_plane, beyond_side_plane, near_face, side_edge, near_edge, vertex };
constexpr std::size_t kFeatures = 6;

BorderPoint border_point(const kernel::ShadowFrustum& frustum, Draw& draw, fuzz::Random& random) {
  constexpr int kDepth = 4;  // multiples of the occluder's distance from the eye
  const auto corners = frustum.silhouette();
  const std::size_t i = random.index(4), next = (i + 1) % 4, previous = (i + 3) % 4;
  const Vec3 eye = frustum.viewpoint().value;
  const Vec3 near = frustum.rounded_plane(0).normal, side = frustum.rounded_plane(1 + i).normal,
             other_side = frustum.rounded_plane(1 + previous).normal;
  const Vec3 ray = corners[i] - eye, next_ray = corners[next] - eye;
  const Vec3 edge = corners[next] - corners[i], other_edge = corners[previous] - corners[i];
  const auto feature = static_cast<Feature>(random.index(kFeatures));
  // The numbers are drawn one by one because the compiler chooses the order in which operands of a sum are evaluated.
  const double along = draw.in(2, kDepth), across = draw.in(1, 2), share = draw.share(), other_share = draw.share();
  switch (feature) {
    case Feature::side_plane:
      return {eye + along * ray + across * next_ray, side};
    case Feature::beyond_side_plane:
      return {eye + along * ray - across * next_ray, side};
    case Feature::near_face:
      return {corners[i] + share * edge + other_share * other_edge, near};
    case Feature::side_edge:
      return {eye + along * ray, side + other_side};
    case Feature::near_edge:
      return {corners[i] + share * edge, near + side};
    case Feature::vertex:
      break;
  }
  return {corners[i], near + side + other_side};
}

/// `value` moved by -2 to 2 ulps.
double nudged(double value, fuzz::Random& random) {
  const int ulps = random.integer(-2, 2);
  const double towards = std::copysign(std::numeric_limits<double>::infinity(), ulps);
  for (int k = 0; k < std::abs(ulps); ++k) value = std::nextafter(value, towards);
  return value;
}

}  // namespace

kernel::Aabb touching_box(const kernel::ShadowFrustum& frustum, Numbers numbers, fuzz::Random& random) {
  constexpr int kLargest = 8;
  Draw draw(numbers, random);
  const auto [point, inward] = border_point(frustum, draw, random);
  const bool from_inside = random.chance(0.5);
  kernel::Aabb box;
  for (int axis = 0; axis < 3; ++axis) {
    const double size = draw.in(1, kLargest);
    const double direction = from_inside ? inward[axis] : -inward[axis];
    const double before = direction > 0 ? 0 : direction < 0 ? size : draw.part_of(size);
    box.min[axis] = point[axis] - before;
    box.max[axis] = direction < 0 ? point[axis] : box.min[axis] + size;
  }
  return box;
}

kernel::Aabb nudged(const kernel::Aabb& box, fuzz::Random& random) {
  kernel::Aabb moved;
  for (int axis = 0; axis < 3; ++axis) {
    const auto [low, high] = std::minmax({nudged(box.min[axis], random), nudged(box.max[axis], random)});
    moved.min[axis] = low;
    moved.max[axis] = high;
  }
  return moved;
}

}  // namespace occlude::bench
