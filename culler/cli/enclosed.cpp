// SPDX-License-Identifier: MIT
// A triangle that no polygon of a shell meets but along the triangle's borders, and that has a point inside of the shell,
// lies inside without these borders. Why nothing is seen of it but points of what stays: let U be what is inside of shells
// or on their borders. A ray from outside ends at the border of U at the latest. Around each point of that border there are
// points in U and others, and no lines keep them apart, but pieces of polygons. So the point is on a polygon of which a
// piece is on the border of U. None of the triangles to which that piece belongs is inside of a shell: the polygon stays.
#include "enclosed.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "closed_shells.h"
#include "frusta/solid.h"
#include "model/bounds.h"
#include "occlude/kernel/orientation.h"
#include "occlude/kernel/validity.h"
#include "simplify/triangles_apart.h"

namespace occlude::cli {
namespace {

using Polygons = std::vector<std::uint32_t>;

bool meet(const kernel::Aabb& a, const kernel::Aabb& b) {
  for (int i = 0; i < 3; ++i) {
    if (a.max[i] < b.min[i] || b.max[i] < a.min[i]) return false;
  }
  return true;
}

using Corners = std::array<kernel::Vec3, 3>;

/// A point of the box of a triangle that is in the triangle up to rounding.
kernel::Vec3 point_in(const culler::SolidTriangle& triangle) {
  const auto& [a, b, c] = triangle.corners;
  kernel::Vec3 point;
  for (int i = 0; i < 3; ++i) {
    point[i] =
        std::clamp(kernel::flushed(a[i] + ((b[i] - a[i]) + (c[i] - a[i])) / 3), triangle.box.min[i], triangle.box.max[i]);
  }
  return point;
}

/// Whether a plane, or a line in a projection, has triangle `a` and a point on one side and triangle `b` on the other, and
/// not all of `a` in it. side() gives the sign of a corner.
template <class Side>
bool is_between(const Corners& a, const kernel::Vec3& point, const Corners& b, const Side& side) {
  std::array<int, 3> of_a{}, of_b{};
  std::ranges::transform(a, of_a.begin(), side);
  std::ranges::transform(b, of_b.begin(), side);
  const auto [low_a, high_a] = std::ranges::minmax(of_a);
  const auto [low_b, high_b] = std::ranges::minmax(of_b);
  const int of_point = side(point);
  return (low_a >= 0 && high_a > 0 && of_point >= 0 && high_b <= 0) ||
         (high_a <= 0 && low_a < 0 && of_point <= 0 && low_b >= 0);
}

/// Whether triangle `a` without its borders, and what is inside of the tetrahedron of it and the point, have no point in
/// common with `b`. It may be false though they have none.
bool do_not_cross(const Corners& a, const kernel::Vec3& point, const Corners& b) {
  const auto plane = [&](const kernel::Vec3& u, const kernel::Vec3& v, const kernel::Vec3& w) {
    return is_between(a, point, b, [&](const kernel::Vec3& p) { return kernel::orientation(u, v, w, p); });
  };
  if (plane(b[0], b[1], b[2])) return true;
  const auto along_edges_of = [&](const Corners& edges, const Corners& others) {
    for (std::size_t i = 0; i < 3; ++i) {
      const kernel::Vec3 &from = edges[i], &to = edges[(i + 1) % 3];
      if (std::ranges::any_of(others, [&](const kernel::Vec3& third) { return plane(from, to, third); })) return true;
      for (int axis = 0; axis < 3; ++axis) {  // for triangles in one plane
        if (is_between(a, point, b, [&](const kernel::Vec3& p) { return kernel::turn(axis, from, to, p); })) return true;
      }
    }
    return false;
  };
  return along_edges_of(a, b) || along_edges_of(b, a);
}

class Enclosures {
 public:
  Enclosures(const culler::Hierarchy& tree, bool may_touch, const culler::Checkpoint& checkpoint)
      : tree_(tree), may_touch_(may_touch), shell_(tree.soup().size(), kNone) {
    shells_ = closed_shells(tree.soup(), checkpoint);
    for (std::uint32_t number = 0; number < shells_.size(); ++number) {
      for (const std::uint32_t p : shells_[number]) shell_[p] = number;
    }
  }

