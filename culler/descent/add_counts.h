// SPDX-License-Identifier: MIT
// The counts of parts of a frame, added up.
#pragma once

#include "occlude/culler/cull_result.h"

namespace occlude::culler {

/// Adds what a descent counts of a part of a tree.
inline void add_counts(CullStats& sum, const CullStats& part) {
  sum.nodes_visited += part.nodes_visited;
  sum.view_tests += part.view_tests;
  sum.shadow_tests += part.shadow_tests;
  sum.union_tests += part.union_tests;
  sum.probe_tests += part.probe_tests;
  sum.cover_tests += part.cover_tests;
  sum.exact_shadow_tests += part.exact_shadow_tests;
  sum.drawn_polygons += part.drawn_polygons;
  sum.view_culled_polygons += part.view_culled_polygons;
  sum.shadow_culled_polygons += part.shadow_culled_polygons;
}

}  // namespace occlude::culler
