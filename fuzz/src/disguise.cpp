// SPDX-License-Identifier: MIT
#include "disguise.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

#include "scene.h"

namespace occlude::fuzz {
namespace {

using kernel::Polytope;

bool has_area(const Polytope& polytope, const Loop& loop) {
  const Vec3& first = polytope.vertices[loop[0]];
  Vec3 area;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    area = area + cross(polytope.vertices[loop[i]] - first, polytope.vertices[loop[i + 1]] - first);
  }
  return area != Vec3{};
}

/// Cuts a face from its first corner to corner `k`, unless one of the parts would have no area.
void cut(Polytope& polytope, std::size_t face, std::size_t k) {
  const Loop& whole = polytope.faces[face];
  const auto middle = whole.begin() + static_cast<std::ptrdiff_t>(k);
  Loop front(whole.begin(), middle + 1), back(middle, whole.end());
  back.push_back(whole[0]);
  if (!has_area(polytope, front) || !has_area(polytope, back)) return;
  polytope.faces[face] = std::move(front);
  polytope.faces.push_back(std::move(back));
}

void rotate(Random& random, Loop& loop) {
  std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(random.index(loop.size())), loop.end());
}

void cut_faces(Random& random, Polytope& polytope) {
  const double share = random.chance(0.5) ? 0 : random.real(0, 1);
  for (std::size_t face = 0; face < polytope.faces.size(); ++face) {  // parts may be cut again
    Loop& loop = polytope.faces[face];
    if (loop.size() < 4 || !random.chance(share)) continue;
    rotate(random, loop);
    cut(polytope, face, 2 + random.index(loop.size() - 3));
  }
}

/// Inserts the vertex on the edge from `from` to `to`, in the face that has it.
void insert_on_edge(Polytope& polytope, std::uint32_t from, std::uint32_t to, std::uint32_t vertex) {
  for (Loop& loop : polytope.faces) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      if (loop[i] != from || loop[(i + 1) % loop.size()] != to) continue;
      loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(i) + 1, vertex);
      return;
    }
  }
}

/// Puts a vertex on the middle of an edge, in one face or in both. The one face may also be cut from there.
void split_edge(Random& random, Polytope& polytope) {
  const std::size_t face = random.index(polytope.faces.size());
  Loop& loop = polytope.faces[face];
  rotate(random, loop);
  const std::uint32_t from = loop.back(), to = loop.front(), vertex = static_cast<std::uint32_t>(polytope.vertices.size());
  polytope.vertices.push_back(0.5 * (polytope.vertices[from] + polytope.vertices[to]));
  loop.insert(loop.begin(), vertex);
  if (random.chance(0.5)) insert_on_edge(polytope, to, from, vertex);
  if (random.chance(0.5)) cut(polytope, face, 2 + random.index(polytope.faces[face].size() - 3));
}

/// Repeats a corner of a face, by the same index or by a copy of the vertex, or replaces it with the copy.
void repeat_vertex(Random& random, Polytope& polytope) {
  Loop& loop = polytope.faces[random.index(polytope.faces.size())];
  const std::size_t at = random.index(loop.size());
  std::uint32_t vertex = loop[at];
  if (random.chance(0.7)) {
    const Vec3 copy = polytope.vertices[vertex];
    vertex = static_cast<std::uint32_t>(polytope.vertices.size());
    polytope.vertices.push_back(copy);
  }
  if (random.chance(0.5)) {
    loop[at] = vertex;
  } else {
    loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(at), vertex);
  }
}

}  // namespace

void shuffle(Random& random, Polytope& polytope) {
  const double reversed = 0.5 * random.integer(0, 2);  // none, half, all
  for (Loop& loop : polytope.faces) {
    rotate(random, loop);
    if (random.chance(reversed)) std::ranges::reverse(loop);
  }
  std::vector<std::uint32_t> place(polytope.vertices.size());
  std::iota(place.begin(), place.end(), 0U);
  for (std::size_t i = place.size(); i > 1; --i) std::swap(place[i - 1], place[random.index(i)]);
  std::vector<Vec3> vertices(polytope.vertices.size());
  for (std::size_t i = 0; i < vertices.size(); ++i) vertices[place[i]] = polytope.vertices[i];
  polytope.vertices = std::move(vertices);
  for (Loop& loop : polytope.faces) {
    for (std::uint32_t& i : loop) i = place[i];
  }
}

void subdivide(Random& random, Polytope& polytope) {
  cut_faces(random, polytope);
  if (random.chance(0.6)) return;
  for (int edges = random.integer(0, 3); edges > 0; --edges) split_edge(random, polytope);
  for (int vertices = random.integer(0, 3); vertices > 0; --vertices) repeat_vertex(random, polytope);
}

}  // namespace occlude::fuzz
