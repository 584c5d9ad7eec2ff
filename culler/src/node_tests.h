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
#include "occlude/kernel/overlap.h"
#include "occlude/kernel/shadow_union.h"
#include "traverse.h"
#include "view_memory.h"

namespace occlude::culler {

/// `Ask` calls a question with the bounding volume of a node; holds_part(node, potential occluder) tells whether one of its
/// items is what the occluder is drawn as; on_shadow_test(occluder, box) is told every test of a shadow.
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
        frame_(memory.result) {
    memory.take_planes();
  }

  kernel::Relation view(std::uint32_t plane, std::uint32_t node) const {
    return ask_(node, [&](const auto& box) { return kernel::relation(planes_[plane], box, options_.arithmetic); });
  }

  /// What is coplanar with an occluder is drawn: the near plane is open. And all that an occluder is drawn as, the faces of
  /// a shell that the eye does not see among it.
  kernel::Relation shadow(std::uint32_t occluder, std::uint32_t node) {
    const kernel::ShadowFrustum& frustum = frame_.occluders[occluder].frustum;
    const kernel::Relation relation = counted(ask_(node, [&](const auto& box) {
      on_shadow_test_(frame_.occluders[occluder], box);
      return kernel::decide(frustum, box, options_.arithmetic, options_.test, kernel::NearBoundary::open);
    }));
    if (relation != kernel::Relation::inside) return relation;
    const bool is_kept = ask_(node, [&](const auto& box) { return frame_.margin.keeps(frustum, box); });
    return is_kept && !holds_part(node, occluder) ? kernel::Relation::inside : kernel::Relation::partial;
  }

  kernel::Relation probe(std::uint32_t probe, std::uint32_t node) const {
    return ask_(node, [&](const auto& box) {
      return kernel::decide(probes_[probe].frustum, box, options_.arithmetic, kernel::Test::conservative,
                            kernel::NearBoundary::open)
          .relation;
    });
  }

  std::size_t pair_work(std::uint32_t first, std::uint32_t second) const {
    return frame_.occluders[first].frustum.plane_count() * frame_.occluders[second].frustum.plane_count();
  }

  kernel::Relation pair(std::uint32_t first, std::uint32_t second, std::uint32_t node) {
    const kernel::ShadowUnion both{frame_.occluders[first].frustum, frame_.occluders[second].frustum};
    const kernel::Relation relation = counted(
        ask_(node, [&](const auto& box) { return kernel::overlap_certified(both, box, kernel::NearBoundary::open); }));
    if (relation != kernel::Relation::inside) return relation;
    const bool is_kept = ask_(node, [&](const auto& box) { return frame_.margin.keeps(both, box); });
    return is_kept && !holds_part(node, first) && !holds_part(node, second) ? kernel::Relation::inside
                                                                            : kernel::Relation::partial;
  }

 private:
  bool holds_part(std::uint32_t node, std::uint32_t occluder) const {
    return holds_part_(node, frame_.occluders[occluder].index);
  }

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
  CullResult& frame_;
};

/// The descent of a frame whose half-spaces and occluders are known.
template <class Ask, class HoldsPart, class OnShadowTest>
void traverse(std::span<const HierarchyNode> nodes, const Ask& ask, const HoldsPart& holds_part,
              const OnShadowTest& on_shadow_test, const CullOptions& options, View::Memory& memory) {
  NodeTests tests(ask, holds_part, on_shadow_test, options, memory);
  Traversal(nodes, tests, memory.probes, memory.result, memory.active, memory.holding).run();
}

}  // namespace occlude::culler
