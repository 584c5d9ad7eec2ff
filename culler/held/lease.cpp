// SPDX-License-Identifier: MIT
#include "held/lease.h"

#include <algorithm>

namespace occlude::culler {
namespace {

/// What is less is hardly longer than a cull takes, and in more than four seconds everybody changes direction.
constexpr double kShortest = 1.0 / 8, kLongest = 4;
/// A region that hides so much of what a frame by point does could be longer, or should be shorter. Where a short one hides
/// less than half, drawing the rest takes longer than culling.
constexpr double kAll = 0.97, kMost = 0.9, kHalf = 0.5;
constexpr double kLongestRest = 8;

}  // namespace

void Lease::hid(double share, double now) {
  if (share >= kAll) seconds_ = std::min(2 * seconds_, kLongest);
  if (share >= kHalf) rest_ = 1;
  if (share >= kMost) return;
  if (share < kHalf && seconds_ <= kShortest) return rest(now);
  seconds_ = std::max(seconds_ / 2, kShortest);
}

void Lease::held(double seconds, double lease) {
  if (seconds < lease / 2) seconds_ = std::max(seconds_ * 0.75, kShortest);
}

void Lease::rest(double now) {
  rests_until_ = now + rest_;
  rest_ = std::min(2 * rest_, kLongestRest);
}

}  // namespace occlude::culler
