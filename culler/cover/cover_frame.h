// SPDX-License-Identifier: MIT
// The state of a frame by cover of a model: what it draws and what it culls.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "base/radix_sort.h"
#include "cover/cover_buffer.h"
#include "cover/projected_boxes.h"
#include "cover/seen_node.h"
#include "descent/frame.h"
#include "occlude/culler/append_range.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/hierarchy.h"

namespace occlude::culler {

/// A leaf that a frame by cover has not culled, and where it is in the coarse picture.
struct SeenLeaf {
  std::uint32_t leaf;
  CoverBuffer::Footprint footprint;
};

/// The leaves of a frame, and room to sort them. It is kept so that only the first frame allocates.
struct CoverLeaves {
  std::vector<SeenLeaf> seen;  ///< those that are not culled so far
  std::vector<std::uint32_t> drawn_leaves, drawn_room;
  std::vector<Culled> culled_room;
};

class CoverFrame {
 public:
  /// REQUIRES: frame.begin() was called.
  CoverFrame(std::span<const HierarchyNode> nodes, const CoverBuffer& buffer, Frame& frame, CoverLeaves& memory)
      : nodes_(nodes), buffer_(buffer), result_(frame.result), memory_(memory) {
    const std::size_t most = frame.result.culled.capacity();  // one for each leaf at most
    memory.seen.clear();
    memory.seen.reserve(most);
    memory.drawn_leaves.reserve(most);
    memory.drawn_room.reserve(most);
    memory.culled_room.reserve(most);
  }

  /// Notes that a leaf is seen. finish() asks again, because what is drawn later may still hide it.
  void see(const SeenNode& leaf) { memory_.seen.push_back({leaf.node, leaf.footprint}); }

  void cull(const Culled& culled) {
    CullStats& stats = result_.stats;
    (culled.by == Culled::By::view ? stats.view_culled_polygons : stats.shadow_culled_polygons) += nodes_[culled.node].count;
    result_.culled.push_back(culled);
  }

  /// Tests the leaves that were seen again, now that no more pixels will be closed. Draws those that are not hidden, and
  /// puts what was drawn and culled into the order of the tree.
  template <class Cull>
  void finish(const Cull& cull) {
    const std::span<const SeenLeaf> seen = memory_.seen;
    memory_.drawn_leaves.clear();
    for (std::size_t first = 0; first < seen.size(); first += BoxPixels::kMost) {
      finish(seen.subspan(first, std::min(BoxPixels::kMost, seen.size() - first)), cull);
    }
    // Nodes are numbered depth-first, so this is the order of their items.
    radix_sort(memory_.drawn_leaves, memory_.drawn_room, nodes_.size(), std::identity());
    radix_sort(result_.culled, memory_.culled_room, nodes_.size(), &Culled::node);
    for (const std::uint32_t leaf : memory_.drawn_leaves) draw(nodes_[leaf]);
  }

 private:
  /// Culls a few leaves, or keeps them to be drawn. REQUIRES: at most BoxPixels::kMost.
  template <class Cull>
  void finish(std::span<const SeenLeaf> leaves, const Cull& cull) {
    constexpr float kUnknown = std::numeric_limits<float>::infinity();
    BoxPixels boxes;
    for (const auto& [leaf, at] : leaves) boxes.add(at.pixels, at.is_in_picture ? at.most : kUnknown);
    result_.stats.cover_tests += leaves.size();
    const kernel::BoxBits hidden = buffer_.hidden(boxes, boxes.all());
    for (std::size_t i = 0; i < leaves.size(); ++i) {
      if ((hidden >> i & 1U) != 0) {
        cull({leaves[i].leaf, Culled::By::cover});
      } else {
        memory_.drawn_leaves.push_back(leaves[i].leaf);
      }
    }
  }

  void draw(const HierarchyNode& leaf) {
    result_.stats.drawn_polygons += leaf.count;
    append_range(result_.drawn, {leaf.first, leaf.count});
  }

  std::span<const HierarchyNode> nodes_;
  const CoverBuffer& buffer_;
  CullResult& result_;
  CoverLeaves& memory_;
};

}  // namespace occlude::culler
