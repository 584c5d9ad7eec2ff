// SPDX-License-Identifier: MIT
// The traversal of section 5: one descent of the hierarchy culls by the view frustum, culls by the shadow frusta and draws.
//
// It knows neither frusta nor boxes: `tests` classifies nodes against half-spaces and shadows, or against two shadows
// together. A half-space that holds a node, and a shadow that does not meet it, are dropped below the node. Any number of
// shadows can be active. What is active is asked about all nodes of a block at once. The answers are those of a descent from
// node to node, because what a node is culled by culls all that is below it.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "node_blocks.h"
#include "occlude/culler/append_range.h"
#include "occlude/culler/cull_result.h"
#include "occlude/kernel/box_block.h"
#include "occlude/kernel/overlap.h"
#include "view_planes.h"

namespace occlude::culler {

/// The work that the tests of pairs may take in a frame, for each of its occluders and in all. Beyond it, pairs are not
/// tested. The exact stage takes up to a microsecond for each plane of the one shadow and plane of the other, so this is 16
/// ms and a second. The models tried take at most half of it: 8,300 for each of eight occluders, 8,000 for each of 64.
inline constexpr std::size_t kPairWorkOfEach = std::size_t{1} << 14U, kMostPairWork = std::size_t{1} << 20U;

/// Probes are not followed into subtrees of this many polygons or fewer, because what they hide there is little.
inline constexpr std::uint32_t kProbed = 64;


/// Up to eight shadows that are active at a block, and what is known of them and the nodes there.
struct ActiveShadows {
  kernel::BlockQuestions answers = {};
  kernel::BoxBytes asked = 0;    ///< nodes whose parents they straddle
  kernel::BoxBytes partial = 0;  ///< nodes that they straddle
  kernel::BoxBytes exact = 0;    ///< nodes of which the exact stage had to answer
};

/// The stacks of a traversal. Each level of the descent appends its own.
struct TraversalMemory {
  std::vector<ActiveShadows> active;   ///< those of occluders, then those of probes
  std::vector<std::uint32_t> holding;  ///< probes that hold the node or one above it
};

template <class Tests>
class Traversal {
 public:
  /// `tests` has
  /// planes(which, block, relations): the relations of half-spaces and nodes, as kernel::relations();
  /// filter(block, questions): as kernel::conservative_filter();
  /// shadow(occluder, node) and probe(probe, node): a kernel::Decision about one node;
  /// may_cull(occluder, block, i): whether the occluder may cull node i of a block, which is inside of its shadow;
  /// pair(first, second, node), a kernel::Decision, and pair_work(first, second), the pairs of planes that it may ask;
  /// tested(block, questions, nodes): called for the nodes that were tested against shadows.
  /// Frustum i is about occluder i, or of probe i - result.occluders.size(). What is in `result.drawn` before run() stays.
  Traversal(const NodeBlocks& blocks, Tests& tests, std::span<Occluder> probes, CullResult& result, TraversalMemory& memory)
      : blocks_(blocks),
        tests_(tests),
        probes_(probes),
        result_(result),
        active_(memory.active),
        holding_(memory.holding) {}

  /// `planes` has a bit for each half-space of the view.
  void run(std::uint32_t planes) {
    const auto occluders = static_cast<std::uint32_t>(result_.occluders.size());
    const auto all = static_cast<std::uint32_t>(occluders + probes_.size());
    active_.clear();
    holding_.clear();
    pair_work_left_ = std::min(kMostPairWork, kPairWorkOfEach * occluders);
    for (std::uint32_t i = 0; i < occluders; ++i) append(0, i);
    const std::size_t middle = active_.size();
    for (std::uint32_t i = occluders; i < all; ++i) append(middle, i);
    visit(0, {planes, 0, middle, active_.size()});
  }

 private:
  using Bits = NodeBlock::Bits;
  using Bytes = kernel::BoxBytes;

  /// What is active at a block: half-spaces, a bit for each; of active_, shadows [begin, middle) and probes [middle, end).
  struct Active {
    std::uint32_t planes;
    std::size_t begin, middle, end;
  };
  /// A question about an active shadow: its number in active_[group].
  struct Question {
    std::size_t group, number;
  };

  /// A block while it is visited.
  struct Visit {
    const NodeBlock& block;
    const Active& active;
    std::array<kernel::BlockRelation, ViewPlanes::kMostPlanes> planes;
    std::array<std::uint32_t, NodeBlock::kNodes> hiding;  ///< the occluder whose shadow each hidden node is in
    Bits visited = 0;
    Bits out_of_view = 0, hidden = 0;          ///< culled, or below what is
    Bits hidden_by_pair = 0;                   ///< culled by two shadows
    Bits undecided = 0, undecided_probes = 0;  ///< straddled by half-spaces or shadows, and by probes

