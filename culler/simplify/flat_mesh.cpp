// SPDX-License-Identifier: MIT
#include "simplify/flat_mesh.h"

#include <algorithm>
#include <deque>
#include <glm/geometric.hpp>
#include <optional>
#include <utility>

#include "model/adjacency.h"
#include "model/bounds.h"
#include "occlude/kernel/orientation.h"

namespace occlude::culler {
namespace {

/// A vertex of a fine grid has six or eight triangles, and some more while its neighbours go. The time that a vertex takes
/// grows with the square of its triangles: one with many stays.
constexpr std::size_t kMostAround = 64;
/// As many sides of an edge are held against each other.
constexpr std::size_t kMostAlong = 16;

/// A side of a triangle, to be found with the others along its edge.
struct EdgeSide {
  std::uint32_t low, high, half_edge;

  [[nodiscard]] bool is_along(const EdgeSide& other) const { return low == other.low && high == other.high; }
  friend auto operator<=>(const EdgeSide&, const EdgeSide&) = default;
};

}  // namespace

/// Triangles around a vertex, each joined with the next, counter-clockwise as they turn.
struct FlatMesh::Fan {
  std::vector<HalfEdge> leaving;  ///< of each triangle, from the vertex
  std::vector<Vertex> loop;       ///< around the vertex; of a fan that is not closed, from its first neighbour to its last
  bool is_closed = false;
};

FlatMesh::FlatMesh(SoupView soup, std::span<const std::uint32_t> regions, const Checkpoint& checkpoint)
    : vertices_(soup.vertices), regions_(regions), at_(soup.vertices.size()), counts_(soup.vertices.size()) {
  const std::vector<std::uint32_t> weld = welded(soup.vertices, checkpoint);
  const std::vector<bool> is_repeated = find_repeated(soup, weld, checkpoint);
  for (std::uint32_t p = 0; p < soup.size(); ++p) {
    checkpoint.at(p);
    if (!soup.is_opaque(p) || is_repeated[p]) continue;
    const auto loop = soup.loop(p);
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      const Vertex a = weld[loop[0]], b = weld[loop[i]], c = weld[loop[i + 1]];
      if (a == b || b == c || c == a) continue;
      triangles_.push_back({});
      put(static_cast<std::uint32_t>(triangles_.size() - 1), {{a, b, c}, p});
    }
  }
  twins_.assign(3 * triangles_.size(), kNone);
  join(checkpoint);
}

std::size_t FlatMesh::size() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(triangles_, [](const FlatTriangle& triangle) { return triangle.polygon != kNone; }));
}

std::vector<FlatTriangle> FlatMesh::triangles() const {
  std::vector<FlatTriangle> result;
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    if (!is_gone(t)) result.push_back(triangles_[t]);
  }
  return result;
}

int FlatMesh::turn(int axis, Vertex a, Vertex b, Vertex c) const {
  return kernel::turn(axis, to_kernel(vertices_[a]), to_kernel(vertices_[b]), to_kernel(vertices_[c]));
}

/// Whether v is on the line from a to b, and neither of them.
bool FlatMesh::is_between(Vertex a, Vertex v, Vertex b) const {
  if (!regions_.empty()) return glm::dot(vertices_[v] - vertices_[a], vertices_[b] - vertices_[v]) > 0;
  for (int axis = 0; axis < 3; ++axis) {
    if (turn(axis, a, v, b) != 0) return false;
  }
  for (int axis = 0; axis < 3; ++axis) {
    const auto [low, high] = std::minmax(vertices_[a][axis], vertices_[b][axis]);
    if (low < vertices_[v][axis] && vertices_[v][axis] < high) return true;
  }
  return false;
}

