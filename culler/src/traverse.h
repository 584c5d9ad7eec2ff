// SPDX-License-Identifier: MIT
// The traversal of section 5: one descent of the hierarchy culls by the view frustum, culls by the shadow frusta and draws.
//
// It knows neither frusta nor boxes: `tests` classifies a node against half-space or shadow i, or against two shadows
// together. A half-space that holds a node, and a shadow that does not meet it, are dropped below the node. Any number of
// either can be active.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "occlude/culler/append_range.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/hierarchy.h"

namespace occlude::culler {

/// The work that the tests of pairs may take in a frame, for each of its occluders and in all. Beyond it, pairs are not
/// tested. The exact stage takes up to a microsecond for each plane of the one shadow and plane of the other, so this is 16
/// ms and a second. The models tried take at most half of it: 8,300 for each of eight occluders, 8,000 for each of 64.
inline constexpr std::size_t kPairWorkOfEach = std::size_t{1} << 14U, kMostPairWork = std::size_t{1} << 20U;

/// Probes are not followed into subtrees of this many polygons or fewer, because what they hide there is little.
inline constexpr std::uint32_t kProbed = 64;

template <class Tests>
class Traversal {
 public:
  /// `tests` has view(plane, node), shadow(occluder, node), pair(first, second, node) and probe(probe, node), which return a
  /// kernel::Relation, and pair_work(first, second), the pairs of planes that a test of both may ask. What is in
  /// `result.drawn` before run() stays. The stacks are cleared.
  Traversal(std::span<const HierarchyNode> nodes, Tests& tests, std::span<Occluder> probes, CullResult& result,
            std::vector<std::uint32_t>& stack, std::vector<std::uint32_t>& holding)
      : nodes_(nodes), tests_(tests), probes_(probes), result_(result), active_(stack), holding_(holding) {}

  void run() {
    active_.clear();
    holding_.clear();
    pair_work_left_ = std::min(kMostPairWork, kPairWorkOfEach * result_.occluders.size());
    for (std::uint32_t i = 0; i < result_.view.size(); ++i) active_.push_back(i);
    const std::size_t middle = active_.size();
    for (std::uint32_t i = 0; i < result_.occluders.size(); ++i) active_.push_back(i);
    const std::size_t end = active_.size();
    for (std::uint32_t i = 0; i < probes_.size(); ++i) active_.push_back(i);
    visit(0, {0, middle, end, active_.size()});
  }

 private:
  /// What is active at a node: half-spaces active_[begin, middle), shadows active_[middle, end), probes
  /// active_[end, probes_end).
  struct Active {
    std::size_t begin, middle, end, probes_end;
  };

  void visit(std::uint32_t index, const Active& above) {
    const HierarchyNode& node = nodes_[index];
    ++result_.stats.nodes_visited;
    const std::size_t begin = active_.size();
    if (!is_culled(index, node, above)) {
      const std::size_t middle = begin + still_viewed_, end = active_.size(), holding = holding_.size();
      probe(index, above);
      const Active here{begin, middle, end, active_.size()};
      const bool undecided = here.begin != here.end || (here.end != here.probes_end && node.count > kProbed);
      if (undecided && !node.is_leaf()) {
        visit(index + 1, here);
        visit(node.right, here);
      } else {
        draw(node);
      }
      holding_.resize(holding);
    }
    active_.resize(begin);
  }

  /// Tests the node against all that is active above it and appends what stays active below it.
  bool is_culled(std::uint32_t index, const HierarchyNode& node, const Active& above) {
    using kernel::Relation;
    const std::size_t begin = active_.size();
    for (std::size_t i = above.begin; i < above.middle; ++i) {
      const std::uint32_t plane = active_[i];
      ++result_.stats.view_tests;
      const Relation relation = tests_.view(plane, index);
      if (relation == Relation::outside) return cull(node, {index, Culled::By::view, plane});
      if (relation == Relation::partial) active_.push_back(plane);
    }
    still_viewed_ = active_.size() - begin;
    for (std::size_t i = above.middle; i < above.end; ++i) {
      const std::uint32_t occluder = active_[i];
      ++result_.stats.shadow_tests;
      const Relation relation = tests_.shadow(occluder, index);
      if (relation == Relation::inside) return cull(node, {index, Culled::By::shadow, occluder});
      if (relation == Relation::partial) active_.push_back(occluder);
    }
    return is_culled_by_pair(index, node, std::span(active_).subspan(begin + still_viewed_));
  }

  /// Tests the node against the pairs of the shadows that it straddles. `across` is in ascending order.
  bool is_culled_by_pair(std::uint32_t index, const HierarchyNode& node, std::span<const std::uint32_t> across) {
    if (across.size() < 2) return false;
    for (const auto& [first, second] : result_.pairs) {
      if (!std::ranges::binary_search(across, first) || !std::ranges::binary_search(across, second)) continue;
      if (!may_ask(first, second)) continue;
      ++result_.stats.union_tests;
      if (tests_.pair(first, second, index) == kernel::Relation::inside) {
        return cull(node, {index, Culled::By::shadow, first, second});
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

  /// Tests the probes that are active above the node. Those that hold it are told what is drawn below. Those that it
  /// straddles stay active.
  void probe(std::uint32_t index, const Active& above) {
    using kernel::Relation;
    for (std::size_t i = above.end; i < above.probes_end; ++i) {
      const std::uint32_t p = active_[i];
      ++result_.stats.probe_tests;
      const Relation relation = tests_.probe(p, index);
      if (relation == Relation::inside) holding_.push_back(p);
      if (relation == Relation::partial) active_.push_back(p);
    }
  }

  bool cull(const HierarchyNode& node, const Culled& culled) {
    result_.culled.push_back(culled);
    if (culled.by == Culled::By::view) {
      result_.stats.view_culled_polygons += node.count;
    } else {
      result_.stats.shadow_culled_polygons += node.count;
      result_.occluders[culled.index].hidden += node.count;
      if (culled.second != Culled::kNone) result_.occluders[culled.second].hidden += node.count;
    }
    return true;
  }

  void draw(const HierarchyNode& node) {
    append_range(result_.drawn, {node.first, node.count});
    result_.stats.drawn_polygons += node.count;
    for (const std::uint32_t p : holding_) probes_[p].hidden += node.count;
  }

  std::span<const HierarchyNode> nodes_;
  Tests& tests_;
  std::span<Occluder> probes_;
  CullResult& result_;
  std::vector<std::uint32_t>& active_;   ///< a stack: each level of the descent appends its own
  std::vector<std::uint32_t>& holding_;  ///< a stack: probes that hold the node or one above it
  std::size_t pair_work_left_ = 0;
  std::size_t still_viewed_ = 0;  ///< half-spaces appended by the last is_culled()
};

}  // namespace occlude::culler