    Visit(const NodeBlock& visited_block, const Active& active_there) : block(visited_block), active(active_there) {}
    [[nodiscard]] Bits left() const { return static_cast<Bits>(block.used & ~(out_of_view | hidden)); }
  };

  static bool has(std::uint32_t bits, std::uint32_t i) { return (bits >> i & 1U) != 0; }
  static void set(Bits& bits, unsigned others) { bits = static_cast<Bits>(bits | others); }
  /// The nodes that any of eight questions has.
  static Bits any(Bytes bytes) {
    bytes |= bytes >> 32U;
    bytes |= bytes >> 16U;
    return kernel::boxes_of(bytes | bytes >> 8U, 0);
  }

  /// Appends a question to those of active_ from `begin` on.
  void append(std::size_t begin, std::uint32_t frustum) {
    if (active_.size() == begin || active_.back().answers.count == kernel::BlockQuestions::kMost) active_.emplace_back();
    kernel::BlockQuestions& questions = active_.back().answers;
    questions.frustum[questions.count++] = frustum;
  }

  void visit(std::uint32_t index, const Active& active) {
    Visit here(blocks_[index], active);
    ask_planes(here);
    for (std::size_t g = active.begin; g < active.middle; ++g) ask_shadows(here, g);
    for (std::size_t g = active.middle; g < active.end; ++g) ask_probes(here, active_[g]);
    descend(here);
    count_tests(here);
  }

  void ask_planes(Visit& here) {
    const NodeBlock& block = here.block;
    if (here.active.planes == 0) return;
    tests_.planes(here.active.planes, block, here.planes);
    for_each_bit(here.active.planes, [&](std::uint32_t plane) {
      const kernel::BlockRelation& relation = here.planes[plane];
      set(here.undecided, straddling(block, relation));
      for_each_bit(relation.outside, [&](std::uint32_t i) { set(here.out_of_view, block.subtree[i]); });
    });
  }
  static Bits straddling(const NodeBlock& block, const kernel::BlockRelation& relation) {
    return static_cast<Bits>(block.used & ~(relation.outside | relation.inside));
  }

  void ask_shadows(Visit& here, std::size_t group) {
    ActiveShadows& shadows = active_[group];
    kernel::BlockQuestions& answers = shadows.answers;
    ask(here, shadows);
    if (((answers.unknown | answers.inside) & kernel::for_all(here.left())) != 0) {
      for (std::size_t k = 0; k < answers.count; ++k) {
        const std::uint32_t occluder = answers.frustum[k];
        const Bits unknown = kernel::boxes_of(answers.unknown, k), inside = kernel::boxes_of(answers.inside, k);
        settle(here, shadows, k, static_cast<Bits>(unknown | inside), [&](std::uint32_t i) {
          if (has(unknown, i)) return tests_.shadow(occluder, here.block.node[i]);
          return kernel::Decision{tests_.may_cull(occluder, here.block, i) ? kernel::Relation::inside
                                                                           : kernel::Relation::partial};
        });
        for_each_bit(kernel::boxes_of(answers.inside & shadows.asked, k) & here.left(), [&](std::uint32_t i) {
          here.hiding[i] = occluder;
          set(here.hidden, here.block.subtree[i]);
        });
      }
    }
    set(here.undecided, any(shadows.partial));
  }

  /// A probe that a node is inside of holds all that is below it.
  void ask_probes(Visit& here, ActiveShadows& probes) {
    kernel::BlockQuestions& answers = probes.answers;
    ask(here, probes);
    if ((answers.unknown & kernel::for_all(here.left())) != 0) {
      for (std::size_t k = 0; k < answers.count; ++k) {
        const std::uint32_t probe = probe_of(answers, k);
        settle(here, probes, k, kernel::boxes_of(answers.unknown, k),
               [&](std::uint32_t i) { return tests_.probe(probe, here.block.node[i]); });
      }
    }
    const Bytes inside = answers.inside & probes.asked;
    for_each_bit(any(inside), [&](std::uint32_t i) {
      answers.inside |= (inside >> i & kernel::for_all(1)) * here.block.subtree[i];
    });
    set(here.undecided_probes, any(probes.partial));
  }
  std::uint32_t probe_of(const kernel::BlockQuestions& questions, std::size_t k) const {
    return static_cast<std::uint32_t>(questions.frustum[k] - result_.occluders.size());
  }

