// SPDX-License-Identifier: MIT
// One descent of a packed tree that culls by the view and by what a cover buffer has closed, eight boxes at a time.
#pragma once

#include <hwy/cache_control.h>

#include <array>
#include <bit>
#include <cstdint>

#include "cover_buffer.h"
#include "cover_descent.h"
#include "occlude/culler/cull_result.h"
#include "occlude/kernel/box_block.h"
#include "packed_tree.h"
#include "seen_boxes.h"

namespace occlude::culler {

/// `items` says what the tree holds:
/// asked(first): which of the items [first, first + 8) take part; the others are not heard of again.
/// beyond(first, plane, boxes): of these, those that are beyond a plane though their boxes in the tree are not.
/// cull(by, items): called for all that is culled together.
/// see(item, seen, i, across): called for each item that is not culled. It is box i of those seen; `across` has a bit for
/// each plane that may cross it.
template <class Items>
class PackedDescent {
 public:
  PackedDescent(const PackedTree& tree, const ViewPlanes& view, const CoverBuffer& buffer, CullStats& stats, Items& items)
      : tree_(tree), view_(view), buffer_(buffer), stats_(stats), items_(items) {}

  /// Descends from the root. `across` has a bit for each plane that may cross it.
  void run(std::uint32_t across) {
    if (!tree_.empty()) visit(tree_.root(), across);
  }

 private:
  using At = PackedTree::At;
  using BoxBits = kernel::BoxBits;
  using Across = std::array<std::uint32_t, PackedTree::kWidth>;

  void visit(const At& at, std::uint32_t across) {
    Across across_of;
    across_of.fill(across);
    const BoxBits in_view = keep_in_view(at, across, across_of);
    if (in_view == 0) return;
    SeenBoxes boxes;
    boxes.see(buffer_.box_picture(), tree_.block(at));
    stats_.cover_tests += static_cast<std::size_t>(std::popcount(in_view));
    const BoxBits hidden = buffer_.hidden(boxes, in_view);
    cull(at, Culled::By::cover, hidden);
    const auto seen = static_cast<BoxBits>(in_view & ~hidden);
    if (at.level == 0) {
      for_each(seen, [&](std::uint32_t i) { items_.see(first_item(at) + i, boxes, i, across_of[i]); });
    } else {
      for_each(seen, [&](std::uint32_t i) { prefetch(tree_.block(PackedTree::below(at, i))); });
      for_each(seen, [&](std::uint32_t i) { visit(PackedTree::below(at, i), across_of[i]); });
    }
  }

  /// The boxes of a block that take part and are in view. Culls those that are not.
  BoxBits keep_in_view(const At& at, std::uint32_t across, Across& across_of) {
    BoxBits left = at.level == 0 ? items_.asked(first_item(at)) : tree_.used(at);
    stats_.nodes_visited += static_cast<std::size_t>(std::popcount(left));
    if (across == 0 || left == 0) return left;
    stats_.view_tests += static_cast<std::size_t>(std::popcount(left) * std::popcount(across));
    std::array<kernel::BlockRelation, ViewPlanes::kMostPlanes> relations;
    kernel::relations(view_.planes, across, tree_.block(at), left, relations);
    BoxBits outside = 0;
    for (; across != 0; across &= across - 1) {
      const auto plane = static_cast<std::uint32_t>(std::countr_zero(across));
      const kernel::BlockRelation& relation = relations[plane];
      outside = static_cast<BoxBits>(outside | relation.outside);
      if (at.level == 0) {
        const auto straddling = static_cast<BoxBits>(left & ~(outside | relation.inside));
        outside = static_cast<BoxBits>(outside | items_.beyond(first_item(at), plane, straddling));
      }
      for_each(relation.inside, [&](std::uint32_t i) { across_of[i] &= ~(std::uint32_t{1} << plane); });
    }
    cull(at, Culled::By::view, outside);
    return static_cast<BoxBits>(left & ~outside);
  }

  void cull(const At& at, Culled::By by, BoxBits boxes) {
    for_each(boxes, [&](std::uint32_t i) { items_.cull(by, tree_.items(at, i)); });
  }

  [[nodiscard]] static std::uint32_t first_item(const At& at) { return PackedTree::kWidth * at.block; }

  template <class Visit>
  static void for_each(BoxBits boxes, const Visit& visit) {
    for (unsigned left = boxes; left != 0; left &= left - 1) visit(static_cast<std::uint32_t>(std::countr_zero(left)));
  }

  static void prefetch(const kernel::BoxBlock& block) {
    for (const auto* rows : {&block.min, &block.max}) {
      for (const kernel::BoxBlock::Row& row : *rows) hwy::Prefetch(row.data());
    }
  }

  const PackedTree& tree_;
  const ViewPlanes& view_;
  const CoverBuffer& buffer_;
  CullStats& stats_;
  Items& items_;
};

}  // namespace occlude::culler
