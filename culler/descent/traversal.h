// SPDX-License-Identifier: MIT
// The traversal of section 5: one descent of the hierarchy culls by the view frustum, culls by the shadow frusta and draws.
//
// It knows neither frusta nor boxes: `tests` classifies nodes against half-spaces and shadows, or against two shadows
// together. A half-space that holds a node, and a shadow that does not meet it, are dropped below the node. Any number of
// shadows can be active. What is active is asked about all nodes of a block at once. Subtrees may be put off, for other
// threads (parallel_traversal.h).
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "base/each_bit.h"
#include "base/sparse_zero_array.h"
#include "descent/block_descent.h"
#include "model/block_tree.h"
#include "occlude/culler/cull_result.h"
#include "occlude/kernel/box_block.h"
#include "occlude/kernel/overlap.h"

namespace occlude::culler {

/// The work that the tests of pairs may take in a frame, for each of its occluders and in all. Beyond it, pairs are not
/// tested. The exact stage takes up to a microsecond for each plane of the one shadow and plane of the other, so this is 16
/// ms and a second. The models tried take at most half of it: 8,300 for each of eight occluders, 8,000 for each of 64.
inline constexpr std::size_t kPairWorkOfEach = std::size_t{1} << 14U, kMostPairWork = std::size_t{1} << 20U;

/// Probes are not followed into subtrees of this many polygons or fewer, because what they hide there is little.
inline constexpr std::uint32_t kProbed = 64;

/// Up to eight shadows that are active at a block, and what is known of them and the nodes there. Those of occluders come
/// before those of probes.
struct alignas(64) ActiveShadows {
  kernel::BlockQuestions answers;
  kernel::BoxBytes occluders, probes;  ///< masks of the questions about either
  kernel::BoxBytes partial;            ///< nodes that they straddle
  kernel::BoxBytes exact;              ///< nodes of which the exact stage had to answer
};

/// What is active at a block: half-spaces, all bits of a byte for each, and shadows [begin, end) of a stack.
struct ActiveTests {
  kernel::BoxBytes planes = 0;
  std::size_t begin = 0, end = 0;
};

/// The stacks of a traversal, of which each level of the descent uses its own part, and its counts.
struct TraversalMemory {
  std::vector<ActiveShadows> active;   ///< may be longer than what is in use
  std::vector<std::uint32_t> holding;  ///< probes that hold the node or one above it
  std::vector<std::uint32_t> hidden;   ///< by each occluder and each probe: items, modulo 2^32
};

/// A subtree that a traversal puts off, and what a traversal of its own finds there.
struct alignas(64) DeferredSubtree {
  std::uint32_t block = 0;            ///< the block below its root
  ItemRange items;                    ///< below it
  ActiveTests active;                 ///< there, in `memory`
  std::size_t holding = 0;            ///< of the probes in `memory`, those that hold the whole subtree
  std::size_t drawn = 0, culled = 0;  ///< lengths of the lists of the traversal that put it off, at that moment
  TraversalMemory memory;
  CullResult found;
};

/// A subtree that a traversal has not put off whole, because there was too much work in it.
struct DividedSubtree {
  std::uint32_t block;     ///< the block below its root
  std::size_t first, end;  ///< the subtrees in it that were put off instead
  std::size_t work;        ///< what the traversal did there itself
};

/// The subtrees that a traversal puts off: at most `limit`, of `least` to `most` items each. Where it is known to have more
/// than `most_work`, what is below a subtree is put off instead. Their memory is reused.
struct DeferredSubtrees {
  std::uint32_t least = 0, most = 0;
  std::size_t limit = 0, size = 0;
  std::vector<DeferredSubtree> subtrees;  ///< may be longer than `size`
  std::size_t most_work = 0;
  /// For each block, the nodes visited in the subtree there when it was last put off or divided; 0 if it never was.
  SparseZeroArray<std::uint32_t> work;
  std::vector<DividedSubtree> divided;  ///< at most `limit`
};

template <class Tests>
class Traversal {
 public:
  /// `tests` has
  /// planes(block, asked): the relations of half-spaces and nodes, as kernel::relations();
  /// filter(block, questions, of_occluders): as kernel::conservative_filter(); the mask has the questions about occluders;
  /// shadow(frustum, block, i) and probe(frustum, block, i): a kernel::Decision about node i of a block;
  /// may_cull(frustum, block, i): whether an occluder may cull a node that is inside of its shadow;
  /// pair(first, second, block, i), such a Decision, and pair_work(first, second), the pairs of planes that it may ask;
  /// tested(block, questions, nodes): called for the nodes that were tested against shadows.
  /// Frustum i is that of occluder i, or of probe i - occluders. What is drawn and culled is appended to `result`.
  Traversal(const BlockTree& tree, Tests& tests, std::uint32_t occluders, std::uint32_t probes, CullResult& result,
            TraversalMemory& memory)
      : tree_(tree),
        tests_(tests),
        occluders_(occluders),
        probes_(probes),
        result_(result),
        active_(memory.active),
        holding_(memory.holding),
        hidden_(memory.hidden) {
    hidden_.assign(occluders_ + probes_, 0);
  }

