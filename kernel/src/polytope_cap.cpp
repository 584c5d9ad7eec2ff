// SPDX-License-Identifier: MIT
#include "polytope_cap.h"

#include <algorithm>
#include <cstddef>

namespace occlude::kernel {

std::pmr::vector<Vec3> loop_of(const ConvexPolytope& polytope, const PolytopeSilhouette& seen,
                               std::pmr::memory_resource& memory) {
  std::pmr::vector<Vec3> loop(&memory);
  for (const auto& step : seen.loop()) loop.push_back(polytope.vertices()[step.vertex]);
  return loop;
}

ExactPlane inner_plane(const ConvexPolytope& polytope, std::uint32_t face) {
  const auto [a, b, c] = polytope.faces()[face].corners;
  const auto v = polytope.vertices();
  return {.direct = false, .a_to = v[c], .a_from = v[a], .b_to = v[b], .b_from = v[a], .origin = v[a]};
}

void append_cap_edges(const ConvexPolytope& polytope, const PolytopeSilhouette& seen, std::span<const Vec3> corners,
                      std::vector<CapEdge>& edges) {
  const auto v = polytope.vertices();
  const auto turned = seen.turned_faces();
  const auto loop = seen.loop();
  const auto near = [&](std::uint32_t face) {  // the number of its plane; meaningless for a face that is not turned
    return static_cast<std::uint32_t>(std::lower_bound(turned.begin(), turned.end(), face) - turned.begin());
  };
  const auto is_near = [&](std::uint32_t face) { return std::binary_search(turned.begin(), turned.end(), face); };
  for (const auto& [from, to, left, right] : polytope.edges()) {
    if (is_near(left) && is_near(right)) edges.push_back({v[from], v[to], near(left), near(right)});
  }
  // Corners are the vertices at which the loop turns, so one side may have several edges of the loop.
  const auto first = static_cast<std::uint32_t>(turned.size());
  const auto count = static_cast<std::uint32_t>(corners.size());
  const std::size_t n = loop.size();
  std::size_t start = 0;
  while (v[loop[start].vertex] != corners[0]) ++start;
  std::uint32_t side = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const auto& [vertex, face] = loop[(start + i) % n];
    const Vec3& next = v[loop[(start + i + 1) % n].vertex];
    edges.push_back({v[vertex], next, first + side, near(face)});
    if (next == corners[(side + 1) % count]) side = (side + 1) % count;
  }
}

}  // namespace occlude::kernel
