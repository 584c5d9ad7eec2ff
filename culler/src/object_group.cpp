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
  ids_.reserve(objects.size());
  masks_.reserve(objects.size());
  outer_.reserve(objects.size());
  const bool is_any_oriented =
      std::ranges::any_of(objects, [](const SceneObject& o) { return std::holds_alternative<kernel::Obb>(o.box); });
  for (const std::uint32_t from : builder.tree.order()) {
    const SceneObject& object = objects[from];
    ids_.push_back(object.id);
    masks_.push_back(object.mask);
    outer_.push_back(builder.boxes[from]);
    is_in_all_layers_ = is_in_all_layers_ && object.mask == kAllLayers;
    if (!is_any_oriented) continue;
    const auto* const oriented = std::get_if<kernel::Obb>(&object.box);
    oriented_.push_back(oriented == nullptr ? kNone : static_cast<std::uint32_t>(oriented_boxes_.size()));
    if (oriented != nullptr) oriented_boxes_.push_back(*oriented);
  }
  living_ = objects.size();
  if (living_ > 0) box_ = nodes_[0].box;
}

void ObjectGroup::clear() {
  nodes_.clear();
  ids_.clear();
  masks_.clear();
  outer_.clear();
  oriented_.clear();
  oriented_boxes_.clear();
  living_ = 0;
  is_box_loose_ = false;
  is_in_all_layers_ = true;
}

void ObjectGroup::remove(std::uint32_t i) {
  ids_[i] = {};
  masks_[i] = 0;
  is_in_all_layers_ = false;
  is_box_loose_ = true;
  --living_;
}

void ObjectGroup::fit_box() {
  if (!is_box_loose_) return;
  is_box_loose_ = false;
  box_ = empty_box();
  for (std::size_t i = 0; i < ids_.size(); ++i) {
    if (!ids_[i].is_none()) grow(box_, outer_[i]);
  }
}

void ObjectGroup::set_mask(std::uint32_t i, std::uint32_t mask) {
  masks_[i] = mask;
  is_in_all_layers_ = is_in_all_layers_ && mask == kAllLayers;
}

void ObjectGroup::append_living(std::vector<SceneObject>& objects) const {
  for (std::uint32_t i = 0; i < ids_.size(); ++i) {
    if (ids_[i].is_none()) continue;
    objects.push_back({ids_[i], masks_[i], ask(i, [](const auto& box) -> Box { return box; })});
  }
}

std::size_t ObjectGroup::bytes() const {
  return capacity_of(nodes_) + capacity_of(ids_) + capacity_of(masks_) + capacity_of(outer_) + capacity_of(oriented_) +
         capacity_of(oriented_boxes_);
}

std::size_t ObjectGroup::count(const HierarchyNode& node, std::uint32_t mask) const {
  if (is_in_all_layers_ && mask != 0) return node.count;
  const auto begin = masks_.begin() + node.first;
  return static_cast<std::size_t>(
      std::count_if(begin, begin + node.count, [&](std::uint32_t m) { return (m & mask) != 0; }));
}

}  // namespace occlude::culler
