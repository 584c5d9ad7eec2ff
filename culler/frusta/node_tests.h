// SPDX-License-Identifier: MIT
// The kernel's questions about the nodes of a tree, as the traversal asks them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "camera/shadow_rule.h"
#include "descent/parallel_traversal.h"
#include "descent/volumes.h"
#include "frusta/frusta_memory.h"
#include "frusta/occluder_set.h"
#include "model/block_tree.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/kernel/box_block.h"
#include "occlude/kernel/shadow_union.h"

namespace occlude::culler {

/// on_shadow_tests(block, questions, nodes) is called for the nodes of a block that were tested against shadows of
/// occluders.
template <class OnShadowTests>
class NodeTests {
 public:
  NodeTests(const Hierarchy& hierarchy, const OccluderSet* occluders, const OnShadowTests& on_shadow_tests,
            const CullOptions& options, Frame& frame, FrustaMemory& memory)
      : on_shadow_tests_(on_shadow_tests),
        options_(options),
        volumes_(hierarchy, frame.view_planes(options.arithmetic)),
        shrunk_(memory.shrunk),
        casters_(memory.casters),
        frusta_(memory.frusta),
        margin_(frame.margin) {
    memory.shrink_shadows(frame);
    memory.take_casters(frame.result, occluders, options.shadow_near);
  }

  [[nodiscard]] const ViewPlanes& view() const { return volumes_.view(); }
  [[nodiscard]] kernel::BlockRelations planes(const TreeBlock& block, kernel::BoxBytes asked) const {
    return volumes_.relations(block, asked);
  }

  /// What the filter cannot tell is left to shadow() and probe().
  void filter(const TreeBlock& block, kernel::BlockQuestions& questions, kernel::BoxBytes of_occluders) const {
    kernel::conservative_filter(frusta_, block.boxes, questions);
    const kernel::BoxBytes alone = kernel::for_all(volumes_.alone(block));
    const bool is_overlap = options_.test == kernel::Test::overlap;
    if (alone == 0 && !is_overlap) return;
    questions.outside &= ~alone;
    questions.inside &= ~alone;
    questions.unknown |= alone;
    if (!is_overlap) return;
    // The profile of an occluder's shadow may be beyond a box that the planes straddle. Probes are asked by planes alone.
    questions.unknown |= of_occluders & kernel::for_all(block.used) & ~(questions.outside | questions.inside);
  }

  kernel::Decision shadow(std::uint32_t occluder, const TreeBlock& block, std::uint32_t i) const {
    const bool holds_part = this->holds_part(occluder, block, i);
    if (holds_part && is_surface(occluder)) return {kernel::Relation::partial, kernel::Stage::filter};
    return volumes_.ask(block, i, [&](const auto& box) {
      return decide_cull(*frusta_[occluder], box, {options_.arithmetic, options_.test}, shrunk_[occluder],
                         [&] { return holds_part; });
    });
  }

  bool may_cull(std::uint32_t occluder, const TreeBlock& block, std::uint32_t i) const {
    return volumes_.ask(block, i, [&](const auto& box) {
      return is_cull(*frusta_[occluder], box, shrunk_[occluder], [&] { return holds_part(occluder, block, i); });
    });
  }

  /// A probe hides nothing, so its answer may be approximate: neither the margin nor its own parts are considered.
  kernel::Decision probe(std::uint32_t probe, const TreeBlock& block, std::uint32_t i) const {
    if (is_surface(probe) && holds_part(probe, block, i)) return {kernel::Relation::partial, kernel::Stage::filter};
    return volumes_.ask(block, i, [&](const auto& box) {
      return decide_cull(*frusta_[probe], box, {.arithmetic = options_.arithmetic}, ShadowMargin());
    });
  }

  std::size_t pair_work(std::uint32_t first, std::uint32_t second) const {
    return frusta_[first]->plane_count() * frusta_[second]->plane_count();
  }

  kernel::Decision pair(std::uint32_t first, std::uint32_t second, const TreeBlock& block, std::uint32_t i) const {
    return volumes_.ask(block, i, [&](const auto& box) {
      return decide_cull(kernel::ShadowUnion{*frusta_[first], *frusta_[second]}, box, Asked{}, margin_,
                         [&] { return holds_part(first, block, i) || holds_part(second, block, i); });
    });
  }

  void tested(const TreeBlock& block, const kernel::BlockQuestions& questions, kernel::BoxBytes nodes) const {
    on_shadow_tests_(block, questions, nodes);
  }

 private:
  /// Whether a part of the occluder is in the node.
  [[nodiscard]] bool holds_part(std::uint32_t frustum, const TreeBlock& block, std::uint32_t i) const {
    const auto parts = casters_[frustum].parts;
    if (parts.size() == 1) return parts[0] - block.begin[i] < block.count(i);  // most are polygons
    const auto part = std::ranges::lower_bound(parts, block.begin[i]);
    return part != parts.end() && *part - block.begin[i] < block.count(i);
  }
  /// Whether the parts are in the surface at which the shadow begins. A box that holds one meets the shadow, and is not
  /// beyond the near plane.
  [[nodiscard]] bool is_surface(std::uint32_t frustum) const { return is_certified() && casters_[frustum].are_surface; }
  [[nodiscard]] bool is_certified() const { return options_.arithmetic == kernel::Arithmetic::certified; }

  const OnShadowTests& on_shadow_tests_;
  const CullOptions& options_;
  const Volumes volumes_;
  const std::vector<ShrunkShadow>& shrunk_;
  const std::vector<ShadowCaster>& casters_;
  const std::vector<const kernel::ShadowFrustum*>& frusta_;
  const ShadowMargin& margin_;
};

/// One descent of the tree, for a frame whose half-spaces and occluders are known. `occluders` may be null if it has none.
template <class OnShadowTests>
void traverse(const BlockTree& tree, const Hierarchy& hierarchy, const OccluderSet* occluders,
              const OnShadowTests& on_shadow_tests, const CullOptions& options, Frame& frame, FrustaMemory& memory) {
  // Memory for the stacks: all occluders and probes that a frame may have, at each level of the deepest trees. The tree of
  // ten million polygons has some 40 levels of nodes, and fewer of blocks.
  constexpr std::size_t kLevels = 64;
  const std::size_t most = frame.result.occluders.capacity() + memory.probes.capacity();
  memory.traversal.active.reserve(kLevels * (most / kernel::BlockQuestions::kMost + 2));
  memory.traversal.holding.reserve(kLevels * memory.probes.capacity());
  memory.traversal.hidden.reserve(most);
  frame.planes.reserve(frame.result.view.size());
  memory.frusta.reserve(most);
  memory.casters.reserve(most);
  NodeTests tests(hierarchy, occluders, on_shadow_tests, options, frame, memory);
  const auto size = [](const std::vector<Occluder>& shadows) { return static_cast<std::uint32_t>(shadows.size()); };
  const ShadowCounts shadows{size(frame.result.occluders), size(memory.probes)};
  ParallelTraversal(tree, tests, shadows, frame.result, memory.traversal, memory.parts, memory.runner)
      .run(tests.view().all(), options.executor);
  const std::uint32_t* hidden = memory.traversal.hidden.data();
  for (Occluder& occluder : frame.result.occluders) occluder.hidden = *hidden++;
  for (Occluder& probe : memory.probes) probe.hidden = *hidden++;
}

}  // namespace occlude::culler