  /// Traverses the tree. `planes` has a bit for each half-space of the view. Puts off what it may.
  void run(std::uint32_t planes, DeferredSubtrees& deferred) {
    if (deferred.limit > 0) deferred_ = &deferred;
    holding_.clear();
    pair_work_left_ = std::min(kMostPairWork, kPairWorkOfEach * occluders_);
    Bytes all_planes = 0;
    for_each_bit(planes, [&](std::uint32_t plane) { all_planes |= Bytes{0xFF} << 8 * plane; });
    const Active active = activated(active_, 0, all_planes, [&](const auto& append) {
      for (std::uint32_t i = 0; i < occluders_ + probes_; ++i) append(i);
    });
    traverse(0, active, tree_.items());
  }
  /// Traverses a subtree that was put off. REQUIRES: the memory is that of the subtree, and there are no pairs.
  void run(const DeferredSubtree& subtree) {
    holding_.resize(subtree.holding);
    traverse(subtree.block, subtree.active, subtree.items);
  }

 private:
  using Bits = std::uint32_t;  ///< TreeBlock::Bits in a register, which takes fewer instructions than a byte
  using Bytes = kernel::BoxBytes;
  using Active = ActiveTests;
  static constexpr std::size_t kMost = kernel::BlockQuestions::kMost;

  /// A block while it is visited.
  struct Visit {
    const TreeBlock& block;
    const Active& active;
    Bytes outside = 0, crossing = 0;                              ///< of each half-space, nodes outside or straddled
    std::array<std::uint32_t, TreeBlock::kNodes> hiding, second;  ///< the occluders that hide each hidden node
    Bits out_of_view = 0, hidden = 0;                             ///< culled
    Bits undecided = 0, undecided_probes = 0;                     ///< straddled by half-spaces or shadows, and by probes
    bool is_held = false;                                         ///< whether a probe may hold some node

    Visit(const TreeBlock& visited_block, const Active& active_there) : block(visited_block), active(active_there) {}
    [[nodiscard]] Bits culled() const { return out_of_view | hidden; }
    [[nodiscard]] Bits left() const { return block.used & ~culled(); }
    /// The nodes in which something is left to decide.
    [[nodiscard]] Bits entered() const { return left() & block.divided & (undecided | followed_probes()); }

   private:
    [[nodiscard]] Bits followed_probes() const {
      Bits followed = 0;
      for_each_bit(undecided_probes, [&](std::uint32_t i) { followed |= Bits{block.count(i) > kProbed} << i; });
      return followed;
    }
  };

  static bool has(std::uint32_t bits, std::uint32_t i) { return (bits >> i & 1U) != 0; }
  static void set(Bits& bits, Bits others) { bits |= others; }
  /// The nodes that any of eight questions has.
  static Bits any(Bytes bytes) {
    bytes |= bytes >> 32U;
    bytes |= bytes >> 16U;
    return kernel::boxes_of(bytes | bytes >> 8U, 0);
  }
  /// For each of eight questions, the nodes that it or one before it has.
  static Bytes from_first(Bytes bytes) {
    bytes |= bytes << 8U;
    bytes |= bytes << 16U;
    return bytes | bytes << 32U;
  }
  /// Calls visit(k) for each question that has this node.
  template <class Visitor>
  static void for_each_question(Bytes bytes, std::uint32_t i, const Visitor& visit) {
    for (Bytes left = bytes >> i & kernel::for_all(1); left != 0; left &= left - 1) {
      visit(static_cast<std::size_t>(std::countr_zero(left)) / 8);
    }
  }

