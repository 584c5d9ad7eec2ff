// SPDX-License-Identifier: MIT
// The shadow frustum F of an occluder, as the definition states it.
#pragma once

#include <string>
#include <vector>

#include "half_spaces.h"

namespace occlude::oracle {

/// The half-spaces of F.
struct Frustum {
  std::vector<Plane<OrientedPlane>> sides, near;
};

/// A frustum, or the fault of the question.
struct FrustumOrFault {
  Frustum frustum;
  std::string fault;
};

/// REQUIRES: the numbers and the view are without fault (faults.h).
[[nodiscard]] FrustumOrFault frustum_of(const Viewpoint& view, const Loop& loop, const Near& near);
[[nodiscard]] FrustumOrFault frustum_of(const Viewpoint& view, const Polytope& polytope, const Near& near);

}  // namespace occlude::oracle
