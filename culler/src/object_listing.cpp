// SPDX-License-Identifier: MIT
#include "object_listing.h"

#include <array>
#include <bit>

#include "occlude/kernel/half_space.h"
#include "seen_boxes.h"

namespace occlude::culler {

void ObjectListing::list(const ObjectGroup& group, std::uint32_t across) {
  const auto nodes = group.nodes();
  const auto see = [&](const SeenNode& leaf) { list_leaf(group, nodes[leaf.node], leaf.across); };
  const auto cull = [&](const Culled& culled) { count(culled.by, group.count(nodes[culled.node], options_.mask)); };
  const auto join = [] {};
  const StandingBoxes tree{nodes};
  CoverDescent(tree, view_, buffer_, stats_.work, see, cull, join).run(across);
}

/// The objects of a leaf are tested together.
void ObjectListing::list_leaf(const ObjectGroup& group, const HierarchyNode& leaf, std::uint32_t across) {
  static_assert(ObjectGroup::kLeaf <= SeenBoxes::kMost);
  SeenBoxes boxes;
  std::array<std::uint32_t, SeenBoxes::kMost> at{};
  for (std::uint32_t i = leaf.first; i < leaf.first + leaf.count; ++i) {
    if ((group.mask(i) & options_.mask) == 0) continue;
    if (is_out_of_view(group, i, across)) {
      count(Culled::By::view, 1);
      continue;
    }
    at[boxes.size] = i;
    boxes.add(buffer_.box_picture(), group.outer(i));
  }
  boxes.see(buffer_.box_picture());
  for (std::size_t k = 0; k < boxes.size; ++k) {
    ++stats_.work.cover_tests;
    const float size = buffer_.seen_size(boxes, k);
    if (buffer_.hides(buffer_.footprint(boxes, k))) {
      count(Culled::By::cover, 1);
    } else if (size < options_.least_size) {
      ++stats_.too_small;
    } else {
      draw({group.id(at[k]), size, boxes.distance[k]});
    }
  }
}

bool ObjectListing::is_out_of_view(const ObjectGroup& group, std::uint32_t object, std::uint32_t across) {
  for (std::uint32_t left = across; left != 0; left &= left - 1) {
    const auto plane = static_cast<std::size_t>(std::countr_zero(left));
    ++stats_.work.view_tests;
    const kernel::Relation relation =
        group.ask(object, [&](const auto& box) { return kernel::relation(view_.planes[plane], box, view_.arithmetic); });
    if (relation == kernel::Relation::outside) return true;
  }
  return false;
}

float ObjectListing::size_of(const kernel::Aabb& box) const {
  SeenBoxes boxes;
  boxes.add(buffer_.box_picture(), box);
  boxes.see(buffer_.box_picture());
  return buffer_.seen_size(boxes, 0);
}

}  // namespace occlude::culler
