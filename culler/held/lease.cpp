// SPDX-License-Identifier: MIT
#include "held/lease.h"

#include <algorithm>

namespace occlude::culler {
namespace {

/// What is less is hardly longer than a cull takes, and in more than four seconds everybody changes direction.
constexpr double kShortest = 1.0 / 8, kLongest = 4;
/// A region that hides so much of what a frame by point does could be longer, or should be shorter. Where a short one hides
/// less than half, drawing the rest takes longer than culling.
constexpr double kNearlyAll = 0.97, kMuch = 0.9, kHalf = 0.5;
constexpr double kLongestRest = 8;

}  // namespace

void Lease::hid(double share, double now) {
  const double before = seconds_;
  if (share >= kHalf && !lost_) rest_ = kShortestRest;
  if (share >= kNearlyAll) seconds_ = std::min(2 * seconds_, kLongest);
  if (share < kMuch) seconds_ = std::max(seconds_ / 2, kShortest);
  has_changed_ = seconds_ != before;
  if (share < kHalf && !has_changed_) rest(now);
}

void Lease::held(double seconds, double lease, bool is_around, std::size_t frames, double now) {
  if (seconds < lease / 2) seconds_ = std::max(seconds_ * 0.75, kShortest);
  const bool has_lost = static_cast<double>(frames) < (is_around ? cost_around_ : cost_);
  if (has_lost && lost_) rest(now);
  lost_ = has_lost;
}

void Lease::rest(double now) {
  rests_until_ = now + rest_;
  rest_ = std::min(2 * rest_, kLongestRest);
}

}  // namespace occlude::culler
