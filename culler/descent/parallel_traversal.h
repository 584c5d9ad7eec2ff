// SPDX-License-Identifier: MIT
// The traversal on several threads. A traversal from the root puts subtrees off. Each of them is then traversed by itself,
// on any thread, and what was found is joined in the order of the tree. The result is that of one traversal.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "base/work_runner.h"
#include "descent/add_counts.h"
#include "descent/traversal.h"
#include "model/append_range.h"
#include "model/block_tree.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/executor.h"

namespace occlude::culler {

/// Of a model that is entered everywhere, each thread is given about so many subtrees, large ones and small, so that all
/// finish at about the same time. Frames enter a part of it: on two threads Utrecht gives 20, the castle 11. With twice as
/// many, what is traversed before the first of them starts takes twice as long.
inline constexpr std::size_t kDeferredOfThread = 8;
/// A subtree of 32 items takes 1 us, to put it off and to join it a fifth of that. Blocks lie several levels apart, so the
/// largest may have eight times as many, however many threads there are.
inline constexpr std::uint32_t kLeastDeferred = 32, kLeastLargest = 8 * kLeastDeferred;
/// A tree may be so unbalanced that it has many small subtrees. With this limit the memory that is reserved for them is
/// below 80 bytes for each item of a large tree, whatever it is: 20 bytes for each item of the largest, for each subtree.
/// In a small tree it is at most 160 KiB for each thread.
inline constexpr std::size_t kMostDeferredOfThread = 4 * kDeferredOfThread;

/// The work of the last frame in so many shares for each thread: a subtree that had more than one share is divided. In the
/// city of ten million the eye is in one of the subtrees by size, and that one had 73 % of the work.
inline constexpr std::size_t kSharesOfThread = 2;

/// What the subtrees are joined from.
struct ParallelMemory {
  DeferredSubtrees deferred;
  std::vector<PolygonRange> drawn;  ///< by the traversal from the root
  std::vector<Culled> culled;
};

/// What a frame's shadows are cast by.
struct ShadowCounts {
  std::uint32_t occluders, probes;
};

template <class Tests>
class ParallelTraversal {
 public:
  /// `tests` as Traversal; its calls may come from several threads at once.
  ParallelTraversal(const BlockTree& tree, Tests& tests, const ShadowCounts& shadows, CullResult& result,
                    TraversalMemory& memory, ParallelMemory& parts, WorkRunner& runner)
      : tree_(tree), tests_(tests), shadows_(shadows), result_(result), memory_(memory), parts_(parts), runner_(runner) {}

  /// `planes` has a bit for each half-space of the view. Pairs share a budget, in the order of the tree (kMostPairWork):
  /// where there are any, nothing is put off. What the executor throws is thrown on.
  void run(std::uint32_t planes, const Executor* executor) {
    const bool is_alone = executor == nullptr || executor->threads() <= 1 || !result_.pairs.empty();
    set_limits(is_alone ? 0 : executor->threads());
    Traversal(tree_, tests_, shadows_.occluders, shadows_.probes, result_, memory_).run(planes, parts_.deferred);
    if (is_alone) return;
    if (parts_.deferred.size > 0) {
      for (DeferredSubtree& subtree : subtrees()) prepare(subtree);
      const auto work_of = [&](std::size_t i) { return parts_.deferred.work.get(subtrees()[i].block); };
      runner_.run(*executor, subtrees().size(), work_of, [&](std::size_t i) { traverse(subtrees()[i]); });
      join();
    }
    note_work(executor->threads());
  }

 private:
  std::span<DeferredSubtree> subtrees() { return std::span(parts_.deferred.subtrees).first(parts_.deferred.size); }

  void set_limits(std::size_t threads) {
    DeferredSubtrees& deferred = parts_.deferred;
    deferred.size = 0;
    deferred.least = kLeastDeferred;
    deferred.limit = kMostDeferredOfThread * threads;
    deferred.divided.clear();
    deferred.divided.reserve(deferred.limit);
    runner_.reserve(deferred.limit);
    if (threads > 0) deferred.work.grow(tree_.size());
    deferred.most = kLeastLargest;
    if (threads > 0)
      deferred.most = std::max(deferred.most, static_cast<std::uint32_t>(items() / (kDeferredOfThread * threads)));
  }
  [[nodiscard]] std::uint32_t items() const { return tree_.items().count; }

  /// Reserves memory for all that may be found in the largest: in a later frame it may be another subtree. Memory that is
  /// never written to takes only addresses.
  void prepare(DeferredSubtree& subtree) {
    subtree.found.drawn.reserve((parts_.deferred.most + 1) / 2);
    subtree.found.culled.reserve(parts_.deferred.most);
    subtree.memory.active.reserve(memory_.active.capacity());
    subtree.memory.holding.reserve(memory_.holding.capacity());
    subtree.memory.hidden.reserve(memory_.hidden.capacity());
  }

  /// Notes for the next frame how much work there was in each subtree.
  void note_work(std::size_t threads) {
    DeferredSubtrees& deferred = parts_.deferred;
    const auto work_of = [](const DeferredSubtree& subtree) { return subtree.found.stats.nodes_visited; };
    for (const DeferredSubtree& subtree : subtrees())
      deferred.work[subtree.block] = static_cast<std::uint32_t>(work_of(subtree));
    for (const auto& [block, first, end, own] : deferred.divided) {
      std::size_t work = own;
      for (std::size_t i = first; i < end; ++i) work += work_of(deferred.subtrees[i]);
      deferred.work[block] = static_cast<std::uint32_t>(work);
    }
    deferred.most_work = result_.stats.nodes_visited / (kSharesOfThread * threads);
  }

  void traverse(DeferredSubtree& subtree) const {
    subtree.found.drawn.clear();
    subtree.found.culled.clear();
    subtree.found.stats = {};
    Traversal(tree_, tests_, shadows_.occluders, shadows_.probes, subtree.found, subtree.memory).run(subtree);
  }

  void join() {
    parts_.drawn.reserve(result_.drawn.capacity());
    parts_.culled.reserve(result_.culled.capacity());
    parts_.drawn.swap(result_.drawn);
    parts_.culled.swap(result_.culled);
    result_.drawn.clear();
    result_.culled.clear();
    std::size_t drawn = 0, culled = 0;
    for (const DeferredSubtree& subtree : subtrees()) {
      append(std::span(parts_.drawn).subspan(drawn, subtree.drawn - drawn),
             std::span(parts_.culled).subspan(culled, subtree.culled - culled));
      drawn = subtree.drawn;
      culled = subtree.culled;
      append(subtree.found.drawn, subtree.found.culled);
      add_counts(result_.stats, subtree.found.stats);
      for (std::size_t i = 0; i < memory_.hidden.size(); ++i) memory_.hidden[i] += subtree.memory.hidden[i];
    }
    append(std::span(parts_.drawn).subspan(drawn), std::span(parts_.culled).subspan(culled));
  }
  void append(std::span<const PolygonRange> drawn, std::span<const Culled> culled) {
    for (const PolygonRange& range : drawn) append_range(result_.drawn, range);
    result_.culled.insert(result_.culled.end(), culled.begin(), culled.end());
  }

  const BlockTree tree_;
  Tests& tests_;
  ShadowCounts shadows_;
  CullResult& result_;
  TraversalMemory& memory_;
  ParallelMemory& parts_;
  WorkRunner& runner_;
};

}  // namespace occlude::culler
