// SPDX-License-Identifier: MIT
#include "occlude/culler/hierarchy.h"

#include <algorithm>
#include <limits>
#include <memory>
#include <stdexcept>
#include <utility>

#include "bounds.h"
#include "box_tree.h"
#include "oriented_box.h"

namespace occlude::culler {
namespace {

using kernel::Aabb;

std::vector<Aabb> polygon_boxes(const PolygonSoup& soup, const Checkpoint& checkpoint) {
  std::vector<Aabb> boxes(soup.size());
  for (std::size_t p = 0; p < soup.size(); ++p) {
    checkpoint.at(p);
    boxes[p] = soup.box(p);
  }
  return boxes;
}

PolygonSoup reordered(const PolygonSoup& soup, const std::vector<std::uint32_t>& order, const Checkpoint& checkpoint) {
  PolygonSoup result;
  result.vertices = soup.vertices;
  result.indices.reserve(soup.indices.size());
  result.first.reserve(soup.first.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    checkpoint.at(i);
    result.add_polygon(soup.loop(order[i]));
  }
  return result;
}

bool is_permutation(const std::vector<std::uint32_t>& order, std::size_t size) {
  std::vector<bool> is_there(size);
  for (const std::uint32_t i : order) {
    if (i >= size || is_there[i]) return false;
    is_there[i] = true;
  }
  return order.size() == size;
}

/// Every split of build() leaves at most 15/16 of the extent along an axis on either side. Coordinates that are not equal
/// differ by at least 2^-152 and at most 2^101. So there are at most 3 ln 2^253 / ln(16/15) levels of such splits, and 32
/// levels of halving. The traversal takes some hundred bytes of stack for each level.
constexpr std::uint32_t kDeepest = 8192;

/// The nodes of a layout over `count` polygons, without their boxes.
std::vector<Hierarchy::Node> nodes_of(const std::vector<std::uint32_t>& left, std::uint32_t count) {
  std::vector<Hierarchy::Node> nodes(left.size());
  /// A subtree that is still to come: its polygons, its depth, and the node whose right child it is, or kNoParent.
  struct Pending {
    std::uint32_t first, count, depth;
    std::size_t parent;
  };
  constexpr std::size_t kNoParent = std::numeric_limits<std::size_t>::max();
  std::vector<Pending> pending{{0, count, 0, kNoParent}};
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (pending.empty()) throw std::invalid_argument("the tree has more nodes than it holds together");
    const Pending at = pending.back();
    pending.pop_back();
    if (at.parent != kNoParent) nodes[at.parent].right = static_cast<std::uint32_t>(i);
    nodes[i].first = at.first;
    nodes[i].count = at.count;
    if (left[i] == 0) continue;
    if (at.depth == kDeepest) throw std::invalid_argument("the tree is too deep");
    if (left[i] >= at.count) throw std::invalid_argument("a node of the tree has no polygon");
    pending.push_back({at.first + left[i], at.count - left[i], at.depth + 1, i});
    pending.push_back({at.first, left[i], at.depth + 1, kNoParent});
  }
  if (!pending.empty()) throw std::invalid_argument("the tree ends too early");
  return nodes;
}

}  // namespace

Hierarchy::Hierarchy(const PolygonSoup& soup, const Config& config, BoxTree tree, const Checkpoint& checkpoint)
    : soup_(std::make_shared<const PolygonSoup>(reordered(soup, tree.order, checkpoint))),
      leaf_size_(config.leaf_size),
      order_(std::move(tree.order)),
      nodes_(std::move(tree.nodes)) {
  if (config.bounds == Bounds::obb) fit_oriented_boxes(checkpoint);
}

Hierarchy Hierarchy::build(const PolygonSoup& soup, const Config& config, const Checkpoint& checkpoint) {
  BoxTree tree = BoxTree::build(polygon_boxes(soup, checkpoint), std::max(1U, config.leaf_size), checkpoint);
  return Hierarchy(soup, config, std::move(tree), checkpoint);
}

Hierarchy::Layout Hierarchy::layout() const {
  Layout layout{order_, {}};
  for (std::size_t i = 0; i < nodes_.size(); ++i) layout.left.push_back(nodes_[i].is_leaf() ? 0 : nodes_[i + 1].count);
  return layout;
}

Hierarchy Hierarchy::restore(const PolygonSoup& soup, const Config& config, const Layout& layout,
                             const Checkpoint& checkpoint) {
  if (!is_permutation(layout.order, soup.size())) throw std::invalid_argument("the order is not one of this model");
  BoxTree tree{layout.order, nodes_of(layout.left, static_cast<std::uint32_t>(soup.size()))};
  tree.refit(polygon_boxes(soup, checkpoint));
  return Hierarchy(soup, config, std::move(tree), checkpoint);
}

/// An oriented box costs about twice as many operations as an axis-aligned one. If its surface is less than this share of
/// the other's, a plane crosses it so much less often that it pays.
constexpr double kWorthwhile = 0.8;

/// Bottom-up: a leaf tries the edges of its largest polygon, an inner node the axes of both its children.
void Hierarchy::fit_oriented_boxes(const Checkpoint& checkpoint) {
  std::vector<BoxAxes> axes(nodes_.size());
  oriented_.assign(nodes_.size(), kNone);
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    checkpoint();
    const Node& node = nodes_[i];
    const PolygonRange polygons{node.first, node.count};
    Fit best = node.is_leaf() ? fit_along_largest(*soup_, polygons) : fit_along(axes[i + 1], *soup_, polygons);
    if (!node.is_leaf()) {
      const Fit other = fit_along(axes[node.right], *soup_, polygons);
      if (other.half_area < best.half_area) best = other;
    }
    axes[i] = best.axes;
    if (!(best.half_area < kWorthwhile * half_area(node.box))) continue;
    if (const auto box = enclosing_box(best, *soup_, polygons)) {
      oriented_[i] = static_cast<std::uint32_t>(oriented_boxes_.size());
      oriented_boxes_.push_back(*box);
    }
  }
}

std::uint32_t Hierarchy::leaf_of(std::uint32_t p) const {
  std::uint32_t node = 0;
  while (!nodes_[node].is_leaf()) {
    const std::uint32_t right = nodes_[node].right;
    node = p < nodes_[right].first ? node + 1 : right;
  }
  return node;
}

}  // namespace occlude::culler
