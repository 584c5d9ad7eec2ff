// SPDX-License-Identifier: MIT
// The volumes of a hierarchy's nodes, and how those of a block are held against the planes of a view.
#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>

#include "camera/view_planes.h"
#include "model/block_tree.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/kernel/box_block.h"
#include "occlude/kernel/half_space.h"

namespace occlude::culler {

class Volumes {
 public:
  /// What is given outlives this.
  Volumes(const Hierarchy& hierarchy, const ViewPlanes& view) : hierarchy_(hierarchy), view_(view) {}

  [[nodiscard]] const ViewPlanes& view() const { return view_; }

  /// Returns question(box) of the volume of a node. The block is at hand where the node of the hierarchy may be far.
  template <class Question>
  decltype(auto) ask(const TreeBlock& block, std::size_t i, const Question& question) const {
    return (block.oriented >> i & 1U) == 0 ? question(block.boxes.box(i)) : hierarchy_.ask(block.node[i], question);
  }
  /// Those nodes of a block that are asked about one by one.
  [[nodiscard]] TreeBlock::Bits alone(const TreeBlock& block) const {
    return view_.arithmetic == kernel::Arithmetic::certified ? block.oriented : block.used;
  }
  /// Of plane k of the view and the nodes of byte k of `asked`, as kernel::relations().
  [[nodiscard]] kernel::BlockRelations relations(const TreeBlock& block, kernel::BoxBytes asked) const {
    const kernel::BoxBytes alone = asked & kernel::for_all(this->alone(block));
    kernel::BlockRelations relations = kernel::relations(view_.planes, block.boxes, asked & ~alone);
    for (kernel::BoxBytes left = alone; left != 0; left &= left - 1) {
      const auto place = static_cast<std::uint32_t>(std::countr_zero(left));
      const kernel::BoxBytes bit = kernel::BoxBytes{1} << place;
      const kernel::Relation relation = ask(block, place % 8, [&](const auto& box) {
        return kernel::relation(view_.planes[place / 8], box, view_.arithmetic);
      });
      if (relation == kernel::Relation::outside) relations.outside |= bit;
      if (relation == kernel::Relation::inside) relations.inside |= bit;
    }
    return relations;
  }

 private:
  const Hierarchy& hierarchy_;
  ViewPlanes view_;
};

}  // namespace occlude::culler
