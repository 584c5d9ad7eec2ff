// SPDX-License-Identifier: MIT
// What is inside of closed parts.
#pragma once

#include <vector>

#include "occlude/culler/executor.h"
#include "occlude/culler/hierarchy.h"

namespace occlude::cli {

/// The polygons of the tree that lie inside of a closed part of it, without touching it. Exact: a segment from such a
/// polygon to anywhere outside of the box of the model meets an opaque polygon strictly between.
[[nodiscard]] std::vector<bool> enclosed_polygons(const culler::Hierarchy& tree, const culler::Checkpoint& checkpoint);

}  // namespace occlude::cli
