// SPDX-License-Identifier: MIT
// The traversal on several threads. A traversal from the root puts subtrees off. Each of them is then traversed by itself,
// on any thread, and what was found is joined in the order of the tree. The result is that of one traversal.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <span>
#include <vector>

#include "node_blocks.h"
#include "occlude/culler/append_range.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/executor.h"
#include "traverse.h"

namespace occlude::culler {

/// A subtree of fewer items takes less time than its start on another thread.
inline constexpr std::uint32_t kLeastPutOff = 64;
/// Each thread is given about so many subtrees, large ones and small, so that all threads finish at about the same time.
/// With twice as many, more is traversed before the first of them starts.
inline constexpr std::size_t kPutOffOfThread = 8;

/// What the subtrees are joined from.
struct PartsMemory {
  PutOffSubtrees put_off;
  std::vector<PolygonRange> drawn;  ///< by the traversal from the root
  std::vector<Culled> culled;
};

/// What a frame's shadows are cast by.
struct ShadowCounts {
  std::uint32_t occluders, probes;
};

/// Adds what a traversal counts.
inline void add_counts(CullStats& sum, const CullStats& part) {
  sum.nodes_visited += part.nodes_visited;
  sum.view_tests += part.view_tests;
  sum.shadow_tests += part.shadow_tests;
  sum.union_tests += part.union_tests;
  sum.probe_tests += part.probe_tests;
  sum.exact_shadow_tests += part.exact_shadow_tests;
  sum.drawn_polygons += part.drawn_polygons;
  sum.view_culled_polygons += part.view_culled_polygons;
  sum.shadow_culled_polygons += part.shadow_culled_polygons;
}

template <class Tests>
class TraversalInParts {
 public:
  /// `tests` as Traversal; its calls may come from several threads at once.
  TraversalInParts(const NodeBlocks& blocks, Tests& tests, const ShadowCounts& shadows, CullResult& result,
                   TraversalMemory& memory, PartsMemory& parts)
      : blocks_(blocks), tests_(tests), shadows_(shadows), result_(result), memory_(memory), parts_(parts) {}

  /// `planes` has a bit for each half-space of the view. Pairs share a budget, in the order of the tree (kMostPairWork):
  /// where there are any, nothing is put off.
  void run(std::uint32_t planes, const Executor* executor) {
    PutOffSubtrees& put_off = parts_.put_off;
    const bool is_alone = executor == nullptr || executor->threads() == 1 || !result_.pairs.empty();
    put_off.size = 0;
    put_off.least = kLeastPutOff;
    put_off.most = is_alone ? 0 : static_cast<std::uint32_t>(blocks_[0].count[0] / (kPutOffOfThread * executor->threads()));
    Traversal(blocks_, tests_, shadows_.occluders, shadows_.probes, result_, memory_).run(planes, put_off);
    if (put_off.size == 0) return;
    for (PutOffSubtree& subtree : subtrees()) prepare(subtree);
    const auto traverse = [&](std::size_t i) {
      PutOffSubtree& subtree = subtrees()[i];
      Traversal(blocks_, tests_, shadows_.occluders, shadows_.probes, subtree.found, subtree.memory).run(subtree);
    };
    executor->run(put_off.size, std::cref(traverse));
    join();
  }

 private:
  std::span<PutOffSubtree> subtrees() { return std::span(parts_.put_off.subtrees).first(parts_.put_off.size); }

  /// Empties what was found there in another frame, and reserves memory for all that may be: nothing can then fail on
  /// another thread. Memory that is never written to takes only addresses.
  void prepare(PutOffSubtree& subtree) {
    subtree.found.drawn.clear();
    subtree.found.culled.clear();
    subtree.found.stats = {};
    subtree.found.drawn.reserve((parts_.put_off.most + 1) / 2);
    subtree.found.culled.reserve(parts_.put_off.most);
    subtree.memory.active.reserve(memory_.active.capacity());
    subtree.memory.holding.reserve(memory_.holding.capacity());
    subtree.memory.hidden.reserve(memory_.hidden.capacity());
  }

  void join() {
    parts_.drawn.reserve(result_.drawn.capacity());
    parts_.culled.reserve(result_.culled.capacity());
    parts_.drawn.assign(result_.drawn.begin(), result_.drawn.end());
    parts_.culled.assign(result_.culled.begin(), result_.culled.end());
    result_.drawn.clear();
    result_.culled.clear();
    std::size_t drawn = 0, culled = 0;
    for (const PutOffSubtree& subtree : subtrees()) {
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

  const NodeBlocks& blocks_;
  Tests& tests_;
  ShadowCounts shadows_;
  CullResult& result_;
  TraversalMemory& memory_;
  PartsMemory& parts_;
};

}  // namespace occlude::culler
