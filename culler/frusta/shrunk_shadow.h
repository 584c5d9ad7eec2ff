// SPDX-License-Identifier: MIT
// A shadow less the margin of a frame, for the many boxes that are in the shadow.
#pragma once

#include <algorithm>
#include <vector>

#include "camera/shadow_margin.h"
#include "model/bounds.h"
#include "model/outer_box.h"
#include "occlude/kernel/half_space.h"
#include "occlude/kernel/shadow_frustum.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// Answers as ShadowMargin::keeps() does, with planes that were moved once.
class ShrunkShadow {
 public:
  /// REQUIRES: !shadow.is_none().
  void assign(const ShadowMargin& margin, const kernel::ShadowFrustum& shadow) {
    margin_ = margin;
    origin_ = shadow.origin();
    margin.move_planes(shadow, planes_);
  }
  void reserve(std::size_t planes) { planes_.reserve(planes); }

  /// REQUIRES: `shadow` is that of assign(), and the box is in it.
  template <class AnyBox>
  [[nodiscard]] bool keeps(const kernel::ShadowFrustum& shadow, const AnyBox& box) const {
    return std::ranges::all_of(planes_, [&](const kernel::HalfSpace& plane) { return holds(plane, origin_, box); }) &&
           (margin_.eye_error_ == 0 || margin_.holds_from_all_eyes(shadow, outer_box(box)));
  }

 private:
  ShadowMargin margin_;
  kernel::Vec3 origin_;
  std::vector<kernel::HalfSpace> planes_;
};

}  // namespace occlude::culler
