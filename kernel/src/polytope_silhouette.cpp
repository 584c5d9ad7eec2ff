// SPDX-License-Identifier: MIT
#include "polytope_silhouette.h"

#include <algorithm>
#include <cstddef>

#include "plane_coefficients.h"

namespace occlude::kernel {
namespace {

bool is_turned(const Viewpoint& viewpoint, const ExactPlane& inner) {
  if (viewpoint.is_eye()) return sign_at(inner, viewpoint.value) < 0;
  return certified([&]<class A>(A& arithmetic) {
           return arithmetic.sign(dot(normal<A>(inner), constants<A>(viewpoint.value)));
         }) > 0;
}

/// An edge of the silhouette in the direction of the loop, which leaves the turned face on its right seen from outside.
struct LoopEdge {
  std::uint32_t from, to, face;
};

std::vector<LoopEdge> loop_edges(const ConvexPolytope& polytope, const std::vector<bool>& turned) {
  std::vector<LoopEdge> edges;
  for (const auto& [from, to, left, right] : polytope.edges()) {
    if (turned[left] == turned[right]) continue;
    edges.push_back(turned[left] ? LoopEdge{to, from, left} : LoopEdge{from, to, right});
  }
  return edges;
}

}  // namespace

ExactPlane inner_plane(const ConvexPolytope& polytope, std::uint32_t face) {
  const auto [a, b, c] = polytope.faces()[face].corners;
  const auto v = polytope.vertices();
  return {.direct = false, .a_to = v[c], .a_from = v[a], .b_to = v[b], .b_from = v[a], .origin = v[a]};
}

PolytopeSilhouette silhouette(const Viewpoint& viewpoint, const ConvexPolytope& polytope) {
  PolytopeSilhouette seen;
  std::vector<bool> turned(polytope.faces().size());
  for (std::uint32_t face = 0; face < turned.size(); ++face) {
    turned[face] = is_turned(viewpoint, inner_plane(polytope, face));
    if (turned[face]) seen.turned_faces.push_back(face);
  }
  std::vector<LoopEdge> edges = loop_edges(polytope, turned);
  std::sort(edges.begin(), edges.end(), [](const LoopEdge& a, const LoopEdge& b) { return a.from < b.from; });
  const auto edge_from = [&](std::uint32_t vertex) {
    return std::partition_point(edges.begin(), edges.end(), [&](const LoopEdge& e) { return e.from < vertex; });
  };
  for (auto edge = edges.begin(); seen.loop.size() < edges.size(); edge = edge_from(edge->to)) {
    seen.loop.push_back({edge->from, edge->face});
  }
  return seen;
}

std::vector<Vec3> loop_of(const ConvexPolytope& polytope, const PolytopeSilhouette& seen) {
  std::vector<Vec3> loop;
  for (const auto& step : seen.loop) loop.push_back(polytope.vertices()[step.vertex]);
  return loop;
}

std::vector<ShadowFrustum::CapEdge> cap_edges(const ConvexPolytope& polytope, const PolytopeSilhouette& seen,
                                              std::span<const Vec3> corners) {
  const auto v = polytope.vertices();
  const auto near = [&](std::uint32_t face) {  // the number of its plane, or one too many
    return static_cast<std::uint32_t>(std::lower_bound(seen.turned_faces.begin(), seen.turned_faces.end(), face) -
                                      seen.turned_faces.begin());
  };
  const auto is_near = [&](std::uint32_t face) {
    return std::binary_search(seen.turned_faces.begin(), seen.turned_faces.end(), face);
  };
  std::vector<ShadowFrustum::CapEdge> edges;
  for (const auto& [from, to, left, right] : polytope.edges()) {
    if (is_near(left) && is_near(right)) edges.push_back({v[from], v[to], near(left), near(right)});
  }
  // Corners are the vertices of the loop at which it turns: a side may have several edges of the loop.
  const auto first = static_cast<std::uint32_t>(seen.turned_faces.size());
  const auto count = static_cast<std::uint32_t>(corners.size());
  const std::size_t n = seen.loop.size();
  std::size_t start = 0;
  while (v[seen.loop[start].vertex] != corners[0]) ++start;
  std::uint32_t side = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const auto& [vertex, face] = seen.loop[(start + i) % n];
    const Vec3& next = v[seen.loop[(start + i + 1) % n].vertex];
    edges.push_back({v[vertex], next, first + side, near(face)});
    if (next == corners[(side + 1) % count]) side = (side + 1) % count;
  }
  return edges;
}

}  // namespace occlude::kernel
