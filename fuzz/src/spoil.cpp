// SPDX-License-Identifier: MIT
#include "occlude/fuzz/spoil.h"

#include <array>
#include <limits>
#include <utility>
#include <variant>
#include <vector>

#include "vector_math.h"

namespace occlude::fuzz {
namespace {

Vec3& some_vertex(Random& random, Case& c) {
  std::vector<Vec3>& vertices = vertices_of(c.occluder);
  return vertices[random.index(vertices.size())];
}

Vec3& some_vector_of_box(Random& random, Box& box) {
  if (auto* const aabb = std::get_if<kernel::Aabb>(&box)) return random.chance(0.5) ? aabb->min : aabb->max;
  auto& obb = std::get<kernel::Obb>(box);
  return random.chance(0.5) ? obb.center : obb.half_edges[random.index(3)];
}

/// Sets a number to one at or beyond the border of the legal range, or to one that is not finite.
void spoil_number(Random& random, Case& c) {
  constexpr std::array kNumbers{0x1p-100,
                                0x1p100,
                                0x1.fffffffffffffp-101,
                                0x1.0000000000001p100,
                                std::numeric_limits<double>::denorm_min(),
                                std::numeric_limits<double>::max(),
                                std::numeric_limits<double>::infinity(),
                                std::numeric_limits<double>::quiet_NaN()};
  const std::array<Vec3*, 3> choice{&c.viewpoint.value, &some_vertex(random, c), &some_vector_of_box(random, c.box)};
  const double number = kNumbers[random.index(kNumbers.size())];
  (*choice[random.index(3)])[random.integer(0, 2)] = random.chance(0.5) ? number : -number;
}

void swap_bounds(Random& random, Case& c) {
  if (auto* const box = std::get_if<kernel::Aabb>(&c.box)) {
    const int axis = random.integer(0, 2);
    std::swap(box->min[axis], box->max[axis]);
  }
}

/// Moves the eye to a vertex, to the midpoint of two vertices, or to a point between three.
void move_eye_to_occluder(Random& random, Case& c) {
  const Vec3 a = some_vertex(random, c), b = some_vertex(random, c), d = some_vertex(random, c);
  c.viewpoint.value = random.chance(0.3) ? a : random.chance(0.5) ? 0.5 * (a + b) : 0.5 * (a + 0.5 * (b + d));
}

/// Moves the viewpoint into the plane of three vertices: the plane of a polygon, or perhaps of a face.
void move_eye_into_plane(Random& random, Case& c) {
  const Vec3 a = some_vertex(random, c), b = some_vertex(random, c), d = some_vertex(random, c);
  const double across = random.integer(-3, 3), along = random.integer(-3, 3);
  const Vec3 way = along * (b - a) + across * (d - a);
  c.viewpoint.value = c.viewpoint.is_eye() ? a + way : way;
}

void move_vertex(Random& random, Case& c) {
  Vec3& vertex = some_vertex(random, c);
  const Vec3 other = some_vertex(random, c);
  vertex = random.chance(0.5) ? other : vertex + (vertex - other);
}

void spoil_loop(Random& random, Polygon& loop) {
  const std::size_t i = random.index(loop.size());
  const auto at = loop.begin() + static_cast<std::ptrdiff_t>(i);
  switch (random.integer(0, 4)) {
    case 0:
      std::swap(loop[i], loop[random.index(loop.size())]);
      break;
    case 1: {  // wound twice
      const Polygon once = loop;
      loop.insert(loop.end(), once.begin(), once.end());
      break;
    }
    case 2:  // add a spike
      loop.insert(at, 2.0 * loop[i] - loop[(i + 1) % loop.size()]);
      break;
    case 3:
      loop.resize(random.index(loop.size()));
      break;
    default:  // go back and forth
      loop.insert(at, loop[(i + loop.size() - 1) % loop.size()]);
  }
}

/// Exchanges two vertices in the list. The polytope stays the same.
void exchange(kernel::Polytope& polytope, std::uint32_t a, std::uint32_t b) {
  std::swap(polytope.vertices[a], polytope.vertices[b]);
  for (std::vector<std::uint32_t>& face : polytope.faces) {
    for (std::uint32_t& i : face) i = i == a ? b : i == b ? a : i;
  }
}

/// Replaces the edge from the last corner to the first by two edges over a point inside the face, and fills the gap with a
/// triangle. The faces are still plane and the solid is still closed, but the face is not convex.
void dent_face(Random& random, kernel::Polytope& polytope, std::size_t i) {
  std::vector<std::uint32_t>& face = polytope.faces[i];
  const std::uint32_t last = face.back(), first = face[0], inner = static_cast<std::uint32_t>(polytope.vertices.size());
  polytope.vertices.push_back(0.25 *
                              (polytope.vertices[last] + polytope.vertices[first] + 2.0 * polytope.vertices[face[1]]));
  face.push_back(inner);
  polytope.faces.push_back({last, first, inner});
  // An edge is tested from the vertex that is listed first. At a random place in the list, the new vertex is the first of
  // some edges and not of others.
  exchange(polytope, inner, static_cast<std::uint32_t>(random.index(polytope.vertices.size())));
}

/// Puts the same triangle on the face twice. Every edge still has two faces.
void patch_face_twice(kernel::Polytope& polytope, std::size_t i) {
  const std::vector<std::uint32_t>& face = polytope.faces[i];
  const Vec3 a = polytope.vertices[face.back()], b = polytope.vertices[face[0]], c = polytope.vertices[face[1]];
  const auto first = static_cast<std::uint32_t>(polytope.vertices.size());
  for (const Vec3& corner : {a, b, c}) polytope.vertices.push_back(0.25 * (a + b + c + corner));
  for (int times = 0; times < 2; ++times) polytope.faces.push_back({first, first + 1, first + 2});
}

void spoil_faces(Random& random, kernel::Polytope& polytope) {
  auto& faces = polytope.faces;
  const std::size_t i = random.index(faces.size());
  switch (random.integer(0, 6)) {
    case 0:
      faces.erase(faces.begin() + static_cast<std::ptrdiff_t>(i));
      break;
    case 1:
      faces.push_back(faces[i]);
      break;
    case 2:
      faces[i].pop_back();
      break;
    case 3:
      dent_face(random, polytope, i);
      break;
    case 4:
      patch_face_twice(polytope, i);
      break;
    case 5:
      faces[i][random.index(faces[i].size())] = static_cast<std::uint32_t>(random.index(polytope.vertices.size() + 2));
      break;
    default:
      faces.resize(random.index(faces.size()));
  }
}

void spoil_order(Random& random, Case& c) {
  if (auto* const polygon = std::get_if<Polygon>(&c.occluder)) return spoil_loop(random, *polygon);
  spoil_faces(random, std::get<kernel::Polytope>(c.occluder));
}

void forget_direction(Random&, Case& c) {
  if (!c.viewpoint.is_eye()) c.viewpoint.value = {};
}

}  // namespace

void spoil(Random& random, Case& c) {
  constexpr std::array kWays{spoil_number, swap_bounds, move_eye_to_occluder, move_eye_into_plane,
                             move_vertex,  spoil_order, forget_direction};
  kWays[random.index(kWays.size())](random, c);
}

}  // namespace occlude::fuzz
