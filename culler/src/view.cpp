// SPDX-License-Identifier: MIT
#include "occlude/culler/view.h"

#include <algorithm>
#include <atomic>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>

#include "bounds.h"
#include "legal_soup.h"
#include "occlude/kernel/half_space.h"
#include "occlude/kernel/shadow_union.h"
#include "occlude/kernel/validity.h"
#include "outer_box.h"
#include "shadow_rule.h"
#include "view_memory.h"

namespace occlude::culler {
namespace {

using kernel::Relation;

/// The half-spaces have a margin for what reaches as far as the model. For a box that reaches farther they are moved
/// outwards by the margin of that box. This also covers the rounding of the sum, because the offset has room for more
/// roundings than it took. Normals are no longer than 1.
template <class AnyBox>
bool is_out_of_view(const View::Memory& memory, const AnyBox& box) {
  const double own_reach = depth(outer_box(box), memory.view.eye);
  const double farther = own_reach > memory.view.depth ? own_reach : 0;
  for (std::size_t i = 0; i < memory.result.view.size(); ++i) {
    const HalfSpace& h = memory.result.view[i];
    const double offset = h.offset + memory.view.half_space_margins[i] * farther;
    if (kernel::check(offset) != kernel::Refusal::none) continue;
    if (kernel::relation({to_kernel(h.normal), offset}, box, kernel::Arithmetic::certified) == Relation::outside)
      return true;
  }
  return false;
}

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

/// The error bounds of the cover hold within its depth.
bool hides_any(const CoverBuffer& cover, const kernel::Aabb& box) {
  return depth(box, cover.picture().eye()) <= cover.picture().depth() && cover.hides(box);
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
  const auto is_hidden = [&](const auto& b) {
    return memory_->result.method == Method::cover ? hides_any(memory_->cover, outer_box(b))
                                                   : is_in_shadow(memory_->result, b);
  };
  require_rounding();
  return std::visit(
      [&](const auto& b) {
        if (const kernel::Refusal refusal = kernel::check(b); refusal != kernel::Refusal::none) {
          throw std::invalid_argument(std::string(kernel::to_string(refusal)));
        }
        return is_out_of_view(*memory_, b) ? Visibility::out_of_view
               : is_hidden(b)              ? Visibility::occluded
                                           : Visibility::visible;
      },
      box);
}

void View::Memory::take_planes() {
  planes.clear();
  for (const HalfSpace& h : result.view) planes.push_back({to_kernel(h.normal), h.offset});
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

}  // namespace occlude::culler
