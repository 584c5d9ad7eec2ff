// SPDX-License-Identifier: MIT
#include "model/box_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <numeric>

#include "model/bounds.h"

namespace occlude::culler {
namespace {

using kernel::Aabb;

Aabb bounds(std::span<const Aabb> boxes, std::span<const std::uint32_t> items) {
  Aabb box = empty_box();
  for (const std::uint32_t item : items) grow(box, boxes[item]);
  return box;
}

/// Candidate split positions per axis. More than 16 gain little (Wald 2007).
constexpr std::size_t kBins = 16;

struct Builder {
  std::span<const Aabb> boxes;  ///< of all items, by their number
  std::vector<std::uint32_t>& order;
  std::vector<HierarchyNode>& nodes;
  std::vector<std::uint32_t>& spare;
  std::uint32_t leaf_size;
  const Checkpoint& checkpoint;

  double centre(std::uint32_t item, int axis) const { return boxes[item].min[axis] / 2 + boxes[item].max[axis] / 2; }

  /// Appends the subtree over order[first, first + count), with at most so many levels below its root.
  /// REQUIRES: halving takes no more.
  void build(std::uint32_t first, std::uint32_t count, std::uint32_t levels) {
    const std::size_t self = nodes.size();
    nodes.push_back({.box = bounds(boxes, std::span(order).subspan(first, count)), .first = first, .count = count});
    if (count <= leaf_size) return;
    const std::uint32_t left = levels_of_halving(count) < levels ? partition(first, count) : count / 2;
    build(first, left, levels - 1);
    nodes[self].right = static_cast<std::uint32_t>(nodes.size());
    build(first + left, count - left, levels - 1);
  }

  /// How many levels there are below a node of so many items where each node has half of those above it, rounded up or down,
  /// and a leaf has one.
  static std::uint32_t levels_of_halving(std::uint32_t count) {
    return static_cast<std::uint32_t>(std::bit_width(count - 1));
  }

  struct Split {
    double cost = std::numeric_limits<double>::infinity();
    int axis = 0;
    std::size_t bin = 0;  ///< items in lower bins go left
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

  /// The cheapest split on an axis by the surface area heuristic: number of items times area, left plus right.
  Split best_split(std::uint32_t first, std::uint32_t count, int axis) const {
    checkpoint();
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
    std::uint32_t items = 0;
    for (std::size_t b = kBins; b-- > 1;) {
      if (size[b] != 0) grow(accumulated, box[b]);
      items += size[b];
      right_cost[b] = items == 0 ? 0 : half_area(accumulated) * items;
    }
    accumulated = empty_box();
    items = 0;
    for (std::size_t b = 1; b < kBins; ++b) {
      if (size[b - 1] != 0) grow(accumulated, box[b - 1]);
      items += size[b - 1];
      if (items == 0 || items == count) continue;
      const double cost = half_area(accumulated) * items + right_cost[b];
      if (cost < best.cost) best = {cost, axis, b};
    }
    return best;
  }

  /// Reorders order[first, first + count) and returns how many items go left: at least one, and not all.
  std::uint32_t partition(std::uint32_t first, std::uint32_t count) {
    Split best;
    for (int axis = 0; axis < 3; ++axis) {
      if (const Split split = best_split(first, count, axis); split.cost < best.cost) best = split;
    }
    if (best.bin == 0) return count / 2;  // all centres coincide, or areas overflow: any halves will do
    const Binning bin = binning(first, count, best.axis);
    return stable_partition(std::span(order).subspan(first, count),
                            [&](std::uint32_t item) { return bin(centre(item, best.axis)) < best.bin; });
  }

  /// Moves the items that go left to the front and returns their number. Both groups keep their order. std::stable_partition
  /// would do the same, but allocates at every call.
  template <class GoesLeft>
  std::uint32_t stable_partition(std::span<std::uint32_t> items, GoesLeft&& goes_left) {
    spare.clear();
    std::uint32_t left = 0;
    for (const std::uint32_t item : items) {
      if (goes_left(item)) {
        items[left++] = item;
      } else {
        spare.push_back(item);
      }
    }
    std::ranges::copy(spare, items.begin() + left);
    return left;
  }
};

}  // namespace

BoxTree BoxTree::build(std::span<const Aabb> boxes, std::uint32_t leaf_size, const Checkpoint& checkpoint) {
  BoxTree tree;
  tree.order.resize(boxes.size());
  std::iota(tree.order.begin(), tree.order.end(), 0U);
  std::vector<std::uint32_t> spare;
  spare.reserve(boxes.size());
  Builder builder{boxes, tree.order, tree.nodes, spare, leaf_size, checkpoint};
  builder.build(0, static_cast<std::uint32_t>(boxes.size()), kMostLevels);
  return tree;
}

}  // namespace occlude::culler