/// Whether the triangles of two half-edges along one edge, in opposite directions, lie in a plane, on either side of the
/// edge. They do if both turn the same way, as seen along an axis along which they are not edge-on.
bool FlatMesh::is_flat(HalfEdge g, HalfEdge h) const {
  if (!regions_.empty()) return region(g) == region(h);
  const Vertex a = from(g), b = to(g), c = from(before(g)), d = from(before(h));
  if (kernel::orientation(to_kernel(vertices_[a]), to_kernel(vertices_[b]), to_kernel(vertices_[c]),
                          to_kernel(vertices_[d])) != 0) {
    return false;
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (const int side = turn(axis, a, b, c); side != 0) return turn(axis, b, a, d) == side;
  }
  return false;
}

void FlatMesh::join_edge(std::span<const HalfEdge> sides) {
  for (const HalfEdge g : sides) {
    for (const HalfEdge h : sides) {
      if (g >= h || twins_[g] != kNone || twins_[h] != kNone || from(g) == from(h) || !is_flat(g, h)) continue;
      twins_[g] = h;
      twins_[h] = g;
    }
  }
}

void FlatMesh::join(const Checkpoint& checkpoint) {
  std::vector<EdgeSide> sides;
  for (HalfEdge h = 0; h < twins_.size(); ++h) {
    sides.push_back({std::min(from(h), to(h)), std::max(from(h), to(h)), h});
  }
  checkpoint();
  std::ranges::sort(sides);
  std::vector<HalfEdge> along;
  for (std::size_t i = 0; i < sides.size();) {
    checkpoint.at(i);
    along.clear();
    for (const EdgeSide first = sides[i]; i < sides.size() && sides[i].is_along(first); ++i)
      along.push_back(sides[i].half_edge);
    if (along.size() <= kMostAlong) join_edge(along);
  }
}

void FlatMesh::put(std::uint32_t t, const FlatTriangle& triangle) {
  triangles_[t] = triangle;
  for (const Vertex v : triangle.corners) {
    at_[v].push_back(t);
    ++counts_[v];
  }
}

void FlatMesh::remove(std::uint32_t t) {
  for (const Vertex v : triangles_[t].corners) --counts_[v];
  triangles_[t] = {{}, kNone};
}

/// The half-edges that leave v, one of each of its triangles.
std::vector<FlatMesh::HalfEdge> FlatMesh::leaving(Vertex v) {
  std::vector<HalfEdge> result;
  for (const std::uint32_t t : at_[v]) {
    const auto& corners = triangles_[t].corners;
    const auto at = std::ranges::find(corners, v);
    if (!is_gone(t) && at != corners.end()) result.push_back(3 * t + static_cast<HalfEdge>(at - corners.begin()));
  }
  std::ranges::sort(result);
  result.erase(std::unique(result.begin(), result.end()), result.end());
  at_[v].clear();
  for (const HalfEdge h : result) at_[v].push_back(h / 3);
  return result;
}

/// The fan that has this half-edge, which leaves its vertex.
FlatMesh::Fan FlatMesh::fan_from(HalfEdge h) const {
  HalfEdge first = h;
  while (twins_[first] != kNone && next(twins_[first]) != h) first = next(twins_[first]);  // clockwise
  Fan fan;
  fan.is_closed = twins_[first] != kNone;
  for (HalfEdge leaves = first;;) {
    fan.leaving.push_back(leaves);
    fan.loop.push_back(to(leaves));
    const HalfEdge back = before(leaves);
    leaves = twins_[back];
    if (leaves == first) return fan;
    if (leaves == kNone) {
      fan.loop.push_back(from(back));
      return fan;
    }
  }
}

/// Whether the vertex is within flat regions or on a straight border of all that meet it.
bool FlatMesh::may_go(Vertex v, std::span<const Fan> fans) const {
  std::optional<std::pair<Vertex, Vertex>> border;
  for (const Fan& fan : fans) {
    if (fan.is_closed) continue;
    const std::pair<Vertex, Vertex> of_fan = std::minmax(fan.loop.front(), fan.loop.back());
    if (border ? of_fan != *border : !is_between(of_fan.first, v, of_fan.second)) return false;
    border = of_fan;
  }
  return !fans.empty();
}