  /// Makes shadows active from `begin` of a stack on. for_each_frustum(append) calls append(frustum) for each, those of
  /// occluders first. What is counted stays in registers.
  template <class ForEachFrustum>
  Active activated(std::vector<ActiveShadows>& stack, std::size_t begin, Bytes planes,
                   const ForEachFrustum& for_each_frustum) const {
    std::size_t end = begin;
    std::uint32_t count = kMost, of_occluders = 0;  // in the last
    ActiveShadows* last = nullptr;
    const auto complete = [&] {
      if (last == nullptr) return;
      last->answers.count = count;
      last->occluders = first_bytes(of_occluders);
      last->probes = first_bytes(count) & ~last->occluders;
    };
    for_each_frustum([&](std::uint32_t frustum) {
      if (count == kMost) {
        complete();
        if (end == stack.size()) stack.emplace_back();
        last = &stack[end++];
        count = of_occluders = 0;
      }
      last->answers.frustum[count++] = frustum;
      of_occluders += frustum < occluders_ ? 1 : 0;
    });
    complete();
    return {planes, begin, end};
  }
  /// All bits of the first bytes of eight.
  static Bytes first_bytes(std::size_t count) { return count == kMost ? ~Bytes{0} : (Bytes{1} << 8 * count) - 1; }

  void traverse(std::uint32_t block, const Active& active, const ItemRange& items) {
    drawn_from_ = items.first;
    BlockDescent(tree_, *this).visit(block, active);
    draw_until(items.first + items.count);
  }

  friend class BlockDescent<Traversal>;
  using State = ActiveTests;

  /// For the descent.
  template <class Enter>
  void visit(const TreeBlock& block, const Active& active, const Enter& enter) {
    Visit here(block, active);
    ask_planes(here);
    for (std::size_t g = active.begin; g < active.end; ++g) ask_shadows(here, active_[g]);
    const Bits before_pairs = here.hidden;
    if (!result_.pairs.empty()) ask_pairs(here);
    count_tests(here, here.hidden & ~before_pairs);
    if (here.is_held) hold(here);
    descend(here, here.entered(), enter);
  }

  void ask_planes(Visit& here) {
    if (here.active.planes == 0) return;
    const Bytes asked = here.active.planes & kernel::for_all(here.block.used);
    const kernel::BlockRelations relations = tests_.planes(here.block, asked);
    here.outside = relations.outside;
    here.crossing = asked & ~(relations.outside | relations.inside);
    here.undecided = any(here.crossing);
    here.out_of_view = any(here.outside);
  }

  void ask_shadows(Visit& here, ActiveShadows& shadows) {
    const kernel::BlockQuestions& answers = shadows.answers;
    ask(here, shadows);
    const Bytes all = shadows.occluders | shadows.probes;
    settle(here, shadows, ((answers.unknown & all) | (answers.inside & shadows.occluders)) & kernel::for_all(here.left()));
    set(here.undecided, any(shadows.partial & shadows.occluders));
    set(here.undecided_probes, any(shadows.partial & shadows.probes));
    here.is_held |= (answers.inside & shadows.probes) != 0;
  }

  /// Asks the filter.
  void ask(const Visit& here, ActiveShadows& shadows) {
    kernel::BlockQuestions& answers = shadows.answers;
    tests_.filter(here.block, answers, shadows.occluders);
    const Bytes all = shadows.occluders | shadows.probes;
    shadows.partial = all & kernel::for_all(here.block.used) & ~(answers.outside | answers.inside | answers.unknown);
    shadows.exact = 0;
  }

