// SPDX-License-Identifier: MIT
#include "frusta/convex_shells.h"

#include <algorithm>
#include <utility>

#include "base/disjoint_sets.h"
#include "frusta/shell_limits.h"
#include "frusta/shell_polytopes.h"
#include "model/adjacency.h"
#include "model/bounds.h"

namespace occlude::culler {
namespace {

/// Groups of polygons that are connected edge to edge.
class ConnectedParts {
 public:
  ConnectedParts(SoupView soup, std::span<const SidePair> adjacency, const Checkpoint& checkpoint)
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

kernel::Polytope polytope_of(SoupView soup, std::span<const std::uint32_t> polygons) {
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

ConvexShells ConvexShells::find(SoupView soup, std::span<const SidePair> adjacency, const Checkpoint& checkpoint) {
  ConvexShells result;
  std::vector<std::uint32_t> of_shells, first_part{0}, shell_of;
  std::vector<kernel::ConvexPolytope> polytopes;
  ConnectedParts parts(soup, adjacency, checkpoint);
  parts.for_each([&](std::span<const std::uint32_t> polygons) {
    if (polygons.size() < kLeastFaces || polygons.size() > kMostFaces) return;
    checkpoint();
    if (sides_of(soup, polygons) > kMostSides) return;
    const auto is_closed = [&](std::uint32_t p) { return parts.paired(p) == soup.loop(p).size(); };
    if (!std::ranges::all_of(polygons, is_closed)) return;
    auto [polytope, refusal] = kernel::ConvexPolytope::make(polytope_of(soup, polygons));
    if (!polytope) return;
    if (shell_of.empty()) shell_of.assign(soup.size(), kNone);
    for (const std::uint32_t p : polygons) shell_of[p] = static_cast<std::uint32_t>(polytopes.size());
    result.most_.faces = std::max(result.most_.faces, static_cast<std::uint32_t>(polytope->faces().size()));
    result.most_.edges = std::max(result.most_.edges, static_cast<std::uint32_t>(polytope->edges().size()));
    of_shells.insert(of_shells.end(), polygons.begin(), polygons.end());
    first_part.push_back(static_cast<std::uint32_t>(of_shells.size()));
    polytopes.push_back(std::move(*polytope));
  });
  result.parts_ = std::move(of_shells);
  result.first_part_ = std::move(first_part);
  result.shell_of_ = std::move(shell_of);
  result.polytopes_ = std::make_shared<ShellPolytopes>(std::move(polytopes));
  return result;
}

const kernel::ConvexPolytope& ConvexShells::polytope(std::size_t s) const {
  return polytopes_->get(s, [&] {
    return kernel::ConvexPolytope::make(polytope_of(soup_.view, parts(s))).polytope.value_or(kernel::ConvexPolytope());
  });
}

}  // namespace occlude::culler
