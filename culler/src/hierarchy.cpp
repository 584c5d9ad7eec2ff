// SPDX-License-Identifier: MIT
#include "occlude/culler/hierarchy.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numeric>
#include <stdexcept>
#include <utility>

#include "bounds.h"
#include "oriented_box.h"

namespace occlude::culler {
namespace {

using kernel::Aabb;
using kernel::Vec3;

/// Candidate split positions an axis; 16 is where the gain of more flattens out (Wald 2007).
constexpr std::size_t kBins = 16;

struct Builder {
  const std::vector<Aabb>& boxes;     ///< of the polygons, by original index
  std::vector<std::uint32_t>& order;  ///< the permutation that the build establishes
  std::vector<Hierarchy::Node>& nodes;
  std::uint32_t leaf_size;

  double centre(std::uint32_t polygon, int axis) const {
    return boxes[polygon].min[axis] / 2 + boxes[polygon].max[axis] / 2;
  }

  /// Appends the subtree over order[first, first + count).
  void build(std::uint32_t first, std::uint32_t count) {
    const std::size_t self = nodes.size();
    nodes.push_back({.box = bounds(first, count), .first = first, .count = count});
    if (count <= leaf_size) return;
    const std::uint32_t left = partition(first, count);
    build(first, left);
    nodes[self].right = static_cast<std::uint32_t>(nodes.size());
    build(first + left, count - left);
  }

  Aabb bounds(std::uint32_t first, std::uint32_t count) const {
    Aabb box = empty_box();
    for (std::uint32_t i = first; i < first + count; ++i) grow(box, boxes[order[i]]);
    return box;
  }

  struct Split {
    double cost = std::numeric_limits<double>::infinity();
    int axis = 0;
    std::size_t bin = 0;  ///< polygons in bins below it go left
  };

  struct Binning {
    double low, scale;
    std::size_t operator()(double x) const { return std::min(kBins - 1, static_cast<std::size_t>((x - low) * scale)); }
  };

  /// Maps centres on an axis to bins; scale 0 when all centres coincide.
  Binning binning(std::uint32_t first, std::uint32_t count, int axis) const {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::uint32_t i = first; i < first + count; ++i) {
      low = std::min(low, centre(order[i], axis));
      high = std::max(high, centre(order[i], axis));
    }
    return {low, high > low ? static_cast<double>(kBins) / (high - low) : 0};
  }

  /// Cheapest split on an axis by the surface area heuristic: polygons times area, left plus right.
  Split best_split(std::uint32_t first, std::uint32_t count, int axis) const {
    const Binning bin = binning(first, count, axis);
    Split best{.axis = axis};
    if (bin.scale == 0) return best;
    std::array<Aabb, kBins> box;
    std::array<std::uint32_t, kBins> size{};
    box.fill(empty_box());
    for (std::uint32_t i = first; i < first + count; ++i) {
      const std::size_t b = bin(centre(order[i], axis));
      grow(box[b], boxes[order[i]]);
      ++size[b];
    }
    std::array<double, kBins> right_cost{};
    Aabb accumulated = empty_box();
    std::uint32_t polygons = 0;
    for (std::size_t b = kBins; b-- > 1;) {
      if (size[b] != 0) grow(accumulated, box[b]);
      polygons += size[b];
      right_cost[b] = polygons == 0 ? 0 : half_area(accumulated) * polygons;
    }
    accumulated = empty_box();
    polygons = 0;
    for (std::size_t b = 1; b < kBins; ++b) {
      if (size[b - 1] != 0) grow(accumulated, box[b - 1]);
      polygons += size[b - 1];
      if (polygons == 0 || polygons == count) continue;
      const double cost = half_area(accumulated) * polygons + right_cost[b];
      if (cost < best.cost) best = {cost, axis, b};
    }
    return best;
  }

  /// Reorders order[first, first + count) and returns how many polygons go left, at least one and not all.
  std::uint32_t partition(std::uint32_t first, std::uint32_t count) {
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
      if (const Split split = best_split(first, count, axis); split.cost < best.cost) best = split;
    }
    if (best.bin == 0) return count / 2;  // all centres coincide, or areas overflow: any halves will do
    const Binning bin = binning(first, count, best.axis);
    const auto begin = order.begin() + first;
    const auto middle = std::stable_partition(
        begin, begin + count, [&](std::uint32_t polygon) { return bin(centre(polygon, best.axis)) < best.bin; });
    return static_cast<std::uint32_t>(middle - begin);
  }
};

