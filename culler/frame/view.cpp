// SPDX-License-Identifier: MIT
#include <algorithm>
#include <memory>

#include "camera/holds_for.h"
#include "camera/shadow_rule.h"
#include "cover/asked_box.h"
#include "frame/view_memory.h"
#include "model/bounds.h"
#include "occlude/culler/culler.h"
#include "occlude/kernel/shadow_union.h"

namespace occlude::culler {
namespace {

using kernel::Relation;

template <class AnyBox>
bool is_in_shadow(const Frame& frame, const AnyBox& box) {
  const auto hides = [&](const Occluder& o) {
    return decide_cull(o.frustum, box, Asked{}, frame.margin).relation == Relation::inside;
  };
  const auto hide_together = [&](const ShadowPair& pair) {
    const kernel::ShadowUnion both{frame.result.occluders[pair.first].frustum, frame.result.occluders[pair.second].frustum};
    return decide_cull(both, box, Asked{}, frame.margin).relation == Relation::inside;
  };
  return std::ranges::any_of(frame.result.occluders, hides) || std::ranges::any_of(frame.result.pairs, hide_together);
}

}  // namespace

View::View() : memory_(std::make_unique<Memory>()) {}
View::~View() = default;
View::View(View&&) noexcept = default;
View& View::operator=(View&&) noexcept = default;

View::Memory& memory_of(const View& view) { return *view.memory_; }

View::Memory& memory_for(const View& view, const std::shared_ptr<const void>& owner) {
  View::Memory& memory = memory_of(view);
  const bool is_same = !memory.owner.owner_before(owner) && !owner.owner_before(memory.owner);
  if (!is_same) memory = View::Memory();
  memory.owner = owner;
  return memory;
}

const CullResult& View::result() const { return memory_->frame.result; }

Visibility View::visibility(const Box& box) const {
  return visibility_of(box, memory_->frame.view, memory_->frame.result.view, [&](const auto& b) {
    return memory_->frame.result.method == Method::cover ? hides_any(memory_->cover.buffer, b)
                                                         : is_in_shadow(memory_->frame, b);
  });
}

bool View::holds_for(const Camera& camera) const {
  return !result().view.empty() && culler::holds_for(memory_->frame.view, camera);
}
bool View::holds_for(const MatrixCamera& camera) const {
  return !result().view.empty() && culler::holds_for(memory_->frame.view, camera);
}

}  // namespace occlude::culler
