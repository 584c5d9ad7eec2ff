// SPDX-License-Identifier: MIT
#include "enclosed.h"

#include <algorithm>
#include <cstdint>
#include <span>

#include "base/parallel.h"
#include "frusta/closed_parts.h"
#include "frusta/solid.h"
#include "model/adjacency.h"
#include "simplify/triangles_apart.h"

namespace occlude::cli {
namespace {

using Part = std::vector<std::uint32_t>;

bool is_within(const kernel::Aabb& inner, const kernel::Aabb& outer) {
  for (int i = 0; i < 3; ++i) {
    if (inner.min[i] <= outer.min[i] || inner.max[i] >= outer.max[i]) return false;
  }
  return true;
}

bool meet(const kernel::Aabb& a, const kernel::Aabb& b) {
  for (int i = 0; i < 3; ++i) {
    if (a.max[i] < b.min[i] || b.max[i] < a.min[i]) return false;
  }
  return true;
}

/// The surface of the part divides no polygon that it has no point in common with.
bool is_enclosed(const culler::Solid& solid, const culler::SoupView& soup, std::uint32_t p) {
  const culler::Solid polygon(soup, std::span(&p, 1));
  for (const culler::SolidTriangle& triangle : polygon.triangles) {
    const auto is_apart = [&](const culler::SolidTriangle& of) { return are_apart(of, triangle); };
    if (!std::ranges::all_of(solid.triangles, is_apart)) return false;
  }
  return is_inside(solid, polygon.triangles[0].corners[0]);
}

/// The polygons whose boxes are within the solid's.
Part polygons_within(const culler::Hierarchy& tree, const kernel::Aabb& box) {
  Part within;
  const auto nodes = tree.nodes();
  for (std::uint32_t n = 0; n < nodes.size();) {
    const culler::HierarchyNode& node = nodes[n];
    if (!meet(node.box, box)) {  // over the subtree: its nodes follow each other
      const std::uint32_t end = node.first + node.count;
      while (n < nodes.size() && nodes[n].first < end) ++n;
      continue;
    }
    if (node.is_leaf()) {
      for (std::uint32_t p = node.first; p < node.first + node.count; ++p) {
        if (is_within(tree.soup().box(p), box)) within.push_back(p);
      }
    }
    ++n;
  }
  return within;
}

}  // namespace

std::vector<bool> enclosed_polygons(const culler::Hierarchy& tree, const culler::Checkpoint& checkpoint) {
  const culler::SoupView& soup = tree.soup();
  const std::vector<std::uint32_t> weld = culler::welded(soup.vertices, checkpoint);
  std::vector<Part> parts = culler::find_parts(soup, weld, checkpoint);
  std::erase_if(parts, [&](const Part& part) { return !is_closed(soup, weld, part); });
  std::vector<Part> found(parts.size());
  const auto find = [&](std::size_t i) {
    const culler::Solid solid(soup, parts[i]);
    for (const std::uint32_t p : polygons_within(tree, solid.box)) {
      if (is_enclosed(solid, soup, p)) found[i].push_back(p);
    }
  };
  culler::parallel_for(parts.size(), find, checkpoint);
  std::vector<bool> is_inside(soup.size());
  for (const Part& polygons : found) {
    for (const std::uint32_t p : polygons) is_inside[p] = true;
  }
  return is_inside;
}

}  // namespace occlude::cli