PolygonSoup reordered(const PolygonSoup& soup, const std::vector<std::uint32_t>& order) {
  PolygonSoup result;
  result.vertices = soup.vertices;
  result.indices.reserve(soup.indices.size());
  result.first.reserve(soup.first.size());
  for (const std::uint32_t polygon : order) result.add_polygon(soup.loop(polygon));
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

/// Every split of build() leaves at most 15 in 16 of the extent along an axis to either side. Coordinates that are not equal
/// differ by 2^-152 at least and by 2^101 at most, so that there are no more than 3 ln 2^253 / ln(16/15) levels of such
/// splits, and 32 of halves. The traversal takes some hundred bytes of stack for each.
constexpr std::uint32_t kDeepest = 8192;

/// The nodes of a layout over `count` polygons, without their boxes.
std::vector<Hierarchy::Node> nodes_of(const std::vector<std::uint32_t>& left, std::uint32_t count) {
  std::vector<Hierarchy::Node> nodes(left.size());
  /// Subtrees that begin at the next node: their polygons, how deep they lie, and the node whose right child they are, or
  /// kNoParent.
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
    if (at.depth == kDeepest) throw std::invalid_argument("the tree is deeper than any that is built");
    if (left[i] >= at.count) throw std::invalid_argument("a node of the tree has no polygon");
    pending.push_back({at.first + left[i], at.count - left[i], at.depth + 1, i});
    pending.push_back({at.first, left[i], at.depth + 1, kNoParent});
  }
  if (!pending.empty()) throw std::invalid_argument("the tree ends too early");
  return nodes;
}

}  // namespace

Hierarchy::Hierarchy(const PolygonSoup& soup, const Config& config, std::vector<std::uint32_t> order,
                     std::vector<Node> nodes)
    : soup_(reordered(soup, order)), order_(std::move(order)), nodes_(std::move(nodes)) {
  if (config.bounds == Bounds::obb) fit_oriented_boxes();
}

Hierarchy Hierarchy::build(const PolygonSoup& soup, const Config& config) {
  std::vector<Aabb> boxes(soup.size());
  for (std::size_t p = 0; p < soup.size(); ++p) boxes[p] = polygon_box(soup, p);
  std::vector<std::uint32_t> order(soup.size());
  std::iota(order.begin(), order.end(), 0U);
  std::vector<Node> nodes;
  Builder{boxes, order, nodes, std::max(1U, config.leaf_size)}.build(0, static_cast<std::uint32_t>(soup.size()));
  return Hierarchy(soup, config, std::move(order), std::move(nodes));
}

Hierarchy::Layout Hierarchy::layout() const {
  Layout layout{order_, {}};
  for (std::size_t i = 0; i < nodes_.size(); ++i) layout.left.push_back(nodes_[i].is_leaf() ? 0 : nodes_[i + 1].count);
  return layout;
}

Hierarchy Hierarchy::restore(const PolygonSoup& soup, const Config& config, const Layout& layout) {
  if (!is_permutation(layout.order, soup.size())) throw std::invalid_argument("the order is not one of this model");
  std::vector<Node> nodes = nodes_of(layout.left, static_cast<std::uint32_t>(soup.size()));
  for (std::size_t i = nodes.size(); i-- > 0;) {
    Node& node = nodes[i];
    if (!node.is_leaf()) {
      node.box = nodes[i + 1].box;
      grow(node.box, nodes[node.right].box);
      continue;
    }
    node.box = empty_box();
    for (std::uint32_t p = node.first; p < node.first + node.count; ++p) grow(node.box, polygon_box(soup, layout.order[p]));
  }
  return Hierarchy(soup, config, layout.order, std::move(nodes));
}

/// An oriented box costs about twice as many operations as an axis-aligned one; below this share of its surface it is
/// crossed so much less often that it pays.
constexpr double kWorthwhile = 0.8;

/// Bottom-up: a leaf tries the edges of its largest polygon, an inner node the axes of both its children.
void Hierarchy::fit_oriented_boxes() {
  std::vector<BoxAxes> axes(nodes_.size());
  oriented_.assign(nodes_.size(), kNone);
  for (std::size_t i = nodes_.size(); i-- > 0;) {
    const Node& node = nodes_[i];
    const PolygonRange polygons{node.first, node.count};
    Fit best = node.is_leaf() ? fit_along_largest(soup_, polygons) : fit_along(axes[i + 1], soup_, polygons);
    if (!node.is_leaf()) {
      const Fit other = fit_along(axes[node.right], soup_, polygons);
      if (other.half_area < best.half_area) best = other;
    }
    axes[i] = best.axes;
    if (!(best.half_area < kWorthwhile * half_area(node.box))) continue;
    if (const auto box = enclosing_box(best, soup_, polygons)) {
      oriented_[i] = static_cast<std::uint32_t>(oriented_boxes_.size());
      oriented_boxes_.push_back(*box);
    }
  }
}

}  // namespace occlude::culler
