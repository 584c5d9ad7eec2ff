// SPDX-License-Identifier: MIT
// The kernel's questions about the nodes of a tree, as the traversal asks them.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "bounds.h"
#include "node_blocks.h"
#include "occlude/culler/cull_result.h"
#include "occlude/kernel/box_block.h"
#include "occlude/kernel/half_space.h"
#include "occlude/kernel/shadow_union.h"
#include "shadow_rule.h"
#include "traverse.h"
#include "view_memory.h"

namespace occlude::culler {

/// `Ask` calls a question with the bounding volume of a node. holds_part(node, potential occluder) says whether a part of
/// the occluder is in the node. on_shadow_test(occluder, box) is called for every test of a shadow.
template <class Ask, class HoldsPart, class OnShadowTests>
class NodeTests {
 public:
  NodeTests(const Ask& ask, const HoldsPart& holds_part, const OnShadowTests& on_shadow_tests, const CullOptions& options,
            View::Memory& memory)
      : ask_(ask),
        holds_part_(holds_part),
        on_shadow_tests_(on_shadow_tests),
        options_(options),
        planes_(memory.planes),
        probes_(memory.probes),
        shrunk_(memory.shrunk),
        frusta_(memory.frusta),
        frame_(memory.result) {
    memory.take_planes();
    memory.shrink_shadows();
    memory.take_frusta();
  }

  void planes(std::uint32_t which, const NodeBlock& block, std::span<kernel::BlockRelation> relations) const {
    const NodeBlock::Bits alone = is_certified() ? block.oriented : block.used;
    kernel::relations(planes_, which, block.boxes, static_cast<NodeBlock::Bits>(block.used & ~alone), relations);
    if (alone == 0) return;
    for_each_bit(which, [&](std::uint32_t plane) {
      for_each_bit(alone, [&](std::uint32_t i) {
        const kernel::Relation relation = ask_(block.node[i], [&](const auto& box) {
          return kernel::relation(planes_[plane], box, options_.arithmetic);
        });
        const auto bit = static_cast<NodeBlock::Bits>(1U << i);
        if (relation == kernel::Relation::outside) relations[plane].outside |= bit;
        if (relation == kernel::Relation::inside) relations[plane].inside |= bit;
      });
    });
  }

  /// What the filter cannot tell is left to shadow() and probe().
  void filter(const NodeBlock& block, kernel::BlockQuestions& questions) const {
    kernel::conservative_filter(frusta_, block.boxes, questions);
    const kernel::BoxBytes alone = kernel::for_all(is_certified() ? block.oriented : block.used);
    // The profile of an occluder's shadow may be beyond a box that the planes straddle. Probes are asked by planes alone.
    const bool is_overlap = options_.test == kernel::Test::overlap && questions.frustum[0] < frame_.occluders.size();
    if (alone == 0 && !is_overlap) return;
    questions.outside &= ~alone;
    questions.inside &= ~alone;
    questions.unknown |= alone;
    if (is_overlap) questions.unknown = kernel::for_all(block.used) & ~(questions.outside | questions.inside);
  }

  kernel::Decision shadow(std::uint32_t occluder, std::uint32_t node) const {
    const Occluder& by = frame_.occluders[occluder];
    return ask_(node, [&](const auto& box) {
      return decide_cull(by.frustum, box, {options_.arithmetic, options_.test}, shrunk_[occluder],
                         [&] { return holds_part_(node, by.index); });
    });
  }

  bool may_cull(std::uint32_t occluder, std::uint32_t node) const {
    const Occluder& by = frame_.occluders[occluder];
    return ask_(node, [&](const auto& box) {
      return is_cull(by.frustum, box, shrunk_[occluder], [&] { return holds_part_(node, by.index); });
    });
  }

  /// A probe hides nothing, so its answer may be approximate: neither the margin nor its own parts are considered.
  kernel::Decision probe(std::uint32_t probe, std::uint32_t node) const {
    return ask_(node, [&](const auto& box) {
      return decide_cull(probes_[probe].frustum, box, {.arithmetic = options_.arithmetic}, ShadowMargin());
    });
  }

  std::size_t pair_work(std::uint32_t first, std::uint32_t second) const {
    return frame_.occluders[first].frustum.plane_count() * frame_.occluders[second].frustum.plane_count();
  }

  kernel::Decision pair(std::uint32_t first, std::uint32_t second, std::uint32_t node) const {
    const Occluder &a = frame_.occluders[first], &b = frame_.occluders[second];
    return ask_(node, [&](const auto& box) {
      return decide_cull(kernel::ShadowUnion{a.frustum, b.frustum}, box, Asked{}, frame_.margin,
                         [&] { return holds_part_(node, a.index) || holds_part_(node, b.index); });
    });
  }

  void tested(const NodeBlock& block, const kernel::BlockQuestions& questions, kernel::BoxBytes nodes) const {
    on_shadow_tests_(block, questions, nodes);
  }

 private:
  [[nodiscard]] bool is_certified() const { return options_.arithmetic == kernel::Arithmetic::certified; }

  const Ask& ask_;
  const HoldsPart& holds_part_;
  const OnShadowTests& on_shadow_tests_;
  const CullOptions& options_;
  const std::vector<kernel::HalfSpace>& planes_;
  const std::vector<Occluder>& probes_;
  const std::vector<ShrunkShadow>& shrunk_;
  const std::vector<const kernel::ShadowFrustum*>& frusta_;
  const CullResult& frame_;
};

/// One descent of the tree, for a frame whose half-spaces and occluders are known.
template <class Ask, class HoldsPart, class OnShadowTests>
void traverse(const NodeBlocks& blocks, const Ask& ask, const HoldsPart& holds_part, const OnShadowTests& on_shadow_tests,
              const CullOptions& options, View::Memory& memory) {
  // Memory for the stacks: all occluders and probes that a frame may have, at each level of the deepest trees. The tree of
  // ten million polygons has some 40 levels of nodes, and fewer of blocks.
  constexpr std::size_t kLevels = 64;
  const std::size_t most = memory.result.occluders.capacity() + memory.probes.capacity();
  memory.traversal.active.reserve(kLevels * (most / kernel::BlockQuestions::kMost + 2));
  memory.traversal.holding.reserve(memory.probes.capacity());
  memory.planes.reserve(memory.result.view.size());
  memory.frusta.reserve(most);
  NodeTests tests(ask, holds_part, on_shadow_tests, options, memory);
  const ViewPlanes planes{memory.planes, options.arithmetic};
  Traversal(blocks, tests, memory.probes, memory.result, memory.traversal).run(planes.all());
}

}  // namespace occlude::culler
