// SPDX-License-Identifier: MIT
#include "object_group.h"

#include <algorithm>
#include <variant>

#include "bounds.h"
#include "outer_box.h"

namespace occlude::culler {
namespace {

constexpr std::uint32_t kAllLayers = ~std::uint32_t{0};

template <class T>
std::size_t capacity_of(const std::vector<T>& v) {
  return v.capacity() * sizeof(T);
}

}  // namespace

void ObjectGroup::assign(std::span<const SceneObject> objects, GroupBuilder& builder) {
  clear();
  builder.boxes.clear();
  for (const SceneObject& object : objects) builder.boxes.push_back(outer_box(object.box));
  builder.tree.build(builder.boxes, kLeaf);
  // A tree of full leaves has a node for four objects; most have leaves that are half full. With this room, another tree of
  // as many objects hardly ever needs more.
  nodes_.reserve(objects.size() / 2 + 1);
  nodes_.assign(builder.tree.nodes().begin(), builder.tree.nodes().end());
  places_.reserve(objects.size());
  for (const std::uint32_t from : builder.tree.order()) {
    const SceneObject& object = objects[from];
    const auto* const oriented = std::get_if<kernel::Obb>(&object.box);
    const std::uint32_t k = oriented == nullptr ? kNone : static_cast<std::uint32_t>(oriented_.size());
    if (oriented != nullptr) oriented_.push_back(*oriented);
    places_.push_back({builder.boxes[from], object.id, object.mask, k});
    is_in_all_layers_ = is_in_all_layers_ && object.mask == kAllLayers;
  }
  living_ = objects.size();
  if (living_ > 0) box_ = nodes_[0].box;
}

void ObjectGroup::clear() {
  nodes_.clear();
  places_.clear();
  oriented_.clear();
  living_ = 0;
  is_box_loose_ = false;
  is_in_all_layers_ = true;
}

void ObjectGroup::remove(std::uint32_t i) {
  places_[i].id = {};
  places_[i].mask = 0;
  is_box_loose_ = true;
  --living_;
}

void ObjectGroup::fit_box() {
  if (!is_box_loose_) return;
  is_box_loose_ = false;
  box_ = empty_box();
  for (const Place& place : places_) {
    if (!place.id.is_none()) grow(box_, place.outer);
  }
}

void ObjectGroup::set_mask(std::uint32_t i, std::uint32_t mask) {
  places_[i].mask = mask;
  is_in_all_layers_ = is_in_all_layers_ && mask == kAllLayers;
}

void ObjectGroup::append_living(std::vector<SceneObject>& objects) const {
  for (std::uint32_t i = 0; i < size(); ++i) {
    if (id(i).is_none()) continue;
    objects.push_back({id(i), mask(i), ask(i, [](const auto& box) -> Box { return box; })});
  }
}

std::size_t ObjectGroup::bytes() const { return capacity_of(nodes_) + capacity_of(places_) + capacity_of(oriented_); }

std::size_t ObjectGroup::count(const HierarchyNode& node, std::uint32_t mask) const {
  if (is_in_all_layers_ && living_ == size() && mask != 0) return node.count;
  const auto places = std::span(places_).subspan(node.first, node.count);
  return static_cast<std::size_t>(
      std::ranges::count_if(places, [&](const Place& place) { return (place.mask & mask) != 0; }));
}

}  // namespace occlude::culler
