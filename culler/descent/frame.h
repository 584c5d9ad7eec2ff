// SPDX-License-Identifier: MIT
// A frame while it is made: its view, and what is drawn and culled of it.
#pragma once

#include <cstddef>
#include <vector>

#include "camera/frame_view.h"
#include "camera/shadow_margin.h"
#include "camera/view_planes.h"
#include "model/bounds.h"
#include "occlude/culler/cull_result.h"
#include "occlude/kernel/half_space.h"

namespace occlude::culler {

struct Frame {
  CullResult result;
  FrameView view;
  ShadowMargin margin;
  std::vector<kernel::HalfSpace> planes;

  /// Empties the result: by frusta without occluders, which hides nothing. Reserves memory for all that a frame may draw or
  /// cull of a tree of this many nodes, so that no frame after the first allocates. Memory that is never written to takes
  /// only addresses.
  void begin(std::size_t nodes) {
    result.drawn.clear();
    result.culled.clear();
    result.view.clear();
    result.occluders.clear();
    result.pairs.clear();
    result.idle.clear();
    result.stats = {};
    result.method = Method::frusta;
    // Drawn and culled subtrees have no leaf in common, and between two drawn ranges something is culled.
    const std::size_t leaves = (nodes + 1) / 2;
    result.drawn.reserve((leaves + 1) / 2);
    result.culled.reserve(leaves);
  }

  /// The view of the result, in `planes`.
  ViewPlanes view_planes(kernel::Arithmetic arithmetic) {
    planes.clear();
    for (const HalfSpace& h : result.view) planes.push_back({to_kernel(h.normal), h.offset});
    return {planes, arithmetic};
  }

  /// Makes the result one that culls nothing of a model of these polygons. REQUIRES: begin() was called.
  void draw_all(const PolygonRange& polygons) {
    result.culled.clear();
    result.drawn.assign(1, polygons);
    result.stats.drawn_polygons = polygons.count;
    result.stats.view_culled_polygons = result.stats.shadow_culled_polygons = 0;
  }
};

}  // namespace occlude::culler