  /// Completes the answers: each of the doubtful nodes is decided, and hidden if it may be. A probe comes after all
  /// occluders.
  void settle(Visit& here, ActiveShadows& shadows, Bytes doubtful) {
    kernel::BlockQuestions& answers = shadows.answers;
    while (doubtful != 0) {
      const auto place = static_cast<std::uint32_t>(std::countr_zero(doubtful)), i = place % 8;
      const Bytes bit = Bytes{1} << place;
      doubtful &= ~bit;
      const std::uint32_t frustum = answers.frustum[place / 8];
      const bool is_occluder = (shadows.occluders & bit) != 0;
      const kernel::Decision found = decide(here, frustum, is_occluder, (answers.unknown & bit) != 0, i);
      answers.inside &= ~bit;
      if (found.stage == kernel::Stage::exact) shadows.exact |= bit;
      if (found.relation == kernel::Relation::inside) {
        answers.inside |= bit;
        if (is_occluder) {
          hide(here, i, frustum, Culled::kNone);
          doubtful &= ~kernel::for_all(1U << i);
        }
      } else if (found.relation == kernel::Relation::partial) {
        shadows.partial |= bit;
      }
    }
  }
  kernel::Decision decide(const Visit& here, std::uint32_t frustum, bool is_occluder, bool is_unknown, std::uint32_t i) {
    if (!is_occluder) return tests_.probe(frustum, here.block, i);
    if (is_unknown) return tests_.shadow(frustum, here.block, i);
    return {tests_.may_cull(frustum, here.block, i) ? kernel::Relation::inside : kernel::Relation::partial};
  }
  static void hide(Visit& here, std::uint32_t i, std::uint32_t occluder, std::uint32_t second) {
    here.hiding[i] = occluder;
    here.second[i] = second;
    set(here.hidden, Bits{1} << i);
  }

  /// Tests the nodes that are not culled against the pairs of the shadows that they straddle.
  void ask_pairs(Visit& here) {
    if (!straddle_two(here)) return;
    for (std::uint32_t i = 0; i < TreeBlock::kNodes; ++i) {
      if (!has(here.left(), i)) continue;
      const auto pair = std::ranges::find_if(result_.pairs, [&](const ShadowPair& p) { return is_inside(here, p, i); });
      if (pair != result_.pairs.end()) hide(here, i, pair->first, pair->second);
    }
  }
  /// Whether some node may straddle the shadows of two occluders.
  bool straddle_two(const Visit& here) const {
    Bits once = 0, twice = 0;
    for (std::size_t g = here.active.begin; g < here.active.end; ++g) {
      for (Bytes left = active_[g].partial & active_[g].occluders; left != 0; left >>= 8U) {
        set(twice, once & kernel::boxes_of(left, 0));
        set(once, kernel::boxes_of(left, 0));
      }
    }
    return (twice & here.left()) != 0;
  }
  bool is_inside(const Visit& here, const ShadowPair& pair, std::uint32_t i) {
    if (!straddles(here, pair.first, i) || !straddles(here, pair.second, i) || !may_ask(pair)) return false;
    ++result_.stats.union_tests;
    const kernel::Decision found = tests_.pair(pair.first, pair.second, here.block, i);
    if (found.stage == kernel::Stage::exact) ++result_.stats.exact_shadow_tests;
    return found.relation == kernel::Relation::inside;
  }
  bool straddles(const Visit& here, std::uint32_t occluder, std::uint32_t i) const {
    for (std::size_t g = here.active.begin; g < here.active.end; ++g) {
      const ActiveShadows& shadows = active_[g];
      for (std::size_t k = 0; k < shadows.answers.count; ++k) {
        if (shadows.answers.frustum[k] == occluder) return has(kernel::boxes_of(shadows.partial, k), i);
      }
    }
    return false;
  }
  /// Takes the work of a test of two shadows from what is left. Returns false, and takes nothing, if that is too little.
  bool may_ask(const ShadowPair& pair) {
    const std::size_t work = tests_.pair_work(pair.first, pair.second);
    if (work > pair_work_left_) return false;
    pair_work_left_ -= work;
    return true;
  }

