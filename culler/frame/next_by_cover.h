// SPDX-License-Identifier: MIT
// The next frame of a view by cover, with the work that Method::automatic saves. Reading order: 13.
#pragma once

#include "cover/cull_by_cover.h"
#include "frame/view_memory.h"

namespace occlude::culler {

/// REQUIRES: begin_frame(); the memory is that of a view whose frames are all of this model.
inline void next_by_cover(const Hierarchy& hierarchy, const BlockTree& tree, const CoverTriangles& triangles,
                          const CullOptions& options, View::Memory& memory) {
  CullOptions limited = options;
  const bool is_adaptive =
      options.method == Method::automatic && !options.cover.as_before && memory.frame.view.eyes.is_point();
  if (is_adaptive) {
    memory.worth.begin_next(memory.frame.view);
    memory.idle.begin_next(memory.worth.frame(), hierarchy.nodes().size(), memory.frame.result);
    limited.cover = memory.worth.limited(options.cover);
  }
  cull_by_cover(hierarchy, tree, triangles, limited, memory.frame, memory.cover, memory.leaves, memory.idle);
  const CullStats& stats = memory.frame.result.stats;
  if (is_adaptive) memory.worth.learn(stats.shadow_culled_polygons, stats.drawn_polygons, stats.cover_work);
}

}  // namespace occlude::culler
