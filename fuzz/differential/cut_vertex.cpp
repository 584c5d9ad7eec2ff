// SPDX-License-Identifier: MIT
#include "cut_vertex.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

namespace occlude::fuzz {
namespace {

using Loop = std::vector<std::uint32_t>;

/// The neighbours of the vertex in the order of the faces around it. Empty unless these faces close.
Loop ring_about(const std::vector<Loop>& faces, std::uint32_t vertex) {
  std::map<std::uint32_t, Loop> next;
  for (const Loop& face : faces) {
    for (std::size_t i = 0; i < face.size(); ++i) {
      if (face[i] != vertex) continue;
      const std::uint32_t before = face[(i + face.size() - 1) % face.size()], after = face[(i + 1) % face.size()];
      next[before].push_back(after);
      next[after].push_back(before);
    }
  }
  Loop ring;
  if (next.size() < 3 || !std::ranges::all_of(next, [](const auto& n) { return n.second.size() == 2; })) return ring;
  std::uint32_t at = next.begin()->first, from = next[at][0];
  do {
    ring.push_back(at);
    const Loop& ways = next[at];
    from = std::exchange(at, ways[0] == from ? ways[1] : ways[0]);
  } while (at != ring[0] && ring.size() <= next.size());
  return ring.size() == next.size() ? ring : Loop();
}

/// The polytope without the vertex, with a hole.
kernel::Polytope without(const kernel::Polytope& polytope, std::uint32_t vertex) {
  kernel::Polytope left{polytope.vertices, {}};
  for (Loop face : polytope.faces) {
    std::erase(face, vertex);
    if (face.size() >= 3) left.faces.push_back(std::move(face));
  }
  return left;
}

void renumber(kernel::Polytope& polytope, std::uint32_t vertex) {
  polytope.vertices.erase(polytope.vertices.begin() + vertex);
  for (Loop& face : polytope.faces) {
    for (std::uint32_t& i : face) i -= i > vertex ? 1 : 0;
  }
}

}  // namespace

std::vector<kernel::Polytope> cut_vertex(const kernel::Polytope& polytope, std::uint32_t vertex) {
  const Loop ring = ring_about(polytope.faces, vertex);
  if (ring.empty()) return {};
  const kernel::Polytope open = without(polytope, vertex);
  std::vector<kernel::Polytope> choices{open};
  choices[0].faces.push_back(ring);
  for (std::size_t corner = 0; ring.size() > 3 && corner < ring.size(); ++corner) {
    kernel::Polytope& fan = choices.emplace_back(open);
    const auto at = [&](std::size_t i) { return ring[(corner + i) % ring.size()]; };
    for (std::size_t i = 1; i + 1 < ring.size(); ++i) fan.faces.push_back({at(0), at(i), at(i + 1)});
  }
  for (kernel::Polytope& choice : choices) renumber(choice, vertex);
  return choices;
}

}  // namespace occlude::fuzz
