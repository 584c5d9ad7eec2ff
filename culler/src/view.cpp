// SPDX-License-Identifier: MIT
#include "occlude/culler/view.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "asked_box.h"
#include "bounds.h"
#include "occlude/kernel/shadow_union.h"
#include "shadow_rule.h"
#include "view_memory.h"

namespace occlude::culler {
namespace {

using kernel::Relation;

template <class AnyBox>
bool is_in_shadow(const CullResult& frame, const AnyBox& box) {
  const auto hides = [&](const Occluder& o) {
    return decide_cull(o.frustum, box, Asked{}, frame.margin).relation == Relation::inside;
  };
  const auto hide_together = [&](const ShadowPair& pair) {
    const kernel::ShadowUnion both{frame.occluders[pair.first].frustum, frame.occluders[pair.second].frustum};
    return decide_cull(both, box, Asked{}, frame.margin).relation == Relation::inside;
  };
  return std::ranges::any_of(frame.occluders, hides) || std::ranges::any_of(frame.pairs, hide_together);
}

}  // namespace

Identity::Identity() {
  static std::atomic<std::uint64_t> made = 0;
  number_ = ++made;
}

View::View() : memory_(std::make_unique<Memory>()) {}
View::~View() = default;
View::View(View&&) noexcept = default;
View& View::operator=(View&&) noexcept = default;

View::Memory& View::memory_for(const Identity& owner) {
  if (owner_ != owner) *memory_ = Memory();
  owner_ = owner;
  return *memory_;
}

const CullResult& View::result() const { return memory_->result; }

Visibility View::visibility(const Box& box) const {
  return visibility_of(box, memory_->view, memory_->result.view, [&](const auto& b) {
    return memory_->result.method == Method::cover ? hides_any(memory_->cover.buffer, b) : is_in_shadow(memory_->result, b);
  });
}

void View::Memory::take_planes() {
  planes.clear();
  for (const HalfSpace& h : result.view) planes.push_back({to_kernel(h.normal), h.offset});
}

void View::Memory::take_casters(const OccluderSet* occluders, kernel::Near near) {
  frusta.clear();
  casters.clear();
  for (const auto* used : {&result.occluders, &probes}) {
    for (const auto& [index, frustum, hidden] : *used) {
      frusta.push_back(&frustum);
      const bool is_flat = !frustum.support_plane() && !occluders->is_shell(index);
      casters.push_back({occluders->parts(index), near == kernel::Near::surface && is_flat});
    }
  }
}

void View::Memory::shrink_shadows() {
  shrunk.resize(std::max(shrunk.size(), result.occluders.size()));
  for (std::size_t i = 0; i < result.occluders.size(); ++i) shrunk[i].assign(result.margin, result.occluders[i].frustum);
}

void View::Memory::begin_frame(std::size_t nodes) {
  for (Occluder& occluder : result.occluders) spare.push_back(std::move(occluder.frustum));
  for (Occluder& occluder : probes) spare.push_back(std::move(occluder.frustum));
  probes.clear();
  result.drawn.clear();
  result.culled.clear();
  result.view.clear();
  result.occluders.clear();
  result.pairs.clear();
  result.stats = {};
  // Drawn and culled subtrees have no leaf in common, and between two drawn ranges something is culled.
  const std::size_t leaves = (nodes + 1) / 2;
  result.drawn.reserve((leaves + 1) / 2);
  result.culled.reserve(leaves);
}

void View::Memory::draw_all(const PolygonRange& polygons) {
  result.culled.clear();
  result.drawn.assign(1, polygons);
  result.stats.drawn_polygons = polygons.count;
  result.stats.view_culled_polygons = result.stats.shadow_culled_polygons = 0;
}

}  // namespace occlude::culler
