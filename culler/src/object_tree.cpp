// SPDX-License-Identifier: MIT
#include "object_tree.h"

#include <algorithm>
#include <numeric>
#include <stdexcept>
#include <string>

#include "outer_box.h"

namespace occlude::culler {
namespace {

/// The tree of the dynamic objects is rebuilt when its cost exceeds its least cost since the last rebuild by this factor. A
/// descent visits nodes in proportion to the cost. So with 2 a loose tree never adds more than what a fresh one costs in
/// all, and the tree of objects that only drift apart is rebuilt each time its surfaces double. The least cost counts, not
/// the first: else objects that begin scattered, meet and scatter in another way would pass unnoticed. The cost is in model
/// units, not a share of the root: objects that all begin at one place have a tree without any order, which is bad only once
/// they have left it.
constexpr double kLoose = 2;

void require_legal(const Box& box, const char* kind, std::size_t id) {
  const kernel::Refusal refusal = refusal_of(box);
  if (refusal == kernel::Refusal::none) return;
  throw std::invalid_argument(std::string(kind) + " object " + std::to_string(id) + ": " +
                              std::string(kernel::to_string(refusal)));
}

}  // namespace

ObjectTree::ObjectTree(std::span<const Box> statics, std::span<const Box> dynamics, const Checkpoint& checkpoint)
    : statics_(statics.size()), next_(dynamics.begin(), dynamics.end()) {
  add(statics, "static");
  add(dynamics, "dynamic");
  tree_.order.resize(boxes_.size());
  std::iota(tree_.order.begin(), tree_.order.end(), 0U);
  const auto count = static_cast<std::uint32_t>(boxes_.size());
  const bool has_both = !statics.empty() && !dynamics.empty();
  if (has_both) tree_.nodes.push_back({.box = {}, .first = 0, .count = count});
  if (!statics.empty()) tree_.append(outer_, 0, static_cast<std::uint32_t>(statics_), 1, checkpoint);
  first_moving_ = tree_.nodes.size();
  if (!dynamics.empty()) append_dynamics(checkpoint);
  if (!has_both) return;
  tree_.nodes[0].right = static_cast<std::uint32_t>(first_moving_);
  tree_.join_children(0);
}

void ObjectTree::add(std::span<const Box> boxes, const char* kind) {
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    require_legal(boxes[i], kind, i);
    boxes_.push_back(boxes[i]);
    outer_.push_back(outer_box(boxes[i]));
  }
}

void ObjectTree::append_dynamics(const Checkpoint& checkpoint) {
  tree_.append(outer_, static_cast<std::uint32_t>(statics_), static_cast<std::uint32_t>(next_.size()), 1, checkpoint);
  least_cost_ = tree_.cost(first_moving_);
}

void ObjectTree::set_bounds(std::size_t dynamic, const Box& box) {
  if (dynamic >= next_.size()) throw std::invalid_argument("there is no dynamic object " + std::to_string(dynamic));
  require_legal(box, "dynamic", dynamic);
  next_[dynamic] = box;
}

void ObjectTree::update() {
  if (next_.empty()) return;
  for (std::size_t i = 0; i < next_.size(); ++i) {
    boxes_[statics_ + i] = next_[i];
    outer_[statics_ + i] = outer_box(next_[i]);
  }
  tree_.refit(outer_, first_moving_);
  const double cost = tree_.cost(first_moving_);
  if (cost > kLoose * least_cost_) {
    tree_.nodes.resize(first_moving_);
    append_dynamics({});
  } else {
    least_cost_ = std::min(least_cost_, cost);
  }
  if (first_moving_ > 0) tree_.join_children(0);
}

}  // namespace occlude::culler