  /// Counts for each probe the items of the nodes that are inside of it. What is culled of them is taken away again. After
  /// this, `inside` has what a probe holds.
  void hold(const Visit& here) {
    for (std::size_t g = here.active.begin; g < here.active.end; ++g) {
      ActiveShadows& shadows = active_[g];
      kernel::BlockQuestions& answers = shadows.answers;
      answers.inside &= shadows.probes & kernel::for_all(here.left());
      for_each_bit(any(answers.inside), [&](std::uint32_t i) {
        for_each_question(answers.inside, i, [&](std::size_t k) { hidden_[answers.frustum[k]] += here.block.count(i); });
      });
    }
  }

  /// Culls or enters nodes of the block, in the order of the tree. What is neither is drawn.
  template <class Enter>
  void descend(const Visit& here, Bits entered, const Enter& enter) {
    for_each_bit(here.culled() | entered, [&](std::uint32_t i) {
      if (has(entered, i)) {
        prefetch_below_next(here, entered, i);
        put_off_or_enter(here, i, enter);
      } else {
        cull(here, i);
      }
    });
  }

  /// A hint that the block below the next entered node comes. There is no branch: if there is none, the hint is for node i.
  void prefetch_below_next(const Visit& here, Bits entered, std::uint32_t i) const {
    const Bits after = entered & (~Bits{1} << i);
    tree_.prefetch(here.block.below[after != 0 ? static_cast<std::uint32_t>(std::countr_zero(after)) : i]);
  }

  /// Visits the block below a node with what straddles the node, or puts the node off, whole or in parts.
  template <class Enter>
  void put_off_or_enter(const Visit& here, std::uint32_t i, const Enter& enter) {
    if (!may_put_off(here.block.count(i))) return enter_below(here, i, enter);
    std::vector<DividedSubtree>& divided = deferred_->divided;
    const bool is_too_much = deferred_->work.get(here.block.below[i]) > deferred_->most_work;
    if (!is_too_much || divided.size() == deferred_->limit) return deferred(here, i);
    const std::size_t at = divided.size(), before = result_.stats.nodes_visited;
    divided.push_back({here.block.below[i], deferred_->size, 0, 0});
    enter_below(here, i, enter);
    divided[at].end = deferred_->size;
    divided[at].work = result_.stats.nodes_visited - before;
  }
  template <class Enter>
  void enter_below(const Visit& here, std::uint32_t i, const Enter& enter) {
    tree_.prefetch(here.block.below[i]);
    const Active below = active_below(here, i, active_, here.active.end);
    const std::size_t holding = holding_.size();
    for_each_holding(here, i, [&](std::uint32_t probe) { holding_.push_back(probe); });
    enter(i, below);
    while (holding_.size() > holding) holding_.pop_back();
  }
  /// What straddles a node, in a stack from `begin` on.
  Active active_below(const Visit& here, std::uint32_t i, std::vector<ActiveShadows>& stack, std::size_t begin) const {
    return activated(stack, begin, (here.crossing >> i & kernel::for_all(1)) * 0xFF, [&](const auto& append) {
      for (std::size_t g = here.active.begin; g < here.active.end; ++g) {
        for_each_question(active_[g].partial, i, [&](std::size_t k) { append(active_[g].answers.frustum[k]); });
      }
    });
  }

  bool may_put_off(std::uint32_t count) const {
    return deferred_ != nullptr && count <= deferred_->most && count >= deferred_->least &&
           deferred_->size < deferred_->limit;
  }
  void deferred(const Visit& here, std::uint32_t i) {
    if (deferred_->size == deferred_->subtrees.size()) deferred_->subtrees.emplace_back();
    DeferredSubtree& subtree = deferred_->subtrees[deferred_->size++];
    subtree.block = here.block.below[i];
    subtree.items = here.block.items(i);
    subtree.active = active_below(here, i, subtree.memory.active, 0);
    subtree.memory.holding = holding_;
    for_each_holding(here, i, [&](std::uint32_t probe) { subtree.memory.holding.push_back(probe); });
    subtree.holding = subtree.memory.holding.size();
    draw_until(subtree.items.first);
    drawn_from_ += subtree.items.count;
    subtree.drawn = result_.drawn.size();
    subtree.culled = result_.culled.size();
  }