  /// Asks the filter.
  void ask(const Visit& here, ActiveShadows& shadows) {
    kernel::BlockQuestions& answers = shadows.answers;
    tests_.filter(here.block, answers);
    const Bytes all = answers.count == kernel::BlockQuestions::kMost ? ~Bytes{0} : (Bytes{1} << 8 * answers.count) - 1;
    shadows.partial = all & kernel::for_all(here.block.used) & ~(answers.outside | answers.inside | answers.unknown);
    shadows.asked = all & (kernel::for_all(here.block.roots) | here.block.children_of(shadows.partial));
    shadows.exact = 0;
  }

  /// Completes the answers to question k: decide(i) answers for each of the doubtful nodes that has to be asked about.
  template <class Decide>
  void settle(Visit& here, ActiveShadows& shadows, std::size_t k, Bits doubtful, const Decide& decide) {
    kernel::BlockQuestions& answers = shadows.answers;
    for_each_bit(doubtful & here.left(), [&](std::uint32_t i) {
      const Bytes bit = Bytes{1} << (8 * k + i);
      if ((shadows.asked & bit) == 0) return;
      const kernel::Decision found = decide(i);
      answers.inside &= ~bit;
      if (found.stage == kernel::Stage::exact) shadows.exact |= bit;
      if (found.relation == kernel::Relation::inside) answers.inside |= bit;
      if (found.relation == kernel::Relation::partial) {
        shadows.partial |= bit;
        shadows.asked |= Bytes{here.block.children[i]} << 8 * k;
      }
    });
  }

  /// Culls, draws or enters the nodes of the block, in the order of the tree.
  void descend(Visit& here) {
    const NodeBlock& block = here.block;
    here.visited = block.roots;
    for (std::uint32_t i = 0; i < NodeBlock::kNodes; ++i) {
      if (!has(here.visited, i) || is_culled(here, i)) continue;
      const bool is_undecided = has(here.undecided, i) || (has(here.undecided_probes, i) && block.count[i] > kProbed);
      if (!is_undecided || block.is_leaf(i)) {
        draw(here, i);
      } else if (block.children[i] != 0) {
        set(here.visited, block.children[i]);
      } else {
        enter(here, i);
      }
    }
  }

  bool is_culled(Visit& here, std::uint32_t i) {
    const std::uint32_t node = here.block.node[i];
    if (has(here.out_of_view, i)) {
      std::uint32_t plane = 0;
      while (!has(here.active.planes, plane) || !has(here.planes[plane].outside, i)) ++plane;
      cull({node, Culled::By::view, plane}, here.block.count[i]);
    } else if (has(here.hidden, i)) {
      cull({node, Culled::By::shadow, here.hiding[i]}, here.block.count[i]);
    } else {
      return !result_.pairs.empty() && is_culled_by_pair(here, i);
    }
    return true;
  }

  /// Tests a node against the pairs of the shadows that it straddles.
  bool is_culled_by_pair(Visit& here, std::uint32_t i) {
    const std::uint32_t node = here.block.node[i];
    for (const auto& [first, second] : result_.pairs) {
      if (!straddles(here, first, i) || !straddles(here, second, i) || !may_ask(first, second)) continue;
      ++result_.stats.union_tests;
      const kernel::Decision found = tests_.pair(first, second, node);
      if (found.stage == kernel::Stage::exact) ++result_.stats.exact_shadow_tests;
      if (found.relation != kernel::Relation::inside) continue;
      set(here.hidden_by_pair, static_cast<Bits>(1U << i));
      cull({node, Culled::By::shadow, first, second}, here.block.count[i]);
      return true;
    }
    return false;
  }

  bool straddles(const Visit& here, std::uint32_t occluder, std::uint32_t i) const {
    for (std::size_t g = here.active.begin; g < here.active.middle; ++g) {
      const kernel::BlockQuestions& questions = active_[g].answers;
      for (std::size_t k = 0; k < questions.count; ++k) {
        if (questions.frustum[k] == occluder) return has(kernel::boxes_of(active_[g].partial, k), i);
      }
    }
    return false;
  }

  /// Takes the work of a test of two shadows from what is left. Returns false, and takes nothing, if that is too little.
  bool may_ask(std::uint32_t first, std::uint32_t second) {
    const std::size_t work = tests_.pair_work(first, second);
    if (work > pair_work_left_) return false;
    pair_work_left_ -= work;
    return true;
  }

