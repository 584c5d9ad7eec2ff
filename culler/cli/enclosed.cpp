// SPDX-License-Identifier: MIT
#include "enclosed.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <span>

#include "base/parallel.h"
#include "frusta/closed_parts.h"
#include "frusta/solid.h"
#include "model/adjacency.h"
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

class Enclosures {
 public:
  Enclosures(const culler::Hierarchy& tree, const culler::Checkpoint& checkpoint)
      : tree_(tree), part_(tree.soup().size(), kNone) {
    const culler::SoupView& soup = tree.soup();
    const std::vector<std::uint32_t> weld = culler::welded(soup.vertices, checkpoint);
    std::uint32_t number = 0;
    for (const Polygons& part : culler::find_parts(soup, weld, checkpoint)) {
      if (!is_closed(soup, weld, part)) continue;
      for (const std::uint32_t p : part) part_[p] = number;
      ++number;
    }
  }

  /// Whether a closed part has all of the polygon inside, and nothing in common with it.
  [[nodiscard]] bool have(std::uint32_t p) const {
    const culler::Solid polygon(tree_.soup(), std::span(&p, 1));
    const kernel::Vec3& corner = polygon.triangles[0].corners[0];
    std::map<std::uint32_t, Polygons> crossed;  // by the ray along x on which is_inside() decides, of each part
    const kernel::Aabb ray{corner, {tree_.nodes()[0].box.max.x, corner.y, corner.z}};
    for_each_of_parts(ray, [&](std::uint32_t other) {
      if (part_[other] != part_[p]) crossed[part_[other]].push_back(other);
    });
    std::erase_if(crossed, [&](const auto& part) { return !is_inside(culler::Solid(tree_.soup(), part.second), corner); });
    if (crossed.empty()) return false;
    for_each_of_parts(polygon.box, [&](std::uint32_t other) {
      const auto part = crossed.find(part_[other]);
      if (part != crossed.end() && !are_apart(polygon, other)) crossed.erase(part);
    });
    return !crossed.empty();
  }

 private:
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  /// Calls take(p) for the polygons of closed parts whose leaf meets the box.
  template <class Take>
  void for_each_of_parts(const kernel::Aabb& box, const Take& take) const {
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
        if (part_[p] != kNone) take(p);
      }
    }
  }

  [[nodiscard]] bool are_apart(const culler::Solid& polygon, std::uint32_t other) const {
    const culler::Solid of_part(tree_.soup(), std::span(&other, 1));
    return std::ranges::all_of(polygon.triangles, [&](const culler::SolidTriangle& a) {
      return std::ranges::all_of(of_part.triangles, [&](const culler::SolidTriangle& b) { return culler::are_apart(a, b); });
    });
  }

  const culler::Hierarchy& tree_;
  Polygons part_;  ///< of each polygon, the number of its part, if that is closed
};

}  // namespace

std::vector<bool> enclosed_polygons(const culler::Hierarchy& tree, const culler::Checkpoint& checkpoint) {
  const Enclosures enclosures(tree, checkpoint);
  constexpr std::size_t kBlock = 1024;
  const std::size_t count = tree.soup().size();
  std::vector<std::uint8_t> is_enclosed(count);
  const auto find = [&](std::size_t block) {
    for (std::size_t p = block * kBlock; p < std::min(count, (block + 1) * kBlock); ++p) {
      is_enclosed[p] = enclosures.have(static_cast<std::uint32_t>(p)) ? 1 : 0;
    }
  };
  culler::parallel_for((count + kBlock - 1) / kBlock, find, checkpoint);
  return {is_enclosed.begin(), is_enclosed.end()};
}

}  // namespace occlude::cli
