// SPDX-License-Identifier: MIT
#include "scene/thing_group.h"

#include <algorithm>

#include "model/bounds.h"

namespace occlude::culler {
namespace {

constexpr std::uint32_t kAllLayers = ~std::uint32_t{0};

template <class T>
std::size_t capacity_of(const std::vector<T>& v) {
  return v.capacity() * sizeof(T);
}

}  // namespace

std::span<const std::uint32_t> GroupBuilder::sort(std::span<const kernel::Aabb> boxes, bool is_lasting) {
  if (is_lasting) {
    split.sort(boxes);
    return split.order();
  }
  curve.sort(boxes);
  return curve.order();
}

template <SceneKind kOf>
void ThingGroup<kOf>::assign(std::span<const kernel::Aabb> boxes, std::span<const Thing> things, bool is_lasting,
                             GroupBuilder& builder) {
  clear();
  const std::span<const std::uint32_t> order = builder.sort(boxes, is_lasting);
  tree_.build(boxes, order);
  ids_.reserve(things.size());
  masks_.reserve(things.size());
  bool is_oriented = false;
  for (const std::uint32_t from : order) {
    const Thing& thing = things[from];
    ids_.push_back(thing.id);
    masks_.push_back(thing.mask);
    is_oriented = is_oriented || !thing.edges.is_none();
    is_in_all_layers_ = is_in_all_layers_ && thing.mask == kAllLayers;
  }
  if (is_oriented) {
    edges_.reserve(things.size());
    for (const std::uint32_t from : order) edges_.push_back(things[from].edges);
  }
  living_ = things.size();
  box_ = tree_.box();
}

template <SceneKind kOf>
void ThingGroup<kOf>::clear() {
  tree_.clear();
  ids_.clear();
  masks_.clear();
  edges_.clear();
  living_ = 0;
  is_box_loose_ = false;
  is_in_all_layers_ = true;
}

template <SceneKind kOf>
void ThingGroup<kOf>::remove(std::uint32_t i) {
  ids_[i] = {};
  masks_[i] = 0;
  is_box_loose_ = true;
  --living_;
}

template <SceneKind kOf>
void ThingGroup<kOf>::fit_box() {
  if (!is_box_loose_) return;
  is_box_loose_ = false;
  box_ = empty_box();
  for (std::uint32_t i = 0; i < size(); ++i) {
    if (!id(i).is_none()) grow(box_, outer(i));
  }
}

template <SceneKind kOf>
void ThingGroup<kOf>::set_mask(std::uint32_t i, std::uint32_t mask) {
  masks_[i] = mask;
  is_in_all_layers_ = is_in_all_layers_ && mask == kAllLayers;
}

template <SceneKind kOf>
void ThingGroup<kOf>::append_living(ThingList<kOf>& things) const {
  for (std::uint32_t i = 0; i < size(); ++i) {
    if (!id(i).is_none()) things.push_back(outer(i), {id(i), mask(i), is_oriented(i) ? edges_[i] : PackedEdges()});
  }
}

template <SceneKind kOf>
std::size_t ThingGroup<kOf>::bytes() const {
  return tree_.bytes() + capacity_of(ids_) + capacity_of(masks_) + capacity_of(edges_);
}

template <SceneKind kOf>
typename ThingGroup<kOf>::Kinds ThingGroup<kOf>::kinds(std::uint32_t first, std::uint32_t mask) const {
  const std::size_t count = std::min<std::size_t>(size() - first, TreeBlock::kNodes);
  if (edges_.empty() && is_whole(mask)) return {static_cast<kernel::BoxBits>((1U << count) - 1), 0};
  Kinds kinds;
  for (std::size_t i = 0; i < count; ++i) {
    kinds.in_layers |= static_cast<kernel::BoxBits>(((masks_[first + i] & mask) != 0 ? 1U : 0U) << i);
    kinds.oriented |= static_cast<kernel::BoxBits>((is_oriented(first + i) ? 1U : 0U) << i);
  }
  return kinds;
}

template <SceneKind kOf>
std::size_t ThingGroup<kOf>::count_one_by_one(const ItemRange& things, std::uint32_t mask) const {
  const auto masks = std::span(masks_).subspan(things.first, things.count);
  return static_cast<std::size_t>(std::ranges::count_if(masks, [&](std::uint32_t of) { return (of & mask) != 0; }));
}

template class ThingGroup<SceneKind::object>;
template class ThingGroup<SceneKind::occluder>;

}  // namespace occlude::culler
