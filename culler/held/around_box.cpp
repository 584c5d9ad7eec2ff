// SPDX-License-Identifier: MIT
#include "held/around_box.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "held/held_region.h"
#include "occlude/kernel/validity.h"

namespace occlude::culler {
namespace {

/// A flat region has no room before it in which nothing is, so the layers of its picture would be spread over all
/// distances. It is taken thicker: by this share of its greatest width to each side, so that it grows by an eighth at most.
/// Other shares were not tried.
constexpr double kLeastShare = 1.0 / 16;

/// The middle of an interval, and half of a length that holds it however that rounds.
struct Interval {
  Interval(double low, double high) : middle(kernel::flushed(low / 2 + high / 2)) {
    const double half = std::max(high - middle, middle - low);
    if (half > 0) reach = std::max(std::nextafter(half, std::numeric_limits<double>::infinity()), kernel::kMinMagnitude);
  }

  double middle, reach = 0;
};

}  // namespace

/// The pictures of the six cameras overlap, so that each direction is in one of them. A region has no near plane; a point
/// has one that lies farther behind the eye, by the margin for single precision, than this nearest one of all is before it.
void cull_around(const Culler& culler, const kernel::Aabb& eyes, const CullOptions& options, View& view,
                 const std::function<void()>& take) {
  const Interval x(eyes.min.x, eyes.max.x), y(eyes.min.y, eyes.max.y), z(eyes.min.z, eyes.max.z);
  Camera camera;
  camera.eye = {x.middle, y.middle, z.middle};
  const double least = kernel::flushed(kLeastShare * std::max({x.reach, y.reach, z.reach}));
  const auto reach = [least](const Interval& of) { return std::max(of.reach, least); };
  camera.eyes = EyeRegion::box({reach(x), 0, 0}, {0, reach(y), 0}, {0, 0, reach(z)});
  for (const Camera& side : all_around(camera, kernel::kMinMagnitude)) {
    culler.cull(side, options, view);
    take();
  }
}

}  // namespace occlude::culler
