// SPDX-License-Identifier: MIT
// The kernel's questions about the nodes of a tree, as the traversal asks them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "bounds.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/kernel/half_space.h"
#include "occlude/kernel/shadow_union.h"
#include "shadow_rule.h"
#include "traverse.h"
#include "view_memory.h"

namespace occlude::culler {

/// `Ask` calls a question with the bounding volume of a node. holds_part(node, potential occluder) says whether a part of
/// the occluder is in the node. on_shadow_test(occluder, box) is called at every test of a shadow.
template <class Ask, class HoldsPart, class OnShadowTest>
class NodeTests {
 public:
  NodeTests(const Ask& ask, const HoldsPart& holds_part, const OnShadowTest& on_shadow_test, const CullOptions& options,
            View::Memory& memory)
      : ask_(ask),
        holds_part_(holds_part),
        on_shadow_test_(on_shadow_test),
        options_(options),
        planes_(memory.planes),
        probes_(memory.probes),
        shrunk_(memory.shrunk),
        frame_(memory.result) {
    memory.take_planes();
    memory.shrink_shadows();
  }

  kernel::Relation view(std::uint32_t plane, std::uint32_t node) const {
    return ask_(node, [&](const auto& box) { return kernel::relation(planes_[plane], box, options_.arithmetic); });
  }

  kernel::Relation shadow(std::uint32_t occluder, std::uint32_t node) {
    const Occluder& by = frame_.occluders[occluder];
    return counted(ask_(node, [&](const auto& box) {
      on_shadow_test_(by, box);
      return decide_cull(by.frustum, box, {options_.arithmetic, options_.test}, shrunk_[occluder],
                         [&] { return holds_part_(node, by.index); });
    }));
  }

  /// A probe hides nothing, so its answer may be approximate: neither the margin nor its own parts are considered.
  kernel::Relation probe(std::uint32_t probe, std::uint32_t node) const {
    return ask_(node, [&](const auto& box) {
      return decide_cull(probes_[probe].frustum, box, {.arithmetic = options_.arithmetic}, ShadowMargin()).relation;
    });
  }

  std::size_t pair_work(std::uint32_t first, std::uint32_t second) const {
    return frame_.occluders[first].frustum.plane_count() * frame_.occluders[second].frustum.plane_count();
  }

  kernel::Relation pair(std::uint32_t first, std::uint32_t second, std::uint32_t node) {
    const Occluder &a = frame_.occluders[first], &b = frame_.occluders[second];
    return counted(ask_(node, [&](const auto& box) {
      return decide_cull(kernel::ShadowUnion{a.frustum, b.frustum}, box, Asked{}, frame_.margin,
                         [&] { return holds_part_(node, a.index) || holds_part_(node, b.index); });
    }));
  }

 private:
  kernel::Relation counted(const kernel::Decision& decision) {
    if (decision.stage == kernel::Stage::exact) ++frame_.stats.exact_shadow_tests;
    return decision.relation;
  }

  const Ask& ask_;
  const HoldsPart& holds_part_;
  const OnShadowTest& on_shadow_test_;
  const CullOptions& options_;
  const std::vector<kernel::HalfSpace>& planes_;
  const std::vector<Occluder>& probes_;
  const std::vector<ShrunkShadow>& shrunk_;
  CullResult& frame_;
};

/// One descent of the tree, for a frame whose half-spaces and occluders are known.
template <class Ask, class HoldsPart, class OnShadowTest>
void traverse(std::span<const HierarchyNode> nodes, const Ask& ask, const HoldsPart& holds_part,
              const OnShadowTest& on_shadow_test, const CullOptions& options, View::Memory& memory) {
  // Memory for the stacks: all planes, occluders and probes that a frame may have, at each level of the deepest trees. The
  // tree of ten million polygons has some 40 levels.
  constexpr std::size_t kLevels = 64;
  const std::size_t most = memory.result.occluders.capacity() + memory.probes.capacity();
  memory.active.reserve(kLevels * (memory.result.view.size() + most));
  memory.holding.reserve(memory.probes.capacity());
  memory.planes.reserve(memory.result.view.size());
  NodeTests tests(ask, holds_part, on_shadow_test, options, memory);
  Traversal(nodes, tests, memory.probes, memory.result, memory.active, memory.holding).run();
}

}  // namespace occlude::culler