/// Returns whether the vertex was taken out. Then adds those to `around` that were joined with it.
bool FlatMesh::take_out(Vertex v, std::vector<Vertex>& around) {
  if (counts_[v] > kMostAround) return false;
  std::vector<HalfEdge> left = leaving(v);
  std::vector<Fan> fans;
  while (!left.empty()) {
    fans.push_back(fan_from(left.back()));
    std::erase_if(left, [&](HalfEdge h) { return std::ranges::find(fans.back().leaving, h) != fans.back().leaving.end(); });
  }
  if (!may_go(v, fans)) return false;
  std::vector<std::vector<FaceTriangle>> triangles;
  for (const Fan& fan : fans) {
    auto of_fan = triangles_of_face(vertices_, fan.loop);
    // With fewer triangles a corner would lie within an edge.
    if (!of_fan || of_fan->size() + 2 != fan.loop.size()) return false;
    triangles.push_back(std::move(*of_fan));
  }
  for (std::size_t i = 0; i < fans.size(); ++i) {
    replace(fans[i], triangles[i]);
    around.insert(around.end(), fans[i].loop.begin(), fans[i].loop.end());
  }
  return true;
}

/// Puts the triangles in the place of those of the fan, which are at least as many.
void FlatMesh::replace(const Fan& fan, std::span<const FaceTriangle> triangles) {
  struct Border {
    Vertex from, to;
    HalfEdge twin;
  };
  std::vector<Border> border;
  for (std::size_t i = 0; i < fan.leaving.size(); ++i) {
    const HalfEdge outer = next(fan.leaving[i]);
    border.push_back({from(outer), to(outer), twins_[outer]});
    if (twins_[outer] != kNone) twins_[twins_[outer]] = kNone;  // cut out, to be joined below
  }
  const std::uint32_t polygon = triangles_[fan.leaving.front() / 3].polygon;
  std::vector<HalfEdge> open;
  for (std::size_t i = 0; i < fan.leaving.size(); ++i) {
    const std::uint32_t t = fan.leaving[i] / 3;
    remove(t);
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) twins_[h] = kNone;
    if (i >= triangles.size()) continue;
    put(t, {triangles[i], polygon});
    for (HalfEdge h = 3 * t; h < 3 * t + 3; ++h) open.push_back(h);
  }
  const auto take = [&](Vertex a, Vertex b) {
    const auto found = std::ranges::find_if(open, [&](HalfEdge h) { return from(h) == a && to(h) == b; });
    if (found == open.end()) return kNone;
    const HalfEdge h = *found;
    open.erase(found);
    return h;
  };
  const auto join = [&](HalfEdge g, HalfEdge h) {
    if (g == kNone || h == kNone) return;
    twins_[g] = h;
    twins_[h] = g;
  };
  for (const auto& [a, b, twin] : border) join(take(a, b), twin);
  while (!open.empty()) {
    const HalfEdge h = open.back();
    open.pop_back();
    join(h, take(to(h), from(h)));
  }
}

void FlatMesh::simplify(const Checkpoint& checkpoint) {
  std::vector<bool> is_waiting(at_.size(), true);
  std::deque<Vertex> waiting;
  for (Vertex v = 0; v < at_.size(); ++v) waiting.push_back(v);
  std::vector<Vertex> around;
  for (std::size_t step = 0; !waiting.empty(); ++step) {
    checkpoint.at(step);
    const Vertex v = waiting.front();
    waiting.pop_front();
    is_waiting[v] = false;
    around.clear();
    if (!take_out(v, around)) continue;
    for (const Vertex w : around) {
      if (!is_waiting[w]) waiting.push_back(w);
      is_waiting[w] = true;
    }
  }
}

}  // namespace occlude::culler
