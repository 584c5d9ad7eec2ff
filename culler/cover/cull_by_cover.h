// SPDX-License-Identifier: MIT
// A frame by cover, from top to bottom: half-spaces, and one descent of the tree from front to back, in which what is seen
// closes pixels. Reading order: 12.
#pragma once

#include <cstdint>

#include "cover/cover_descent.h"
#include "cover/cover_frame.h"
#include "cover/cover_painter.h"
#include "cover/opening.h"
#include "cover/worth_drawing.h"
#include "descent/frame.h"
#include "descent/volumes.h"
#include "model/hierarchy_blocks.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/hierarchy.h"

namespace occlude::culler {

/// The default observer of a frame by cover: it does nothing.
struct Unwatched {
  static void begin() {}
  static void joined(const CoverPainter&) {}
  static void culled(const Culled&) {}
};

/// The nodes of a model, for a descent of its tree.
template <class Watch>
class ModelNodes : public StandingNodes {
 public:
  ModelNodes(const Volumes& volumes, const CoverBuffer& buffer, CoverPainter& painter, CoverFrame& found, CullStats& stats,
             Watch& watch)
      : volumes_(volumes), buffer_(buffer), painter_(painter), found_(found), stats_(stats), watch_(watch) {}

  [[nodiscard]] kernel::BlockRelations relations(const TreeBlock& block, const kernel::BoxBlock&,
                                                 kernel::BoxBytes asked) const {
    return volumes_.relations(block, asked);
  }

  void cull(const TreeBlock& block, std::uint32_t i, Culled culled) {
    culled.node = block.node[i];
    cull(culled, block.count(i));
  }
  void cull(const Culled& culled, std::size_t items) {
    watch_.culled(culled);
    found_.cull(culled, items);
  }

  template <class Boxes>
  bool decide(const TestedBlock<Boxes>& tested, std::uint32_t i) {
    const bool is_leaf = tested.block.is_leaf(i);
    if (!is_leaf && tested.groups == stats_.cover_groups) return true;  // nothing was drawn since it was tested
    const int worth = worth_closing(kWorthOfLeaf, stats_.cover_triangles);
    const Opening opening(buffer_, tested, i, stats_.cover_groups, is_leaf ? worth : 1);
    if (opening.is_hidden()) {
      cull(tested.block, i, {0, Culled::By::cover});
      return false;
    }
    if (!is_leaf) return true;
    found_.see({tested.block.node[i], tested.block.items(i), opening.footprint});
    if (opening.open >= worth) painter_.enqueue(tested.block.items(i), opening.footprint.most);
    return false;
  }
  void join() {
    if (painter_.flush_group()) watch_.joined(painter_);
  }

 private:
  const Volumes& volumes_;
  const CoverBuffer& buffer_;
  CoverPainter& painter_;
  CoverFrame& found_;
  CullStats& stats_;
  Watch& watch_;
};

/// What is seen of the model hides the rest. REQUIRES: the frame has begun.
template <class Watch = Unwatched>
void cull_by_cover(const Hierarchy& hierarchy, const BlockTree& tree, const CoverTriangles& triangles,
                   const CullOptions& options, Frame& frame, CoverMemory& memory, CoverLeaves& leaves, Watch&& watch = {}) {
  const CoverSource source{triangles};
  CoverPainter painter(frame.view, options.cover, options.margin, memory, frame.result.stats);
  frame.result.method = Method::cover;  // View::visibility() asks the picture from here on
  painter.use(source);
  watch.begin();

  const Volumes volumes(hierarchy, frame.view_planes(options.arithmetic));
  CoverFrame found(tree, memory.buffer, frame, leaves);
  ModelNodes nodes(volumes, memory.buffer, painter, found, frame.result.stats, watch);
  CoverDescent(tree, memory.buffer, frame.result.stats, nodes).run(volumes.view().all());
  painter.finish();
  found.finish([&](const Culled& culled, std::size_t items) { nodes.cull(culled, items); });
}

}  // namespace occlude::culler
