// SPDX-License-Identifier: MIT
// Subtrees of a model that are idle in the frames of a view.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cover/cover_buffer.h"
#include "cover/cover_frame.h"
#include "cover/hiding_meshes.h"
#include "cover/idle_set.h"
#include "cover/worth_of_hiding.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/hierarchy.h"

namespace occlude::culler {

/// Of an idle leaf, nothing is drawn into the picture. An idle subtree of more is not asked, either: as much of it is drawn
/// as is in view.
class IdleNodes {
 public:
  /// Subtrees of fewer polygons are asked always. With 128 instead, frames of the castle take a tenth longer.
  static constexpr std::uint32_t kFewest = 16;

  /// A frame without one before it, or one once more.
  void begin(const CoverOptions& options);
  /// The next frame of a view, of a tree of so many nodes. REQUIRES: begin().
  void begin_next(WorthOfHiding::Frame kind, std::size_t nodes, CullResult& frame);
  [[nodiscard]] bool is_looking() const { return is_looking_; }
  [[nodiscard]] bool take(std::uint32_t node, std::vector<std::uint32_t>& taken) { return set_.take(node, taken); }
  /// Notes that nodes below this one are asked.
  void enter(std::uint32_t node) {
    if (is_looking_) entered_.push_back(node);
  }
  /// Finds what is idle, after a frame that was looking.
  void find(const Hierarchy& hierarchy, CoverBuffer& buffer, std::span<const SeenLeaf> seen, const CullResult& frame);

 private:
  void hide(const Hierarchy& hierarchy, const CoverBuffer& buffer, std::span<const Culled> culled);

  IdleSet set_;
  bool is_looking_ = false;
  std::vector<std::uint32_t> entered_;
  std::vector<std::uint32_t> hiding_leaves_;  ///< the first item of each
  HidingMeshes hiding_;
};

}  // namespace occlude::culler
