// SPDX-License-Identifier: MIT
#include "finish.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

#include "disguise.h"
#include "vector_math.h"

namespace occlude::fuzz {
namespace {

/// Applies `change` to every point of the case. A direction of view and half edges are not points.
template <class Change>
void for_each_point(Case& made, const Change& change) {
  for (Vec3& vertex : vertices_of(made.occluder)) change(vertex);
  if (made.viewpoint.is_eye()) change(made.viewpoint.value);
  if (auto* const box = std::get_if<kernel::Aabb>(&made.box)) {
    change(box->min);
    change(box->max);
  } else {
    change(std::get<kernel::Obb>(made.box).center);
  }
}

template <class Change>
void for_each_half_edge(Case& made, const Change& change) {
  if (auto* const box = std::get_if<kernel::Obb>(&made.box)) std::ranges::for_each(box->half_edges, change);
}

void scale(Case& made, double factor) {
  const auto change = [&](Vec3& v) { v = factor * v; };
  for_each_point(made, change);
  for_each_half_edge(made, change);
}

/// Whether vertices may move one by one: those of a triangle, those of a polygon whose silhouette alone matters, those of a
/// polytope whose faces are all triangles.
bool may_bend(const Case& made) {
  if (const auto* const polygon = std::get_if<std::vector<Vec3>>(&made.occluder)) {
    return polygon->size() == 3 || made.near == Near::farthest;
  }
  return std::ranges::all_of(std::get<kernel::Polytope>(made.occluder).faces, [](const auto& f) { return f.size() == 3; });
}

std::array<Vec3*, 4> vectors_of(Box& box) {
  if (auto* const aabb = std::get_if<kernel::Aabb>(&box)) return {&aabb->min, &aabb->max, &aabb->min, &aabb->max};
  auto& obb = std::get<kernel::Obb>(box);
  return {&obb.center, &obb.half_edges[0], &obb.half_edges[1], &obb.half_edges[2]};
}

}  // namespace

void leave(Random&, Case&) {}

void nudge(Random& random, Case& made) {
  const bool bends = may_bend(made);
  std::vector<Vec3>& vertices = vertices_of(made.occluder);
  const auto box = vectors_of(made.box);
  for (int moves = random.integer(1, 3); moves > 0; --moves) {
    Vec3* const vertex = bends ? &vertices[random.index(vertices.size())] : box[3];
    const std::array<Vec3*, 6> choice{box[0], box[1], box[2], box[3], &made.viewpoint.value, vertex};
    double& value = (*choice[random.index(choice.size())])[random.integer(0, 2)];
    if (value != 0) value = std::nextafter(value, random.chance(0.5) ? HUGE_VAL : -HUGE_VAL);
  }
  if (auto* const aabb = std::get_if<kernel::Aabb>(&made.box)) {
    for (int axis = 0; axis < 3; ++axis) aabb->max[axis] = std::max(aabb->min[axis], aabb->max[axis]);
  }
}

void move_by_a_hair(Random& random, Case& made) {
  const bool bends = may_bend(made);
  std::vector<Vec3>& vertices = vertices_of(made.occluder);
  const auto box = vectors_of(made.box);
  const std::array<Vec3, 3> corners{*box[0], *box[1], vertices[random.index(vertices.size())]};
  const Vec3 middle = corners[random.index(std::holds_alternative<kernel::Aabb>(made.box) ? 3 : 1)];
  for_each_point(made, [&](Vec3& p) { p = p - middle; });
  Vec3* const vertex = bends ? &vertices[random.index(vertices.size())] : box[3];
  const std::array<Vec3*, 6> choice{box[0], box[1], box[2], box[3], &made.viewpoint.value, vertex};
  for (int tries = random.integer(3, 12); tries > 0; --tries) {
    double& value = (*choice[random.index(choice.size())])[random.integer(0, 2)];
    const double size = std::ldexp(1, -random.integer(40, 100)), hair = random.chance(0.5) ? size : -size;
    if (value == 0) value = hair;
  }
  if (auto* const aabb = std::get_if<kernel::Aabb>(&made.box)) {
    for (int axis = 0; axis < 3; ++axis) aabb->max[axis] = std::max(aabb->min[axis], aabb->max[axis]);
  }
}

void move_far(Random& random, Case& made) {
  const double unit = 0x1p-8;
  const auto part = [&] {
    const double far = 4e9 * random.integer(-1, 1);
    return far + unit * random.integer(-1000, 1000);
  };
  const double x = part(), y = part(), z = part();
  for_each_point(made, [&](Vec3& p) { p = unit * p + Vec3{x, y, z}; });
  for_each_half_edge(made, [&](Vec3& e) { e = unit * e; });
}

void shrink(Random&, Case& made) { scale(made, 0x1p-60); }

void grow(Random&, Case& made) { scale(made, 0x1p60); }

void lengthen(Random& random, Case& made) {
  const double scale = std::ldexp(1, random.integer(2, 40)), length = scale * random.real(1, 2);
  const int axis = random.integer(0, 2);
  if (auto* const aabb = std::get_if<kernel::Aabb>(&made.box)) {
    if (random.chance(0.5)) {
      aabb->max[axis] += length;
    } else {
      aabb->min[axis] -= length;
    }
    return;
  }
  auto& obb = std::get<kernel::Obb>(made.box);
  Vec3& half_edge = obb.half_edges[static_cast<std::size_t>(axis)];
  const Vec3 more = length * half_edge;
  obb.center = random.chance(0.5) ? obb.center + more : obb.center - more;
  half_edge = half_edge + more;
}

void lengthen_along_rays(Random& random, Case& made) {
  const Vec3 along = std::ldexp(1, random.integer(2, 40)) * made.viewpoint.value;
  for (Vec3& half_edge : std::get<kernel::Obb>(made.box).half_edges) {
    if (half_edge == Vec3{}) half_edge = along;
  }
}

void stretch(Random& random, Case& made) {
  const int all = random.integer(-100, 80);
  Vec3 factor;
  for (int axis = 0; axis < 3; ++axis) factor[axis] = std::ldexp(1, random.chance(0.5) ? all : random.integer(-100, 80));
  const auto change = [&](Vec3& v) {
    for (int axis = 0; axis < 3; ++axis) v[axis] *= factor[axis];
  };
  for_each_point(made, change);
  for_each_half_edge(made, change);
}

void make_decimal(Random& random, Case& made) {
  const bool tenths = random.chance(0.5);
  const auto change = [&](Vec3& v) {
    for (int axis = 0; axis < 3; ++axis) v[axis] = tenths ? v[axis] * 0.1 : v[axis] / 3;
  };
  for_each_point(made, change);
  for_each_half_edge(made, change);
}

void reorder(Random& random, Case& made) { shuffle(random, std::get<kernel::Polytope>(made.occluder)); }

void disguise(Random& random, Case& made) {
  subdivide(random, std::get<kernel::Polytope>(made.occluder));
  reorder(random, made);
}

}  // namespace occlude::fuzz
