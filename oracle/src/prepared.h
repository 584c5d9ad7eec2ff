// SPDX-License-Identifier: MIT
// The frustum of an occluder after all checks.
#pragma once

#include <string>

#include "frustum.h"
#include "relate.h"

namespace occlude::oracle {

/// A frustum, or its fault. A question's faults have an order, in which those of the box come between these two.
struct Prepared {
  std::string number_fault, shape_fault;
  Frustum frustum;

  Prepared(const Viewpoint& view, const Occluder& occluder, const Near& near);

  /// Why there is no frustum.
  [[nodiscard]] const std::string& fault() const { return number_fault.empty() ? shape_fault : number_fault; }

  /// What makes the question about `box` unanswerable.
  [[nodiscard]] std::string fault(const Box& box) const;

  /// All planes of the frustum.
  [[nodiscard]] Planes planes();
};

[[nodiscard]] const std::vector<Point>& vertices_of(const Occluder& occluder);

}  // namespace occlude::oracle
