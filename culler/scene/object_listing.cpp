// SPDX-License-Identifier: MIT
#include "scene/object_listing.h"

#include "base/each_bit.h"
#include "cover/projected_boxes.h"
#include "occlude/kernel/half_space.h"
#include "scene/packed_descent.h"

namespace occlude::culler {

/// The objects of a group, for a descent of its tree.
class ObjectListing::Objects {
 public:
  Objects(ObjectListing& listing, const ObjectGroup& group) : listing_(listing), group_(group) {}

  kernel::BoxBits asked(std::uint32_t first) {
    const ObjectGroup::Kinds kinds = group_.kinds(first, listing_.options_.mask);
    oriented_ = kinds.oriented;
    return kinds.in_layers;
  }

  [[nodiscard]] kernel::BoxBits beyond(std::uint32_t first, std::uint32_t plane, kernel::BoxBits boxes) const {
    unsigned beyond = 0;
    for_each_bit(boxes & oriented_,
                 [&](std::uint32_t i) { beyond |= (listing_.is_beyond(plane, group_, first + i) ? 1U : 0U) << i; });
    return static_cast<kernel::BoxBits>(beyond);
  }

  void prefetch(std::uint32_t first) const { group_.prefetch(first); }

  void cull(Culled::By by, const PackedTree::Items& objects) {
    listing_.count(by, group_.count(objects, listing_.options_.mask));
  }

  void see(std::uint32_t object, const ProjectedBoxes& boxes, std::uint32_t i, std::uint32_t /*straddled_planes*/) {
    const float size = listing_.buffer_.seen_size(boxes, i);
    if (size < listing_.options_.least_size) {
      ++listing_.stats_.too_small;
    } else {
      listing_.draw({group_.id(object), size, boxes.distance[i]});
    }
  }

 private:
  ObjectListing& listing_;
  const ObjectGroup& group_;
  kernel::BoxBits oriented_ = 0;  ///< of those asked last
};

void ObjectListing::list(const ObjectGroup& group, std::uint32_t straddled_planes) {
  Objects objects(*this, group);
  PackedDescent(group.tree(), view_, buffer_, stats_.work, objects).run(straddled_planes);
}

bool ObjectListing::is_beyond(std::uint32_t plane, const ObjectGroup& group, std::uint32_t object) const {
  return group.ask(object, [&](const auto& box) {
    return kernel::relation(view_.planes[plane], box, view_.arithmetic) == kernel::Relation::outside;
  });
}

float ObjectListing::size_of(const kernel::Aabb& box) const {
  ProjectedBoxes boxes;
  boxes.add(buffer_.box_picture(), box);
  boxes.project(buffer_.box_picture());
  return buffer_.seen_size(boxes, 0);
}

}  // namespace occlude::culler
