// SPDX-License-Identifier: MIT
// What rays meet in the polygons of a tree, in doubles: quickly, and up to rounding.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <limits>
#include <utility>

#include "occlude/culler/hierarchy.h"

namespace occlude::render {

/// A ray is from + share * along, its share 0 or more. Polygons are those of the tree, and opaque. Const calls may run on
/// several threads at once.
class TreeRays {
 public:
  /// REQUIRES: the tree outlives this object.
  explicit TreeRays(const culler::Hierarchy& tree);

  /// Calls visit(polygon) for all whose leaf the ray meets at a share not above `end`, or passes by less than rounding: for
  /// those of the nearer of two boxes first. visit() may lower `end`; below 0, no more are visited.
  template <class Visit>
  void visit(const glm::dvec3& from, const glm::dvec3& along, const double& end, const Visit& visit) const;

  /// Whether it holds for one of those that visit() would call: until it does for one.
  template <class Predicate>
  [[nodiscard]] bool any_of(const glm::dvec3& from, const glm::dvec3& along, double end, const Predicate& predicate) const {
    const double whole = end;
    visit(from, along, end, [&](std::uint32_t polygon) {
      if (end == whole && predicate(polygon)) end = -1;
    });
    return end < 0 && whole >= 0;
  }

  /// The least share, not below `first`, at which the ray meets a polygon of any kind; NaN if there is none.
  [[nodiscard]] double meeting(const glm::dvec3& from, const glm::dvec3& along, double first, std::uint32_t polygon) const;

 private:
  class Boxes;

  const culler::Hierarchy& tree_;
  double extent_;  ///< the largest coordinate
};

/// Where a ray enters boxes.
class TreeRays::Boxes {
 public:
  static constexpr double kMissed = std::numeric_limits<double>::infinity();

  Boxes(const glm::dvec3& from, const glm::dvec3& along, double extent) : from_(from), along_(along) {
    // A coordinate of a point of the ray rounds by a few times 2^-53 of the numbers that it is computed of.
    constexpr double kRounding = 0x1p-44;
    for (int i = 0; i < 3; ++i) {
      room_ = std::max({room_, kRounding * extent, kRounding * std::abs(from[i]), kRounding * std::abs(along[i])});
      inverse_[i] = 1 / along[i];
    }
  }

  /// The share at which the ray enters the box, which is larger by `room_`.
  [[nodiscard]] double entry(const kernel::Aabb& box) const {
    double first = 0, last = kMissed;
    for (int i = 0; i < 3; ++i) {
      const double low = box.min[i] - room_ - from_[i], high = box.max[i] + room_ - from_[i];
      if (along_[i] == 0) {
        if (low > 0 || high < 0) return kMissed;
        continue;
      }
      const double a = low * inverse_[i], b = high * inverse_[i];
      first = std::max(first, std::min(a, b));
      last = std::min(last, std::max(a, b));
    }
    return first <= last ? first : kMissed;
  }

 private:
  const glm::dvec3 &from_, &along_;
  glm::dvec3 inverse_{0};
  double room_ = 0;
};

template <class Visit>
void TreeRays::visit(const glm::dvec3& from, const glm::dvec3& along, const double& end, const Visit& visit) const {
  struct Waiting {
    std::uint32_t node;
    double entry;
  };
  const Boxes boxes(from, along, extent_);
  const auto nodes = tree_.nodes();
  const auto of = [&](std::uint32_t node) { return Waiting{node, boxes.entry(nodes[node].box)}; };
  std::array<Waiting, culler::kMostLevels + 1> waiting;
  std::size_t count = 0;
  waiting[count++] = of(0);
  while (count > 0) {
    const auto [number, entry] = waiting[--count];
    if (!(entry <= end) || entry == Boxes::kMissed) continue;
    const culler::HierarchyNode& node = nodes[number];
    if (!node.is_leaf()) {
      Waiting near = of(number + 1), far = of(node.right);
      if (far.entry < near.entry) std::swap(near, far);
      waiting[count++] = far;
      waiting[count++] = near;
      continue;
    }
    for (std::uint32_t p = node.first; p < node.first + node.count; ++p) {
      if (tree_.soup().is_opaque(p)) visit(p);
    }
  }
}

}  // namespace occlude::render