  /// Visits the block below a node with what straddles the node.
  void enter(const Visit& here, std::uint32_t i) {
    const Active& active = here.active;
    Active below{0, active_.size(), 0, 0};
    for_each_bit(active.planes, [&](std::uint32_t plane) {
      if (has(straddling(here.block, here.planes[plane]), i)) below.planes |= std::uint32_t{1} << plane;
    });
    below.middle = append_straddling(active.begin, active.middle, i);
    below.end = append_straddling(active.middle, active.end, i);
    const std::size_t holding = holding_.size();
    for_each_holding(here, i, [&](std::uint32_t probe) { holding_.push_back(probe); });
    visit(here.block.below[i], below);
    holding_.resize(holding);
    active_.resize(below.begin);
  }

  /// Appends questions about those of active_[begin, end) that straddle a node. Returns how long active_ is then.
  std::size_t append_straddling(std::size_t begin, std::size_t end, std::uint32_t i) {
    const std::size_t appended = active_.size();
    for (std::size_t g = begin; g < end; ++g) {
      for (Bytes left = active_[g].partial >> i & kernel::for_all(1); left != 0; left &= left - 1) {
        append(appended, active_[g].answers.frustum[static_cast<std::size_t>(std::countr_zero(left)) / 8]);
      }
    }
    return active_.size();
  }

  /// Calls take(probe) for each probe that holds a node, but no block above it.
  template <class Take>
  void for_each_holding(const Visit& here, std::uint32_t i, const Take& take) {
    for (std::size_t g = here.active.middle; g < here.active.end; ++g) {
      const kernel::BlockQuestions& answers = active_[g].answers;
      for (Bytes left = answers.inside >> i & kernel::for_all(1); left != 0; left &= left - 1) {
        take(probe_of(answers, static_cast<std::size_t>(std::countr_zero(left)) / 8));
      }
    }
  }

  void cull(const Culled& culled, std::uint32_t count) {
    result_.culled.push_back(culled);
    if (culled.by == Culled::By::view) {
      result_.stats.view_culled_polygons += count;
    } else {
      result_.stats.shadow_culled_polygons += count;
      result_.occluders[culled.index].hidden += count;
      if (culled.second != Culled::kNone) result_.occluders[culled.second].hidden += count;
    }
  }

  void draw(const Visit& here, std::uint32_t i) {
    const std::uint32_t count = here.block.count[i];
    append_range(result_.drawn, {here.block.first[i], count});
    result_.stats.drawn_polygons += count;
    for (const std::uint32_t probe : holding_) probes_[probe].hidden += count;
    for_each_holding(here, i, [&](std::uint32_t probe) { probes_[probe].hidden += count; });
  }

  /// Counts the tests that a descent from node to node takes. There, what culls a node ends its tests.
  void count_tests(const Visit& here) {
    CullStats& stats = result_.stats;
    Bits left = here.visited;
    stats.nodes_visited += kernel::count(left);
    for_each_bit(here.active.planes, [&](std::uint32_t plane) {
      const kernel::BlockRelation& relation = here.planes[plane];
      const auto asked = static_cast<Bits>(here.block.roots | here.block.children_of(straddling(here.block, relation)));
      stats.view_tests += kernel::count(static_cast<Bits>(asked & left));
      left = static_cast<Bits>(left & ~relation.outside);
    });
    for (std::size_t g = here.active.begin; g < here.active.middle; ++g) left = count_shadow_tests(here, active_[g], left);
    left = static_cast<Bits>(left & ~here.hidden_by_pair);
    for (std::size_t g = here.active.middle; g < here.active.end; ++g) {
      stats.probe_tests += kernel::count(active_[g].asked & kernel::for_all(left));
    }
  }

  /// Counts the tests of some shadows. Returns the nodes that are left for the next shadows.
  Bits count_shadow_tests(const Visit& here, const ActiveShadows& shadows, Bits left) {
    Bytes tested = shadows.asked & kernel::for_all(left);
    const kernel::BlockQuestions& answers = shadows.answers;
    if (here.hidden != 0) {
      tested = 0;
      for (std::size_t k = 0; k < answers.count; ++k) {
        const auto now = static_cast<Bits>(kernel::boxes_of(shadows.asked, k) & left);
        tested |= Bytes{now} << 8 * k;
        left = static_cast<Bits>(left & ~(kernel::boxes_of(answers.inside, k) & now));
      }
    }
    result_.stats.shadow_tests += kernel::count(tested);
    if ((shadows.exact & tested) != 0) result_.stats.exact_shadow_tests += kernel::count(shadows.exact & tested);
    tests_.tested(here.block, answers, tested);
    return left;
  }

  const NodeBlocks& blocks_;
  Tests& tests_;
  std::span<Occluder> probes_;
  CullResult& result_;
  std::vector<ActiveShadows>& active_;
  std::vector<std::uint32_t>& holding_;
  std::size_t pair_work_left_ = 0;
};

}  // namespace occlude::culler
