// SPDX-License-Identifier: MIT
// The cells of a hierarchy: a cut of it, in which planes between the boxes of nodes divide space.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <queue>
#include <span>
#include <vector>

#include "frusta/partition_cells.h"

namespace occlude::culler {
namespace {

using kernel::Aabb;

/// A plane between the children of a node, and which of them is on its lower side.
struct Between {
  double plane = 0;
  int axis = 0;
  std::uint32_t lower = 0, upper = 0;
};

/// None if the node is a point.
std::optional<Between> plane_between_children(std::span<const HierarchyNode> nodes, std::uint32_t node) {
  const Aabb& box = nodes[node].box;
  const std::uint32_t left = node + 1, right = nodes[node].right;
  std::optional<Between> best;
  double least = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    if (!(box.min[axis] < box.max[axis])) continue;
    const auto middle = [&](std::uint32_t child) { return nodes[child].box.min[axis] / 2 + nodes[child].box.max[axis] / 2; };
    const double from = std::max(nodes[left].box.min[axis], nodes[right].box.min[axis]);
    const double to = std::min(nodes[left].box.max[axis], nodes[right].box.max[axis]);
    const double overlap = (to - from) / (box.max[axis] - box.min[axis]);
    if (!(overlap < least)) continue;
    least = overlap;
    const bool is_left_lower = middle(left) <= middle(right);
    best = {from / 2 + to / 2, axis, is_left_lower ? left : right, is_left_lower ? right : left};
  }
  return best;
}

/// The cut of a hierarchy.
class Cut {
 public:
  /// A cell, the node whose cell it is, and how it is divided.
  struct Part {
    Aabb box;
    std::uint32_t node = 0;
    std::optional<Divided<std::size_t>> divided = {};  ///< numbers of parts
  };

  Cut(const Space& space, double regions, const Checkpoint& checkpoint) : nodes_(space.nodes) {
    if (nodes_.empty()) {
      parts_.push_back({space.box});
      return;
    }
    add(space.box, 0);
    for (std::size_t count = 1; static_cast<double>(count) < regions && !untried_.empty();) {
      checkpoint.at(parts_.size());
      const std::size_t part = untried_.top().part;
      untried_.pop();
      if (divide(part)) ++count;
    }
  }

  [[nodiscard]] const Part& operator[](std::size_t part) const { return parts_[part]; }

 private:
  struct Untried {
    double volume;
    std::size_t part;

    /// The largest is tried first; of equals, as all cells of a flat model are, the one that was made first.
    bool operator<(const Untried& other) const { return volume != other.volume ? volume < other.volume : part > other.part; }
  };

  void add(const Aabb& box, std::uint32_t node) {
    double volume = 1;
    for (int axis = 0; axis < 3; ++axis) volume *= box.max[axis] - box.min[axis];
    untried_.push({volume, parts_.size()});
    parts_.push_back({box, node});
  }

  /// By the first node, from that of the part downwards, whose plane does not miss the cell. Whether there is one.
  bool divide(std::size_t part) {
    Aabb below = parts_[part].box, above = below;
    std::uint32_t node = parts_[part].node;
    while (!nodes_[node].is_leaf()) {
      const std::optional<Between> between = plane_between_children(nodes_, node);
      if (!between) return false;
      const auto [plane, axis, lower, upper] = *between;
      if (plane <= below.min[axis]) {
        node = upper;
      } else if (plane >= below.max[axis]) {
        node = lower;
      } else {
        const std::size_t first = parts_.size();
        parts_[part].divided = Divided<std::size_t>{plane, static_cast<std::uint32_t>(axis), first, first + 1};
        below.max[axis] = above.min[axis] = plane;
        add(below, lower);
        add(above, upper);
        return true;
      }
    }
    return false;
  }

  std::span<const HierarchyNode> nodes_;
  std::vector<Part> parts_;
  std::priority_queue<Untried> untried_;
};

}  // namespace

PartitionCells cells_of_tree(const Space& space, double regions, const Checkpoint& checkpoint) {
  const Cut cut(space, regions, checkpoint);
  PartitionCells result{space.box};
  result.append(std::size_t{0}, [&](std::size_t part) { return cut[part].divided; });
  return result;
}

}  // namespace occlude::culler
