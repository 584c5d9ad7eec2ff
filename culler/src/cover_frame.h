// SPDX-License-Identifier: MIT
// A frame by cover as it comes about: what it draws, what it culls, and which meshes have closed pixels.
#pragma once

#include <cstdint>
#include <span>

#include "cover_descent.h"
#include "cover_pieces.h"
#include "occlude/culler/camera.h"
#include "occlude/culler/cull_result.h"
#include "view_memory.h"

namespace occlude::culler {

class CoverFrame {
 public:
  /// After begin_frame(). `reach` as depth() of all that is drawn or hides.
  CoverFrame(const CoverPieces& meshes, const Camera& camera, double reach, const CullOptions& options,
             View::Memory& memory);

  /// `see` and `cull` as in CoverDescent; of no nodes nothing is done.
  template <class Ask, class See, class Cull>
  void descend(std::span<const HierarchyNode> nodes, const Ask& ask, const See& see, const Cull& cull) {
    if (nodes.empty()) return;
    CoverDescent(nodes, ask, memory_.planes, options_, camera_, memory_.cover, memory_.result.stats, see, cull).run();
  }

  /// A leaf of the tree of `nodes` is seen: what comes behind it may hide it yet.
  void see(std::uint32_t leaf) { memory_.seen.push_back(leaf); }
  /// Draws the mesh of the leaf into the coarse picture, unless this frame has or it is hardly seen. True where it may have
  /// closed something.
  bool close(const HierarchyNode& leaf);
  void cull(std::span<const HierarchyNode> nodes, const Culled& culled);
  /// Asks again about the leaves that were seen, now that all is closed that will be, draws those that are not hidden, and
  /// puts what was drawn and culled in the order of the tree.
  void finish(std::span<const HierarchyNode> nodes);

 private:
  const CoverPieces& meshes_;
  const Camera& camera_;
  const CullOptions& options_;
  View::Memory& memory_;
};

}  // namespace occlude::culler
