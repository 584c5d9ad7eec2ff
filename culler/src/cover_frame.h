// SPDX-License-Identifier: MIT
// The state of a frame by cover: what it draws, what it culls, and what has closed pixels.
#pragma once

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <span>

#include "cover_descent.h"
#include "cover_triangles.h"
#include "occlude/culler/camera.h"
#include "occlude/culler/cull_result.h"
#include "view_memory.h"

namespace occlude::culler {

/// The polygons that hide in frames by cover, in the order of a tree. Without nodes nothing hides.
struct CoverSource {
  std::span<const HierarchyNode> nodes;
  const CoverTriangles& triangles;
};

class CoverFrame {
 public:
  /// REQUIRES: begin_frame() was called; `view` reaches as far as all that is drawn or hides.
  CoverFrame(const CoverSource& source, const FrameView& view, const CullOptions& options, View::Memory& memory);

  /// `see`, `cull` and `join` as in CoverDescent. Does nothing without nodes.
  template <class Ask, class See, class Cull, class Join>
  void descend(std::span<const HierarchyNode> nodes, const Ask& ask, const See& see, const Cull& cull, const Join& join) {
    if (nodes.empty()) return;
    CoverDescent(nodes, ask, memory_.planes, options_, memory_.cover, memory_.result.stats, see, cull, join).run();
  }

  /// Notes that a leaf of the tree of `nodes` is seen. finish() asks again, because what is drawn later may still hide it.
  void see(std::uint32_t leaf, const CoverBuffer::Footprint& footprint) { memory_.seen.push_back({leaf, footprint}); }
  /// Keeps the polygons of a leaf of the source for join().
  void take(std::uint32_t leaf) { memory_.taken.push_back(leaf); }
  /// Draws the kept polygons into the coarse picture, together with the polygons that were drawn before and touch them, so
  /// that no seam between them stays open. Returns false if none were kept or no more may be drawn. Else the group that was
  /// drawn has the number groups().
  bool join();
  [[nodiscard]] std::uint32_t groups() const { return groups_; }

  void cull(std::span<const HierarchyNode> nodes, const Culled& culled);
  /// Tests the leaves that were seen again, now that no more pixels will be closed. Draws those that are not hidden, and
  /// puts what was drawn and culled into the order of the tree.
  template <class Cull>
  void finish(std::span<const HierarchyNode> nodes, const Cull& cull) {
    std::ranges::sort(memory_.seen, {}, &SeenLeaf::leaf);
    for (const auto& [leaf, footprint] : memory_.seen) {
      ++memory_.result.stats.cover_tests;
      if (memory_.cover.hides(footprint)) {
        cull({leaf, Culled::By::cover});
      } else {
        draw(nodes[leaf]);
      }
    }
    // Nodes are numbered depth-first, so this is the order of their items.
    std::ranges::sort(memory_.result.culled, {}, &Culled::node);
  }

 private:
  [[nodiscard]] bool may_draw_more() const;
  void draw(const HierarchyNode& leaf);
  void add_around(std::uint32_t leaf);

  const CoverSource& source_;
  const CullOptions& options_;
  View::Memory& memory_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::uint32_t groups_ = 0;
};

}  // namespace occlude::culler
