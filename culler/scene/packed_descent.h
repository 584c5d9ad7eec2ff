// SPDX-License-Identifier: MIT
// One descent of a packed tree that culls by the view and by what a cover buffer has closed, eight boxes at a time.
#pragma once

#include <array>
#include <bit>
#include <cstdint>

#include "base/each_bit.h"
#include "camera/view_planes.h"
#include "cover/cover_buffer.h"
#include "cover/projected_boxes.h"
#include "model/packed_tree.h"
#include "occlude/culler/cull_result.h"
#include "occlude/kernel/box_block.h"

namespace occlude::culler {

/// `items` says what the tree holds:
/// asked(first): which of the items [first, first + 8) take part; the others are not heard of again.
/// beyond(first, plane, boxes): of these, those that are beyond a plane though their boxes in the tree are not.
/// prefetch(first): a hint that asked(first) comes.
/// cull(by, items): called for all that is culled together.
/// see(item, seen, i, straddled_planes): called for each item that is not culled. It is box i of those seen;
/// `straddled_planes` has a bit for each plane that may cross it.
template <class Items>
class PackedDescent {
 public:
  PackedDescent(const PackedTree& tree, const ViewPlanes& view, const CoverBuffer& buffer, CullStats& stats, Items& items)
      : tree_(tree), view_(view), buffer_(buffer), stats_(stats), items_(items) {}

  /// Descends from the root. `straddled_planes` has a bit for each plane that may cross it.
  void run(std::uint32_t straddled_planes) {
    if (tree_.empty()) return;
    if (tree_.root().level > 0) {
      visit_below(tree_.root(), visit(tree_.root(), straddled_planes));
    } else {
      visit(tree_.root(), straddled_planes);
    }
  }

 private:
  using At = PackedTree::At;
  using BoxBits = kernel::BoxBits;
  using StraddledPlanes = std::array<std::uint32_t, PackedTree::kWidth>;

  /// The boxes of a block that are not culled, and the planes that may cross each of them.
  struct Seen {
    BoxBits boxes = 0;
    StraddledPlanes straddled_planes;
  };

  /// Visits the blocks below a block. All of them are visited before those below them, so that memory has time to fetch
  /// these. REQUIRES: at.level > 0.
  void visit_below(const At& at, const Seen& seen) {
    std::array<Seen, PackedTree::kWidth> below;
    for_each_bit(seen.boxes, [&](std::uint32_t i) { below[i] = visit(PackedTree::below(at, i), seen.straddled_planes[i]); });
    if (at.level == 1) return;
    for_each_bit(seen.boxes, [&](std::uint32_t i) { visit_below(PackedTree::below(at, i), below[i]); });
  }

  Seen visit(const At& at, std::uint32_t straddled_planes) {
    Seen seen;
    seen.straddled_planes.fill(straddled_planes);
    const BoxBits in_view = keep_in_view(at, straddled_planes, seen.straddled_planes);
    if (in_view == 0) return seen;
    const ProjectedBoxes boxes(buffer_.box_picture(), tree_.block(at));
    stats_.cover_tests += kernel::count(in_view);
    const BoxBits hidden = buffer_.hidden(boxes, in_view);
    cull(at, Culled::By::cover, hidden);
    seen.boxes = static_cast<BoxBits>(in_view & ~hidden);
    for_each_bit(seen.boxes, [&](std::uint32_t i) {
      if (at.level > 0) {
        const At below = PackedTree::below(at, i);
        tree_.prefetch(below);
        if (below.level == 0) items_.prefetch(first_item(below));
      } else {
        items_.see(first_item(at) + i, boxes, i, seen.straddled_planes[i]);
      }
    });
    return seen;
  }

  /// The boxes of a block that take part and are in view. Culls those that are not.
  BoxBits keep_in_view(const At& at, std::uint32_t straddled_planes, StraddledPlanes& straddled_of) {
    BoxBits left = at.level == 0 ? items_.asked(first_item(at)) : tree_.used(at);
    stats_.nodes_visited += kernel::count(left);
    if (straddled_planes == 0 || left == 0) return left;
    stats_.view_tests += kernel::count(left) * static_cast<std::size_t>(std::popcount(straddled_planes));
    kernel::BoxBytes asked = 0;
    for_each_bit(straddled_planes, [&](std::uint32_t plane) { asked |= kernel::BoxBytes{left} << 8 * plane; });
    const kernel::BlockRelations relations = kernel::relations(view_.planes, tree_.block(at), asked);
    BoxBits outside = 0;
    for_each_bit(straddled_planes, [&](std::uint32_t plane) {
      const BoxBits inside = kernel::boxes_of(relations.inside, plane);
      outside = static_cast<BoxBits>(outside | kernel::boxes_of(relations.outside, plane));
      if (at.level == 0) {
        const auto straddling = static_cast<BoxBits>(left & ~(outside | inside));
        outside = static_cast<BoxBits>(outside | items_.beyond(first_item(at), plane, straddling));
      }
      for_each_bit(inside, [&](std::uint32_t i) { straddled_of[i] &= ~(std::uint32_t{1} << plane); });
    });
    cull(at, Culled::By::view, outside);
    return static_cast<BoxBits>(left & ~outside);
  }

  void cull(const At& at, Culled::By by, BoxBits boxes) {
    for_each_bit(boxes, [&](std::uint32_t i) { items_.cull(by, tree_.items(at, i)); });
  }

  [[nodiscard]] static std::uint32_t first_item(const At& at) { return PackedTree::kWidth * at.block; }

  const PackedTree& tree_;
  const ViewPlanes& view_;
  const CoverBuffer& buffer_;
  CullStats& stats_;
  Items& items_;
};

}  // namespace occlude::culler
