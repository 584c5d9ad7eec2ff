// SPDX-License-Identifier: MIT
// A frame by cover, from top to bottom: half-spaces, and one descent of the tree from front to back, in which what is seen
// closes pixels. Reading order: 12.
#pragma once

#include <cstdint>
#include <vector>

#include "cover/cover_descent.h"
#include "cover/cover_frame.h"
#include "cover/cover_painter.h"
#include "cover/idle_nodes.h"
#include "cover/opening.h"
#include "cover/worth_drawing.h"
#include "descent/frame.h"
#include "descent/view_descent.h"
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

/// The nodes of a model that may be hidden, for a descent of its tree.
template <class Watch>
class ModelNodes : public StandingNodes {
 public:
  ModelNodes(const BlockTree& tree, const Volumes& volumes, CullBudget& budget, CoverFrame& found, Watch& watch)
      : tree_(tree), volumes_(volumes), budget_(budget), found_(found), watch_(watch) {}

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

  bool spend(std::size_t work) { return budget_.spend(work); }

  /// Draws as much of a block, or of a node of it, as is in view: `at` is what ViewDescent::visit() takes.
  template <class... At>
  void draw_unasked(const At&... at) {
    const auto cull = [&](const TreeBlock& of, std::uint32_t i, const Culled& culled) { this->cull(of, i, culled); };
    const auto draw = [&](const ItemRange& items) { found_.draw_unasked(items); };
    ViewDescent(tree_, volumes_, cull, draw).visit(at...);
  }

 protected:
  const BlockTree& tree_;
  const Volumes& volumes_;
  CullBudget& budget_;
  CoverFrame& found_;
  Watch& watch_;
};

/// What is seen of them closes pixels.
template <class Watch>
class ClosingModelNodes : public ModelNodes<Watch> {
 public:
  ClosingModelNodes(const ModelNodes<Watch>& nodes, const CoverBuffer& buffer, CoverPainter& painter, IdleNodes& idle,
                    CullResult& result)
      : ModelNodes<Watch>(nodes),
        buffer_(buffer),
        painter_(painter),
        idle_(idle),
        taken_(result.idle),
        stats_(result.stats) {}

  void leave(const TreeBlock& block, std::uint32_t straddled_planes) { found_.put_off(block, {straddled_planes, true}); }

  template <class Boxes>
  bool decide(const TestedBlock<Boxes>& tested, std::uint32_t i) {
    if (tested.block.is_leaf(i)) {
      see(tested, i);
      return false;
    }
    if (!enter(tested, i)) return false;
    idle_.enter(tested.block.node[i]);
    return true;
  }
  /// Draws what was not worth it as long as larger leaves might have needed the budget.
  void draw_small() {
    if (budget_.worth() <= kWorthOfLeaf) return;
    std::uint32_t items = 0;
    for (const SeenLeaf& leaf : found_.seen()) {
      if (leaf.is_taken() || idle_.take(leaf.node, taken_) || !budget_.spend(1)) continue;
      const int worth = worth_closing(kWorthOfLeaf, stats_.cover_triangles);
      if (buffer_.open(leaf.footprint, worth) < worth) continue;
      painter_.enqueue(leaf.items, leaf.footprint.most);
      items += leaf.items.count;
      if (items > kFewItems) {
        join();
        items = 0;
      }
    }
    join();
  }
  void join() {
    if (painter_.flush_group()) watch_.joined(painter_);
  }

 private:
  using ModelNodes<Watch>::budget_, ModelNodes<Watch>::found_, ModelNodes<Watch>::watch_;

  /// Whether to go below a node that is no leaf.
  template <class Boxes>
  bool enter(const TestedBlock<Boxes>& tested, std::uint32_t i) {
    const TreeBlock& block = tested.block;
    if (block.count(i) >= IdleNodes::kFewest && idle_.take(block.node[i], taken_)) {
      this->draw_unasked(block, i, tested.straddled_planes[i]);
      return false;
    }
    if (tested.groups == stats_.cover_groups) return true;  // nothing was drawn since it was tested
    if (!Opening(buffer_, tested, i, stats_.cover_groups, 1).is_hidden()) return true;
    this->cull(block, i, {0, Culled::By::cover});
    return false;
  }

  template <class Boxes>
  void see(const TestedBlock<Boxes>& tested, std::uint32_t i) {
    const TreeBlock& block = tested.block;
    const int worth = worth_closing(std::max(kWorthOfLeaf, budget_.worth()), stats_.cover_triangles);
    const Opening opening(buffer_, tested, i, stats_.cover_groups, worth);
    if (opening.is_hidden()) return this->cull(block, i, {0, Culled::By::cover});
    const bool is_worth = opening.open >= worth && !idle_.take(block.node[i], taken_);
    found_.see({block.node[i], block.items(i), opening.footprint, is_worth ? painter_.groups() + 1 : 0});
    budget_.reserve(kWorkOfSeen);
    if (is_worth) painter_.enqueue(block.items(i), opening.footprint.most);
  }

  const CoverBuffer& buffer_;
  CoverPainter& painter_;
  IdleNodes& idle_;
  std::vector<std::uint32_t>& taken_;
  CullStats& stats_;
};

/// What was left when no more was drawn.
template <class Watch>
class LeftModelNodes : public ModelNodes<Watch> {
 public:
  explicit LeftModelNodes(const ModelNodes<Watch>& nodes) : ModelNodes<Watch>(nodes) {}

  void leave(const TreeBlock& block, std::uint32_t straddled_planes) { this->draw_unasked(block, straddled_planes); }
  template <class Boxes>
  bool decide(const TestedBlock<Boxes>& tested, std::uint32_t i) {
    if (!tested.block.is_leaf(i)) return true;
    found_.keep(tested.block.items(i));
    this->budget_.reserve(kWorkOfKept);
    return false;
  }

 private:
  using ModelNodes<Watch>::found_;
};

/// What is seen of the model hides the rest. REQUIRES: the frame has begun.
template <class Watch = Unwatched>
void cull_by_cover(const Hierarchy& hierarchy, const BlockTree& tree, const CoverTriangles& triangles,
                   const CullOptions& options, Frame& frame, CoverMemory& memory, CoverLeaves& leaves, IdleNodes& idle,
                   Watch&& watch = {}) {
  const CoverSource source{triangles};
  CoverPainter painter(frame.view, options.cover, options.margin, memory, frame.result.stats);
  frame.result.method = Method::cover;  // View::visibility() asks the picture from here on
  painter.use(source);
  watch.begin();
  if (idle.is_looking()) memory.buffer.keep_closings();

  const Volumes volumes(hierarchy, frame.view_planes(options.arithmetic));
  CoverFrame found(tree, memory.buffer, frame, leaves);
  ClosingModelNodes nodes(ModelNodes(tree, volumes, painter.budget(), found, watch), memory.buffer, painter, idle,
                          frame.result);
  CoverDescent(tree, memory.buffer, frame.result.stats, nodes).run(volumes.view().all());
  nodes.draw_small();
  painter.finish();
  LeftModelNodes left(nodes);
  CoverDescent asking(tree, memory.buffer, frame.result.stats, left);
  found.visit_put_off(tree, asking);
  frame.result.stats.cover_work = painter.budget().work();
  found.finish([&](const Culled& culled, std::size_t items) { nodes.cull(culled, items); });
  if (idle.is_looking()) idle.find(hierarchy, memory.buffer, found.seen(), frame.result);
}

}  // namespace occlude::culler
