// SPDX-License-Identifier: MIT
#include "scene/thing_group.h"

#include <algorithm>
#include <variant>

#include "model/bounds.h"
#include "model/outer_box.h"

namespace occlude::culler {
namespace {

constexpr std::uint32_t kAllLayers = ~std::uint32_t{0};

template <class T>
std::size_t capacity_of(const std::vector<T>& v) {
  return v.capacity() * sizeof(T);
}

}  // namespace

std::span<const std::uint32_t> GroupBuilder::sort(bool is_lasting) {
  if (is_lasting) {
    split.sort(boxes);
    return split.order();
  }
  curve.sort(boxes);
  return curve.order();
}

template <SceneKind kOf>
void ThingGroup<kOf>::assign(std::span<const Thing> things, bool is_lasting, GroupBuilder& builder) {
  clear();
  builder.boxes.clear();
  for (const Thing& thing : things) builder.boxes.push_back(outer_box(thing.box));
  const std::span<const std::uint32_t> order = builder.sort(is_lasting);
  tree_.build(builder.boxes, order);
  places_.reserve(things.size());
  for (const std::uint32_t from : order) {
    const Thing& thing = things[from];
    const auto* const oriented = std::get_if<kernel::Obb>(&thing.box);
    const std::uint32_t k = oriented == nullptr ? kNone : static_cast<std::uint32_t>(oriented_.size());
    if (oriented != nullptr) oriented_.push_back(*oriented);
    places_.push_back({thing.id, thing.mask, k});
    is_in_all_layers_ = is_in_all_layers_ && thing.mask == kAllLayers;
  }
  living_ = things.size();
  box_ = tree_.box();
}

template <SceneKind kOf>
void ThingGroup<kOf>::clear() {
  tree_.clear();
  places_.clear();
  oriented_.clear();
  living_ = 0;
  is_box_loose_ = false;
  is_in_all_layers_ = true;
}

template <SceneKind kOf>
void ThingGroup<kOf>::remove(std::uint32_t i) {
  places_[i].id = {};
  places_[i].mask = 0;
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
  places_[i].mask = mask;
  is_in_all_layers_ = is_in_all_layers_ && mask == kAllLayers;
}

template <SceneKind kOf>
void ThingGroup<kOf>::append_living(std::vector<Thing>& things) const {
  for (std::uint32_t i = 0; i < size(); ++i) {
    if (id(i).is_none()) continue;
    things.push_back({id(i), mask(i), ask(i, [](const auto& box) -> Box { return box; })});
  }
}

template <SceneKind kOf>
std::size_t ThingGroup<kOf>::bytes() const {
  return tree_.bytes() + capacity_of(places_) + capacity_of(oriented_);
}

template <SceneKind kOf>
typename ThingGroup<kOf>::Kinds ThingGroup<kOf>::kinds(std::uint32_t first, std::uint32_t mask) const {
  const auto places = std::span(places_).subspan(first, std::min<std::size_t>(size() - first, TreeBlock::kNodes));
  if (oriented_.empty() && is_whole(mask)) return {static_cast<kernel::BoxBits>((1U << places.size()) - 1), 0};
  Kinds kinds;
  for (std::size_t i = 0; i < places.size(); ++i) {
    kinds.in_layers |= static_cast<kernel::BoxBits>(((places[i].mask & mask) != 0 ? 1U : 0U) << i);
    kinds.oriented |= static_cast<kernel::BoxBits>((places[i].oriented != kNone ? 1U : 0U) << i);
  }
  return kinds;
}

template <SceneKind kOf>
std::size_t ThingGroup<kOf>::count_one_by_one(const ItemRange& things, std::uint32_t mask) const {
  const auto places = std::span(places_).subspan(things.first, things.count);
  return static_cast<std::size_t>(
      std::ranges::count_if(places, [&](const Place& place) { return (place.mask & mask) != 0; }));
}

template class ThingGroup<SceneKind::object>;
template class ThingGroup<SceneKind::occluder>;

}  // namespace occlude::culler
