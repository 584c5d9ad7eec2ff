// SPDX-License-Identifier: MIT
// The traversal of section 5: one descent of the hierarchy culls by the view frustum, culls by the shadow frusta and draws.
//
// It knows no frusta and no boxes: two callables classify a node against half-space or shadow i. A half-space that a node
// is inside of, and a shadow that it is outside of, are dropped below it; any number of either can be active.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "occlude/culler/culler.h"

namespace occlude::culler {

template <class ViewTest, class ShadowTest>
class Traversal {
 public:
  Traversal(const Hierarchy& hierarchy, ViewTest& view_test, ShadowTest& shadow_test, CullResult& result)
      : hierarchy_(hierarchy), view_test_(view_test), shadow_test_(shadow_test), result_(result) {}

  void run() {
    for (std::uint32_t i = 0; i < result_.view.size(); ++i) active_.push_back(i);
    const std::size_t middle = active_.size();
    for (std::uint32_t i = 0; i < result_.occluders.size(); ++i) active_.push_back(i);
    visit(0, {0, middle, active_.size()});
  }

 private:
  /// What is active at a node: half-spaces active_[begin, middle), shadows active_[middle, end).
  struct Active {
    std::size_t begin, middle, end;
  };

  void visit(std::uint32_t index, const Active& above) {
    const Hierarchy::Node& node = hierarchy_.nodes()[index];
    ++result_.stats.nodes_visited;
    const std::size_t begin = active_.size();
    if (!is_culled(index, node, above)) {
      const Active here{begin, begin + still_viewed_, active_.size()};
      const bool undecided = here.begin != here.end;
      if (undecided && !node.is_leaf()) {
        visit(index + 1, here);
        visit(node.right, here);
      } else {
        draw(node);
      }
    }
    active_.resize(begin);
  }

  /// Tests the node against all that is active above it and appends what stays active below it.
  bool is_culled(std::uint32_t index, const Hierarchy::Node& node, const Active& above) {
    using kernel::Relation;
    const std::size_t begin = active_.size();
    for (std::size_t i = above.begin; i < above.middle; ++i) {
      const std::uint32_t plane = active_[i];
      ++result_.stats.view_tests;
      const Relation relation = view_test_(plane, index);
      if (relation == Relation::outside) return cull(index, node, Culled::By::view, plane);
      if (relation == Relation::partial) active_.push_back(plane);
    }
    still_viewed_ = active_.size() - begin;
    for (std::size_t i = above.middle; i < above.end; ++i) {
      const std::uint32_t occluder = active_[i];
      ++result_.stats.shadow_tests;
      const Relation relation = shadow_test_(occluder, index);
      if (relation == Relation::inside) return cull(index, node, Culled::By::shadow, occluder);
      if (relation == Relation::partial) active_.push_back(occluder);
    }
    return false;
  }

  bool cull(std::uint32_t index, const Hierarchy::Node& node, Culled::By by, std::uint32_t reason) {
    result_.culled.push_back({index, by, reason});
    (by == Culled::By::view ? result_.stats.view_culled_polygons : result_.stats.shadow_culled_polygons) += node.count;
    if (by == Culled::By::shadow) result_.occluders[reason].hidden += node.count;
    return true;
  }

  void draw(const Hierarchy::Node& node) {
    auto& drawn = result_.drawn;
    if (!drawn.empty() && drawn.back().first + drawn.back().count == node.first) {
      drawn.back().count += node.count;
    } else {
      drawn.push_back({node.first, node.count});
    }
    result_.stats.drawn_polygons += node.count;
  }

  const Hierarchy& hierarchy_;
  ViewTest& view_test_;
  ShadowTest& shadow_test_;
  CullResult& result_;
  std::vector<std::uint32_t> active_;  ///< a stack: each level of the descent appends its own
  std::size_t still_viewed_ = 0;       ///< half-spaces appended by the last is_culled()
};

}  // namespace occlude::culler
