// SPDX-License-Identifier: MIT
// The nodes of a hierarchy in blocks of up to eight, so that a descent visits few.
#pragma once

#include <cstdint>
#include <string_view>

#include "model/block_tree.h"
#include "occlude/culler/executor.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/culler/parts.h"

namespace occlude::culler {

class PartReader;
class PartWriter;

/// A subtree has few items if it has at most this many, or is a leaf. What a frame by cover sees there hides together
/// (cover/cover_descent.h): with a smaller limit, more of what was drawn before is drawn again; with a larger one, what was
/// seen closes pixels later. With 384 or 512, the models tried take 0 to 5 % less, but a small town takes 10 % more
/// instructions.
inline constexpr std::uint32_t kFewItems = 256;

/// A block has nodes of a binary tree of which none is below another. Nodes between them and the node that they divide are
/// left out. A block has nodes within a subtree of few items only if it has no others.
class HierarchyBlocks {
 public:
  static constexpr std::string_view kPart = "blocks";

  HierarchyBlocks() = default;
  /// What `checkpoint` throws is thrown on.
  explicit HierarchyBlocks(const Hierarchy& hierarchy, const Checkpoint& checkpoint = {});
  /// For Culler::parts().
  void append_parts(PartWriter& parts) const;
  /// The blocks with these parts. Throws std::invalid_argument unless they have nodes of this tree with their boxes, and a
  /// descent from the first of them meets each item in one leaf.
  [[nodiscard]] static HierarchyBlocks from_parts(const PartReader& parts, const Hierarchy& hierarchy,
                                                  const Checkpoint& checkpoint = {});

  /// In the order in which a descent enters them.
  [[nodiscard]] BlockTree tree() const { return BlockTree({blocks_.data(), blocks_.size()}); }

 private:
  Array<TreeBlock> blocks_;
};

}  // namespace occlude::culler
