// SPDX-License-Identifier: MIT
// The objects of a scene in one tree: static ones below one child of the root, dynamic ones below the other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "box_tree.h"
#include "occlude/culler/box.h"
#include "occlude/culler/checkpoint.h"
#include "occlude/culler/hierarchy.h"

namespace occlude::culler {

/// Items are the objects: first the static ones in the order given, then the dynamic ones. Each has a leaf of its own, whose
/// bounding volume is the object's box. Inner nodes are axis-aligned boxes that hold the boxes below them exactly. So an
/// object is culled if and only if its own box is to be culled, whatever the tree.
class ObjectTree {
 public:
  /// Throws std::invalid_argument, with the object and the reason, for a box with a refusal_of().
  ObjectTree(std::span<const Box> statics, std::span<const Box> dynamics, const Checkpoint& checkpoint = {});

  [[nodiscard]] std::size_t statics() const { return statics_; }
  [[nodiscard]] std::size_t dynamics() const { return next_.size(); }

  /// Takes effect at the next update(). Throws std::invalid_argument as the constructor does, and if there is no such
  /// object.
  void set_bounds(std::size_t dynamic, const Box& box);
  /// Applies the boxes that were set. Refits the tree of the dynamic objects, or rebuilds it if it has become loose.
  void update();

  /// Empty without objects.
  [[nodiscard]] std::span<const HierarchyNode> nodes() const { return tree_.nodes; }
  /// The root of the static objects' part of nodes(). REQUIRES: there are static objects.
  [[nodiscard]] std::uint32_t static_root() const { return dynamics() == 0 ? 0 : 1; }
  /// The items in the order of the leaves: first the static ones, then the dynamic ones.
  [[nodiscard]] std::span<const std::uint32_t> order() const { return tree_.order; }
  /// Calls question(box) with the bounding volume of the node.
  template <class Question>
  decltype(auto) ask(std::uint32_t node, Question&& question) const {
    const HierarchyNode& n = tree_.nodes[node];
    return n.is_leaf() ? std::visit(question, boxes_[tree_.order[n.first]]) : question(n.box);
  }

 private:
  void add(std::span<const Box> boxes, const char* kind);
  void append_dynamics(const Checkpoint& checkpoint);

  std::size_t statics_;
  std::vector<Box> boxes_;           ///< of the items
  std::vector<kernel::Aabb> outer_;  ///< axis-aligned boxes around them
  std::vector<Box> next_;            ///< of the dynamic ones, from the next update on
  BoxTree tree_;                     ///< of all items
  std::size_t first_moving_ = 0;     ///< the first node of the dynamic objects
  double least_cost_ = 0;            ///< of the dynamic objects' tree since it was built
};

}  // namespace occlude::culler
