// SPDX-License-Identifier: MIT
// What is inside of closed shells.
#pragma once

#include <cstdint>
#include <vector>

#include "occlude/culler/cull_result.h"
#include "occlude/culler/executor.h"
#include "occlude/culler/hierarchy.h"

namespace occlude::cli {

struct Enclosed {
  std::vector<bool> polygons;  ///< of each polygon of the tree, whether it is
  /// A triangle of such a polygon, and the shell that has it inside.
  struct Triangle {
    culler::FanTriangle triangle;
    std::uint32_t shell;
  };
  std::vector<Triangle> triangles;                 ///< all of them, ascending
  std::vector<std::vector<std::uint32_t>> shells;  ///< polygons of each shell
};

/// The polygons of the tree that lie inside of closed shells of it (closed_shells.h). Exact.
/// 1. A segment from such a polygon to anywhere outside of the box of the model meets an opaque polygon strictly between.
/// 2. If `may_touch`, polygons count that touch their shell along the borders of the triangles of their fans. Where a ray
///    from outside of the model's hull meets one of these first, it meets an opaque polygon there that is not among them.
[[nodiscard]] Enclosed enclosed_polygons(const culler::Hierarchy& tree, bool may_touch,
                                         const culler::Checkpoint& checkpoint);

}  // namespace occlude::cli
