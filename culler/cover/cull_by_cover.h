// SPDX-License-Identifier: MIT
// A frame by cover, from top to bottom: half-spaces, and one descent of the tree from front to back, in which what is seen
// closes pixels. Reading order: 13.
#pragma once

#include <cstdint>
#include <span>

#include "cover/cover_descent.h"
#include "cover/cover_frame.h"
#include "cover/cover_painter.h"
#include "descent/frame.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/hierarchy.h"

namespace occlude::culler {

/// A tree as a descent sees it: of a model.
struct ModelTree {
  const Hierarchy& hierarchy;
  std::span<const HierarchyNode> nodes = hierarchy.nodes();

  [[nodiscard]] const kernel::Aabb& box(std::uint32_t node) const { return nodes[node].box; }
  template <class Question>
  decltype(auto) ask(std::uint32_t node, const Question& question) const {
    return hierarchy.ask(node, question);
  }
};

/// Observes a frame by cover, and does nothing.
struct Unwatched {
  static void begin() {}
  static void joined(const CoverPainter&) {}
  static void culled(const Culled&) {}
};

/// What is seen of the model hides the rest. REQUIRES: the frame has begun.
template <class Watch = Unwatched>
void cull_by_cover(const Hierarchy& hierarchy, const CoverTriangles& triangles, const CullOptions& options, Frame& frame,
                   CoverMemory& memory, CoverLeaves& leaves, Watch&& watch = {}) {
  const CoverSource source{hierarchy.nodes(), triangles};
  CoverPainter painter(frame.view, options.cover, options.margin, memory, frame.result.stats);
  frame.result.method = Method::cover;  // the picture is this frame's from here on
  painter.use(source);
  watch.begin();

  CoverFrame found(source.nodes, memory.buffer, frame, leaves);
  const auto see = [&](const SeenNode& leaf) {
    found.see(leaf);
    if (leaf.is_worth_closing) painter.enqueue(leaf);
  };
  const auto cull = [&](const Culled& culled) {
    watch.culled(culled);
    found.cull(culled);
  };
  const auto join = [&] {
    if (painter.flush_group()) watch.joined(painter);
  };
  frame.take_planes();
  const ViewPlanes planes{frame.planes, options.arithmetic};
  const ModelTree tree{hierarchy};
  CoverDescent(tree, planes, memory.buffer, Sought::seen, frame.result.stats, see, cull, join).run(planes.all());
  found.finish(cull);
}

}  // namespace occlude::culler
