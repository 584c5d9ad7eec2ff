// SPDX-License-Identifier: MIT
#include "occlude/culler/hierarchy.h"

#include <algorithm>
#include <utility>

#include "model/bounds.h"
#include "model/box_tree.h"
#include "model/oriented_box.h"

namespace occlude::culler {
namespace {

using kernel::Aabb;

std::vector<Aabb> polygon_boxes(SoupView soup, const Checkpoint& checkpoint) {
  std::vector<Aabb> boxes(soup.size());
  for (std::size_t p = 0; p < soup.size(); ++p) {
    checkpoint.at(p);
    boxes[p] = soup.box(p);
  }
  return boxes;
}

PolygonSoup reordered(PolygonSoup soup, const std::vector<std::uint32_t>& order, const Checkpoint& checkpoint) {
  PolygonSoup result;
  result.vertices = std::move(soup.vertices);
  result.indices.reserve(soup.indices.size());
  result.first.reserve(soup.first.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    checkpoint.at(i);
    result.add_polygon(soup.loop(order[i]));
  }
  if (soup.see_through.empty()) return result;
  result.see_through.reserve(order.size());
  for (const std::uint32_t p : order) result.see_through.push_back(soup.see_through[p]);
  return result;
}

}  // namespace

Hierarchy::Hierarchy(PolygonSoup soup, const Config& config, BoxTree tree, const Checkpoint& checkpoint)
    : faces_(std::move(soup.faces)),
      soup_(reordered(std::move(soup), tree.order, checkpoint)),
      leaf_size_(config.leaf_size),
      order_(std::move(tree.order)),
      nodes_(std::move(tree.nodes)) {
  if (config.bounds == Bounds::obb) fit_oriented_boxes(checkpoint);
}

Hierarchy Hierarchy::build(PolygonSoup soup, const Config& config, const Checkpoint& checkpoint) {
  BoxTree tree = BoxTree::build(polygon_boxes(soup, checkpoint), std::max(1U, config.leaf_size), checkpoint);
  return Hierarchy(std::move(soup), config, std::move(tree), checkpoint);
}

/// An oriented box costs about twice as many operations as an axis-aligned one. If its surface is less than this share of
/// the other's, a plane crosses it so much less often that it pays.
constexpr double kWorthwhile = 0.8;

/// Bottom-up: a leaf tries the edges of its largest polygon, an inner node the axes of both its children.
void Hierarchy::fit_oriented_boxes(const Checkpoint& checkpoint) {
  std::vector<BoxAxes> axes(nodes_.size());
  std::vector<kernel::Obb> boxes;
  std::vector<std::uint32_t> oriented(nodes_.size(), kNone);
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    checkpoint();
    const Node& node = nodes_[i];
    const PolygonRange polygons{node.first, node.count};
    Fit best = node.is_leaf() ? fit_along_largest(soup(), polygons) : fit_along(axes[i + 1], soup(), polygons);
    if (!node.is_leaf()) {
      const Fit other = fit_along(axes[node.right], soup(), polygons);
      if (other.half_area < best.half_area) best = other;
    }
    axes[i] = best.axes;
    if (!(best.half_area < kWorthwhile * half_area(node.box))) continue;
    if (const auto box = enclosing_box(best, soup(), polygons)) {
      oriented[i] = static_cast<std::uint32_t>(boxes.size());
      boxes.push_back(*box);
    }
  }
  oriented_boxes_ = std::move(boxes);
  oriented_ = std::move(oriented);
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
