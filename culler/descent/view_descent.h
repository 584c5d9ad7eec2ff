// SPDX-License-Identifier: MIT
// The descent of a tree of blocks that culls by the view alone.
#pragma once

#include <array>
#include <cstdint>

#include "base/each_bit.h"
#include "descent/block_descent.h"
#include "descent/volumes.h"
#include "occlude/culler/cull_result.h"

namespace occlude::culler {

/// Culls those of the nodes `left` of a block that are beyond a plane of the view. `straddled_planes` has for each node a
/// bit for each plane that may cross it, all of them among `planes`. relations_of(asked) returns those of the planes and the
/// nodes, as kernel::relations(); cull(nodes, culled) is called for those that a plane culls.
template <class RelationsOf, class Cull>
void keep_in_view(kernel::BoxBits& left, std::array<std::uint32_t, TreeBlock::kNodes>& straddled_planes,
                  std::uint32_t planes, const RelationsOf& relations_of, const Cull& cull) {
  kernel::BoxBytes asked = 0;
  for_each_bit(planes, [&](std::uint32_t plane) { asked |= kernel::BoxBytes{left} << 8 * plane; });
  const kernel::BlockRelations relations = relations_of(asked);
  for_each_bit(planes, [&](std::uint32_t plane) {
    const auto outside = static_cast<kernel::BoxBits>(kernel::boxes_of(relations.outside, plane) & left);
    cull(outside, Culled{0, Culled::By::view, plane});
    left = static_cast<kernel::BoxBits>(left & ~outside);
    for_each_bit(kernel::boxes_of(relations.inside, plane),
                 [&](std::uint32_t i) { straddled_planes[i] &= ~(std::uint32_t{1} << plane); });
  });
}

/// cull(block, i, culled) is called for each node that is out of view, and draw(items) for each subtree of which all is in
/// view, and for each leaf of which a part may be.
template <class Cull, class Draw>
class ViewDescent {
 public:
  ViewDescent(const BlockTree& tree, const Volumes& volumes, const Cull& cull, const Draw& draw)
      : tree_(tree), volumes_(volumes), cull_(cull), draw_(draw) {}

  /// Visits a block, which planes with these bits may cross, and those below it.
  void visit(const TreeBlock& block, std::uint32_t planes) const {
    kernel::BoxBits left = block.used;
    std::array<std::uint32_t, TreeBlock::kNodes> straddled_planes;
    straddled_planes.fill(planes);
    keep_in_view(
        left, straddled_planes, planes, [&](kernel::BoxBytes asked) { return volumes_.relations(block, asked); },
        [&](kernel::BoxBits nodes, const Culled& culled) {
          for_each_bit(nodes, [&](std::uint32_t i) { cull_(block, i, culled); });
        });
    for_each_bit(left, [&](std::uint32_t i) { visit(block, i, straddled_planes[i]); });
  }
  /// The same for a node of a block.
  void visit(const TreeBlock& block, std::uint32_t i, std::uint32_t planes) const {
    if (planes == 0 || block.is_leaf(i)) {
      draw_(block.items(i));
    } else {
      visit(tree_[block.below[i]], planes);
    }
  }

 private:
  const BlockTree& tree_;
  const Volumes& volumes_;
  const Cull& cull_;
  const Draw& draw_;
};

}  // namespace occlude::culler
