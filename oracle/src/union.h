// SPDX-License-Identifier: MIT
// Whether two convex sets cover a box.
#pragma once

#include "relate.h"

namespace occlude::oracle {

/// An intersection of half-spaces. The planes of `closed` belong to the set, those of `open` do not.
struct ConvexSet {
  Planes closed, open;
};

/// Whether every point of the box is in at least one of the sets.
[[nodiscard]] bool cover(const ConvexSet& first, const ConvexSet& second, const Box& box);

}  // namespace occlude::oracle
