// SPDX-License-Identifier: MIT
// The frustum of an occluder that has passed all checks.
#pragma once

#include <string>

#include "frustum.h"
#include "relate.h"

namespace occlude::oracle {

/// A frustum, or its fault. The faults of a question are checked in a fixed order, and those of the box come between these
/// two.
struct Prepared {
  std::string number_fault, shape_fault;
  Frustum frustum;

  Prepared(const Viewpoint& view, const Occluder& occluder, const Near& near);

  /// Why there is no frustum. Empty when there is one.
  [[nodiscard]] const std::string& fault() const { return number_fault.empty() ? shape_fault : number_fault; }

  /// Why the question about `box` cannot be answered. Empty when it can.
  [[nodiscard]] std::string fault(const Box& box) const;

  /// All planes of the frustum.
  [[nodiscard]] Planes planes();
};

[[nodiscard]] const std::vector<Point>& vertices_of(const Occluder& occluder);

}  // namespace occlude::oracle