  /// Calls take(probe) for each probe that holds a node, but nothing above it.
  template <class Take>
  void for_each_holding(const Visit& here, std::uint32_t i, const Take& take) {
    if (!here.is_held) return;
    for (std::size_t g = here.active.begin; g < here.active.end; ++g) {
      const kernel::BlockQuestions& answers = active_[g].answers;
      for_each_question(answers.inside, i, [&](std::size_t k) { take(answers.frustum[k]); });
    }
  }

  void cull(const Visit& here, std::uint32_t i) {
    const std::uint32_t node = here.block.node[i], count = here.block.count(i);
    draw_until(here.block.begin[i]);
    drawn_from_ += count;
    if (has(here.out_of_view, i)) {
      const auto plane = static_cast<std::uint32_t>(std::countr_zero(here.outside >> i & kernel::for_all(1))) / 8;
      result_.culled.push_back({node, Culled::By::view, plane});
      result_.stats.view_culled_polygons += count;
    } else {
      const std::uint32_t occluder = here.hiding[i], second = here.second[i];
      result_.culled.push_back({node, Culled::By::shadow, occluder, second});
      result_.stats.shadow_culled_polygons += count;
      hidden_[occluder] += count;
      if (second != Culled::kNone) hidden_[second] += count;
    }
    for (const std::uint32_t probe : holding_) hidden_[probe] -= count;
    for_each_holding(here, i, [&](std::uint32_t probe) { hidden_[probe] -= count; });
  }

  /// Draws all items before this one that are neither drawn nor culled.
  void draw_until(std::uint32_t item) {
    if (item == drawn_from_) return;
    result_.drawn.push_back({drawn_from_, item - drawn_from_});
    result_.stats.drawn_polygons += item - drawn_from_;
    drawn_from_ = item;
  }

  /// Counts the tests that a descent takes which asks node by node. There, what culls a node ends its tests.
  void count_tests(const Visit& here, Bits hidden_by_pairs) {
    CullStats& stats = result_.stats;
    Bits left = here.block.used;
    stats.nodes_visited += kernel::count(here.block.used);
    if (here.active.planes != 0) {
      const Bytes culled = from_first(here.outside);
      stats.view_tests += kernel::count(here.active.planes & kernel::for_all(left) & ~(culled << 8U));
      left &= ~Bits{kernel::boxes_of(culled, kMost - 1)};
    }
    for (std::size_t g = here.active.begin; g < here.active.end; ++g) {
      left = count_shadow_tests(here, active_[g], left, hidden_by_pairs);
    }
  }

  /// Counts the tests of some shadows. Returns the nodes that are left for the next shadows. Probes come after all
  /// occluders, and after pairs of them.
  Bits count_shadow_tests(const Visit& here, const ActiveShadows& shadows, Bits left, Bits hidden_by_pairs) {
    const kernel::BlockQuestions& answers = shadows.answers;
    const Bytes culled = from_first(answers.inside & shadows.occluders);
    const Bytes tested = shadows.occluders & kernel::for_all(left) & ~(culled << 8U);
    left &= ~Bits{kernel::boxes_of(culled, kMost - 1)};
    const Bytes of_probes = shadows.probes & kernel::for_all(left & ~hidden_by_pairs);
    const Bytes counts = kernel::counts(tested | of_probes);
    result_.stats.shadow_tests += kernel::total(counts & shadows.occluders);
    result_.stats.probe_tests += kernel::total(counts & shadows.probes);
    if (shadows.exact != 0) result_.stats.exact_shadow_tests += kernel::count(shadows.exact & tested);
    tests_.tested(here.block, answers, tested);
    return left;
  }

  const BlockTree tree_;
  Tests& tests_;
  std::uint32_t occluders_, probes_;  ///< how many there are
  CullResult& result_;
  std::vector<ActiveShadows>& active_;
  std::vector<std::uint32_t>&holding_, &hidden_;
  DeferredSubtrees* deferred_ = nullptr;
  std::uint32_t drawn_from_ = 0;  ///< the first item that is neither drawn, culled nor put off
  std::size_t pair_work_left_ = 0;
};

}  // namespace occlude::culler
