// SPDX-License-Identifier: MIT
#include "occlude/culler/convex_shells.h"

#include <algorithm>
#include <utility>

#include "adjacency.h"
#include "bounds.h"
#include "disjoint_sets.h"

namespace occlude::culler {
namespace {

/// Every face turned to the eye is a plane of the shadow and costs time at every test. The check that a solid is convex
/// takes time in proportion to faces times vertices and to sides times vertices.
constexpr std::size_t kMostFaces = 64;
/// A prism with that many faces has almost six times as many sides. This is twice that.
constexpr std::size_t kMostSides = 768;
/// The faces of a tetrahedron.
constexpr std::size_t kLeastFaces = 4;

/// Groups of polygons that are connected edge to edge.
class Parts {
 public:
  Parts(const PolygonSoup& soup, std::span<const SidePair> adjacency, const Checkpoint& checkpoint)
      : sets_(soup.size()), paired_(soup.size()) {
    const std::vector<std::uint32_t> polygon_of = polygon_of_sides(soup);
    for (std::size_t i = 0; i < adjacency.size(); ++i) {
      checkpoint.at(i);
      const std::uint32_t p = polygon_of[adjacency[i].side], q = polygon_of[adjacency[i].twin];
      ++paired_[p];
      ++paired_[q];
      sets_.join(sets_.find(p), sets_.find(q));
    }
  }

  /// Calls visit(polygons) for every group.
  template <class Visit>
  void for_each(Visit&& visit) {
    sets_.for_each_set(visit);
  }

  /// How many sides of the polygon run along a side of another in the opposite direction.
  [[nodiscard]] std::size_t paired(std::uint32_t polygon) const { return paired_[polygon]; }

 private:
  DisjointSets sets_;
  std::vector<std::uint32_t> paired_;  ///< of each polygon
};

}  // namespace

kernel::Polytope polytope_of(const PolygonSoup& soup, std::span<const std::uint32_t> polygons) {
  kernel::Polytope solid;
  std::vector<std::uint32_t> vertices;  // of the soup
  for (const std::uint32_t p : polygons) {
    std::vector<std::uint32_t>& face = solid.faces.emplace_back();
    for (const std::uint32_t index : soup.loop(p)) {
      const auto found = std::ranges::find(vertices, index);
      face.push_back(static_cast<std::uint32_t>(found - vertices.begin()));
      if (found != vertices.end()) continue;
      vertices.push_back(index);
      solid.vertices.push_back(to_kernel(soup.vertices[index]));
    }
  }
  return solid;
}

ConvexShells ConvexShells::find(const PolygonSoup& soup, std::span<const SidePair> adjacency, const Checkpoint& checkpoint) {
  ConvexShells result;
  Parts parts(soup, adjacency, checkpoint);
  parts.for_each([&](std::span<const std::uint32_t> polygons) {
    if (polygons.size() < kLeastFaces || polygons.size() > kMostFaces) return;
    checkpoint();
    std::size_t sides = 0;
    for (const std::uint32_t p : polygons) sides += soup.loop(p).size();
    if (sides > kMostSides) return;
    const auto is_closed = [&](std::uint32_t p) { return parts.paired(p) == soup.loop(p).size(); };
    if (!std::ranges::all_of(polygons, is_closed)) return;
    auto [polytope, refusal] = kernel::ConvexPolytope::make(polytope_of(soup, polygons));
    if (!polytope) return;
    if (result.shell_of_.empty()) result.shell_of_.assign(soup.size(), kNone);
    for (const std::uint32_t p : polygons) result.shell_of_[p] = static_cast<std::uint32_t>(result.shells_.size());
    result.most_faces_ = std::max(result.most_faces_, polytope->faces().size());
    result.most_edges_ = std::max(result.most_edges_, polytope->edges().size());
    result.shells_.push_back({{polygons.begin(), polygons.end()}, std::move(*polytope)});
  });
  return result;
}

}  // namespace occlude::culler
