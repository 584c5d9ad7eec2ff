// SPDX-License-Identifier: MIT
#include "occlude/culler/view.h"

#include <algorithm>
#include <atomic>
#include <utility>

#include "camera/shadow_rule.h"
#include "cover/asked_box.h"
#include "frame/view_memory.h"
#include "model/bounds.h"
#include "occlude/kernel/shadow_union.h"

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

const CullResult& View::result() const { return memory_->frame.result; }

Visibility View::visibility(const Box& box) const {
  return visibility_of(box, memory_->frame.view, memory_->frame.result.view, [&](const auto& b) {
    return memory_->frame.result.method == Method::cover ? hides_any(memory_->cover.buffer, b)
                                                         : is_in_shadow(memory_->frame.result, b);
  });
}

}  // namespace occlude::culler
