// SPDX-License-Identifier: MIT
// Whether two convex sets cover a box.
#pragma once

#include "relate.h"

namespace occlude::oracle {

/// The intersection of the inner sides of planes: what is on a plane belongs to the inner side of a closed one and not to
/// that of an open one.
struct ConvexSet {
  Planes closed, open;
};

/// Whether every point of the box lies in one of the sets or in both.
[[nodiscard]] bool cover(const ConvexSet& first, const ConvexSet& second, const Box& box);

}  // namespace occlude::oracle