  /// Of each triangle of the polygon the shell that has it inside; nothing unless all of them are inside of one.
  [[nodiscard]] Polygons around(std::uint32_t p) const {
    const culler::Solid polygon(tree_.soup(), std::span(&p, 1));
    Polygons shells;
    for (const culler::SolidTriangle& triangle : polygon.triangles) {
      shells.push_back(around(triangle));
      if (shells.back() == kNone) return {};
    }
    return shells;
  }

  [[nodiscard]] std::vector<Polygons> take_shells() { return std::move(shells_); }

 private:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  [[nodiscard]] std::uint32_t around(const culler::SolidTriangle& triangle) const {
    const kernel::Vec3 point = point_in(triangle);
    std::map<std::uint32_t, Polygons> crossed;  // of each shell, by the ray along x on which is_inside() decides
    const kernel::Aabb ray{point, {tree_.nodes()[0].box.max.x, point.y, point.z}};
    for_each_of_shells(ray, [&](std::uint32_t other) { crossed[shell_[other]].push_back(other); });
    const auto found = std::ranges::find_if(crossed, [&](const auto& shell) {
      return is_inside(culler::Solid(tree_.soup(), shell.second), point) && leaves_room_for(shell.first, triangle, point);
    });
    return found == crossed.end() ? kNone : found->first;
  }

  /// Whether the shell meets neither the triangle nor the way from there to the point. The triangle's borders count unless
  /// they may touch it.
  [[nodiscard]] bool leaves_room_for(std::uint32_t shell, const culler::SolidTriangle& triangle,
                                     const kernel::Vec3& point) const {
    const culler::SolidTriangle end{{point, point, point}, {point, point}};
    bool is_free = true;
    for_each_of_shells(triangle.box, [&](std::uint32_t other) {
      if (!is_free || shell_[other] != shell) return;
      const culler::Solid polygon(tree_.soup(), std::span(&other, 1));
      is_free = std::ranges::all_of(polygon.triangles, [&](const culler::SolidTriangle& b) {
        return culler::are_apart(end, b) && do_not_cross(triangle.corners, point, b.corners) &&
               (may_touch_ || culler::are_apart(triangle, b));
      });
    });
    return is_free;
  }

  /// Calls take(p) for the polygons of closed shells whose leaf meets the box.
  template <class Take>
  void for_each_of_shells(const kernel::Aabb& box, const Take& take) const {
    const std::span<const culler::HierarchyNode> nodes = tree_.nodes();
    Polygons waiting{0};
    while (!waiting.empty()) {
      const culler::HierarchyNode& node = nodes[waiting.back()];
      const std::uint32_t left = waiting.back() + 1;
      waiting.pop_back();
      if (!meet(node.box, box)) continue;
      if (!node.is_leaf()) {
        waiting.push_back(node.right);
        waiting.push_back(left);
        continue;
      }
      for (std::uint32_t p = node.first; p < node.first + node.count; ++p) {
        if (shell_[p] != kNone) take(p);
      }
    }
  }

  const culler::Hierarchy& tree_;
  bool may_touch_;
  std::vector<Polygons> shells_;
  Polygons shell_;  ///< of each polygon, the number of its shell, if it has one
};

}  // namespace

Enclosed enclosed_polygons(const culler::Hierarchy& tree, bool may_touch, const culler::Checkpoint& checkpoint) {
  Enclosures enclosures(tree, may_touch, checkpoint);
  constexpr std::size_t kBlock = 1024;
  const std::size_t count = tree.soup().size();
  std::vector<Polygons> around(count);
  const auto find = [&](std::size_t block) {
    for (std::size_t p = block * kBlock; p < std::min(count, (block + 1) * kBlock); ++p) {
      around[p] = enclosures.around(static_cast<std::uint32_t>(p));
    }
  };
  culler::parallel_for((count + kBlock - 1) / kBlock, find, checkpoint);
  Enclosed enclosed;
  for (std::uint32_t p = 0; p < count; ++p) {
    enclosed.polygons.push_back(!around[p].empty());
    for (std::uint32_t k = 0; k < around[p].size(); ++k) enclosed.triangles.push_back({{p, k + 1}, around[p][k]});
  }
  enclosed.shells = enclosures.take_shells();
  return enclosed;
}

}  // namespace occlude::cli
