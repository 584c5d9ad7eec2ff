// SPDX-License-Identifier: MIT
#include "scene/object_listing.h"

#include <bit>

#include "cover/cover_descent.h"
#include "cover/projected_boxes.h"

namespace occlude::culler {

/// The objects of a group, for a descent of its tree.
class ObjectListing::Objects : public StandingNodes {
 public:
  Objects(ObjectListing& listing, const ObjectGroup& group) : listing_(listing), group_(group) {}

  kernel::BoxBits asked(const TreeBlock& block) {
    if (block.divided != 0) return block.used;
    const ObjectGroup::Kinds kinds = group_.kinds(block.begin[0], listing_.options_.mask);
    oriented_ = kinds.oriented;
    return kinds.in_layers;
  }

  /// An oriented object may be beyond a plane that its box straddles.
  [[nodiscard]] kernel::BlockRelations relations(const TreeBlock& block, const kernel::BoxBlock& boxes,
                                                 kernel::BoxBytes asked) const {
    kernel::BlockRelations relations = kernel::relations(listing_.view_.planes, boxes, asked);
    if (block.divided != 0 || oriented_ == 0) return relations;
    const kernel::BoxBytes straddled = asked & kernel::for_all(oriented_) & ~(relations.outside | relations.inside);
    for (kernel::BoxBytes left = straddled; left != 0; left &= left - 1) {
      const auto place = static_cast<std::uint32_t>(std::countr_zero(left));
      const bool is_beyond = listing_.is_beyond(place / 8, *group_.oriented(block.begin[0] + place % 8));
      relations.outside |= kernel::BoxBytes{is_beyond} << place;
    }
    return relations;
  }

  void prefetch(const ItemRange& objects) const {
    if (objects.count <= TreeBlock::kNodes) group_.prefetch(objects.first);
  }
  static bool is_few(const ItemRange&) { return true; }

  void cull(const TreeBlock& block, std::uint32_t i, const Culled& culled) {
    listing_.count(culled.by, group_.count(block.items(i), listing_.options_.mask));
    if (listing_.keeps(culled.by)) listing_.keep(block.boxes.box(i), group_, block.items(i));
  }
  void hide(const ProjectedBoxes& boxes, kernel::BoxBits hidden) { listing_.hide(boxes, hidden); }

  template <class Boxes>
  bool decide(const TestedBlock<Boxes>& tested, std::uint32_t i) {
    if (!tested.block.is_leaf(i)) return true;
    const std::uint32_t object = tested.block.begin[i];
    if (&listing_.hiding_ == &listing_.own_) {
      draw(object, tested.seen, i);
    } else {
      draw(object, listing_.seen(group_.outer(object)), 0);
    }
    return false;
  }

 private:
  /// Lists the object unless it is too small. It is box i of these.
  void draw(std::uint32_t object, const ProjectedBoxes& seen, std::size_t i) {
    const float size = listing_.own_.seen_size(seen, i);
    if (size < listing_.options_.least_size) {
      ++listing_.stats_.too_small;
    } else {
      listing_.draw({group_.id(object), size, seen.distance[i]});
    }
  }

  ObjectListing& listing_;
  const ObjectGroup& group_;
  kernel::BoxBits oriented_ = 0;  ///< of those asked last
};

void ObjectListing::list(const ObjectGroup& group, std::uint32_t straddled_planes) {
  Objects objects(*this, group);
  CoverDescent(group.tree().tree(), hiding_, stats_.work, objects).run(straddled_planes);
}

std::optional<Box> ObjectListing::beyond(std::uint32_t plane, const ObjectGroup& group, std::uint32_t object) const {
  if (const kernel::Aabb outer = group.outer(object); is_beyond(plane, outer)) return outer;
  if (const auto oriented = group.oriented(object); oriented && is_beyond(plane, *oriented)) return *oriented;
  return std::nullopt;
}

ProjectedBoxes ObjectListing::seen(const kernel::Aabb& box) const {
  ProjectedBoxes boxes;
  boxes.add(own_.box_picture(), box);
  boxes.project(own_.box_picture());
  return boxes;
}

float ObjectListing::size_of(const kernel::Aabb& box) const { return own_.seen_size(seen(box), 0); }

}  // namespace occlude::culler
