// SPDX-License-Identifier: MIT
// The state of a frame by cover of a model: what it draws and what it culls.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "base/radix_sort.h"
#include "cover/cover_buffer.h"
#include "cover/cover_descent.h"
#include "cover/projected_boxes.h"
#include "descent/frame.h"
#include "descent/largest_first.h"
#include "model/append_range.h"
#include "model/block_tree.h"
#include "occlude/culler/cull_result.h"

namespace occlude::culler {

/// A leaf that a frame by cover has not culled, and where it is in the coarse picture.
struct SeenLeaf {
  std::uint32_t node;
  ItemRange items;
  CoverBuffer::Footprint footprint;
  std::uint32_t group;  ///< the number of the group with which its polygons were to be drawn into the picture; 0 if none

  [[nodiscard]] bool is_taken() const { return group != 0; }
};

/// The leaves of a frame, and room to sort them. It is kept so that only the first frame allocates.
struct CoverLeaves {
  std::vector<SeenLeaf> seen;  ///< those that are not culled so far
  std::vector<ItemRange> drawn, drawn_room;
  std::vector<Culled> culled_room;
  LargestFirst<NodeState> put_off;
};

class CoverFrame {
 public:
  /// REQUIRES: frame.begin() was called.
  CoverFrame(const BlockTree& tree, const CoverBuffer& buffer, Frame& frame, CoverLeaves& memory)
      : items_(tree.items().count), buffer_(buffer), result_(frame.result), memory_(memory) {
    const std::size_t most = frame.result.culled.capacity();  // one for each leaf at most
    memory.seen.clear();
    memory.seen.reserve(most);
    memory.drawn.clear();
    memory.drawn.reserve(most);
    memory.drawn_room.reserve(most);
    memory.culled_room.reserve(most);
    memory.put_off.begin(tree);
  }

  /// Notes that a leaf is seen. finish() asks again, because what is drawn later may still hide it.
  void see(const SeenLeaf& leaf) { memory_.seen.push_back(leaf); }
  [[nodiscard]] std::span<const SeenLeaf> seen() const { return memory_.seen; }
  /// Notes that a block is to be visited when no more is drawn.
  void put_off(const TreeBlock& block, const NodeState& state) { memory_.put_off.push(block, state); }
  /// Visits the blocks that were put off, and those below them.
  template <class Tests>
  void visit_put_off(const BlockTree& tree, Tests& tests) {
    memory_.put_off.visit(tree, tests);
  }
  /// Draws a leaf that is not hidden, or a subtree that was not asked.
  void keep(const ItemRange& items) { memory_.drawn.push_back(items); }
  void draw_unasked(const ItemRange& items) {
    result_.stats.unasked_polygons += items.count;
    keep(items);
  }

  /// Culls a node of so many items.
  void cull(const Culled& culled, std::size_t items) {
    CullStats& stats = result_.stats;
    (culled.by == Culled::By::view ? stats.view_culled_polygons : stats.shadow_culled_polygons) += items;
    result_.culled.push_back(culled);
  }

  /// Tests the leaves that were seen again, now that no more pixels will be closed. Draws those that are not hidden, and
  /// puts what was drawn and culled into the order of the tree. Calls cull(culled, items) for those that are hidden.
  template <class Cull>
  void finish(const Cull& cull) {
    const std::span<const SeenLeaf> seen = memory_.seen;
    for (std::size_t first = 0; first < seen.size(); first += BoxPixels::kMost) {
      finish(seen.subspan(first, std::min(BoxPixels::kMost, seen.size() - first)), cull);
    }
    radix_sort(memory_.drawn, memory_.drawn_room, items_, &ItemRange::first);
    // Nodes are numbered depth-first, so this is the order of their items. There are fewer than twice as many.
    radix_sort(result_.culled, memory_.culled_room, 2 * std::uint64_t{items_}, &Culled::node);
    for (const ItemRange& leaf : memory_.drawn) draw(leaf);
  }

 private:
  /// Culls a few leaves, or keeps them to be drawn. REQUIRES: at most BoxPixels::kMost.
  template <class Cull>
  void finish(std::span<const SeenLeaf> leaves, const Cull& cull) {
    constexpr float kUnknown = std::numeric_limits<float>::infinity();
    BoxPixels boxes;
    for (const SeenLeaf& leaf : leaves) {
      const CoverBuffer::Footprint& at = leaf.footprint;
      boxes.add(at.pixels, at.is_in_picture ? at.most : kUnknown, at.first_tile);
    }
    result_.stats.cover_tests += leaves.size();
    const kernel::BoxBits hidden = buffer_.hidden(boxes, boxes.all());
    for (std::size_t i = 0; i < leaves.size(); ++i) {
      if ((hidden >> i & 1U) != 0) {
        cull(Culled{leaves[i].node, Culled::By::cover}, leaves[i].items.count);
      } else {
        memory_.drawn.push_back(leaves[i].items);
      }
    }
  }

  void draw(const ItemRange& leaf) {
    result_.stats.drawn_polygons += leaf.count;
    append_range(result_.drawn, {leaf.first, leaf.count});
  }

  std::uint32_t items_;
  const CoverBuffer& buffer_;
  CullResult& result_;
  CoverLeaves& memory_;
};

}  // namespace occlude::culler
