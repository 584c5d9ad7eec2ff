// SPDX-License-Identifier: MIT
#include "region_questions.h"

#include <array>
#include <cmath>

#include "any_case.h"

namespace occlude::fuzz {
namespace {

using kernel::Aabb;
using kernel::Obb;
using kernel::Vec3;
using kernel::Viewpoint;
using kernel::ViewRegion;

Vec3 plus(const Vec3& a, double factor, const Vec3& b) {
  return {a.x + factor * b.x, a.y + factor * b.y, a.z + factor * b.z};
}
Vec3 minus(const Vec3& a, const Vec3& b) { return plus(a, -1, b); }

Vec3 lattice_vector(Random& random, int reach) {
  const auto one = [&] { return 1. * random.integer(-reach, reach); };
  return {one(), one(), one()};
}

double size_of(const Vec3& v) { return std::fmax(std::fabs(v.x), std::fmax(std::fabs(v.y), std::fabs(v.z))); }

const Vec3& any_vertex(Random& random, const Occluder& occluder) {
  const auto& vertices = vertices_of(occluder);
  return vertices[random.index(vertices.size())];
}

/// The corner with these signs, rounded.
Vec3 corner_of(const Obb& box, std::uint64_t signs) {
  Vec3 corner = box.center;
  for (std::size_t k = 0; k < 3; ++k) corner = plus(corner, (signs >> k & 1U) != 0 ? 1 : -1, box.half_edges[k]);
  return corner;
}

Box box_at(Random& random, const Vec3& corner, double size) {
  const bool is_whole = size >= 1 && random.chance(0.8);
  const auto extent = [&] { return is_whole ? size * random.integer(-2, 2) : random.real(-size, size); };
  if (random.chance(0.7)) {
    const Vec3 other = plus(corner, 1, {extent(), extent(), extent()});
    Aabb box{corner, corner};
    for (int axis = 0; axis < 3; ++axis) {
      box.min[axis] = std::fmin(corner[axis], other[axis]);
      box.max[axis] = std::fmax(corner[axis], other[axis]);
    }
    return box;
  }
  Obb box{corner, {}};
  for (Vec3& half_edge : box.half_edges) {
    if (random.chance(0.8)) half_edge = {extent(), extent(), extent()};
    if (random.chance(0.8)) box.center = plus(box.center, 1, half_edge);  // the corner stays a corner
  }
  return box;
}

/// A point of a line of sight from a corner of the region through a vertex.
Vec3 point_in_sight(Random& random, const RegionCase& c) {
  const Vec3& vertex = any_vertex(random, c.occluder);
  const Vec3 corner = corner_of(c.region.box, random.bits());
  const Vec3 sight = c.region.kind == Viewpoint::Kind::eye ? minus(vertex, corner) : corner;
  const double along = random.chance(0.6) ? random.integer(0, 3) : random.real(0, 4);
  return plus(vertex, along, sight);
}

Vec3 half_edge(Random& random, const Occluder& occluder, const Vec3& viewpoint, bool is_lattice) {
  if (random.chance(0.25)) return {};
  if (random.chance(0.2)) return minus(any_vertex(random, occluder), any_vertex(random, occluder));
  const double size = size_of(minus(any_vertex(random, occluder), viewpoint));
  Vec3 edge = lattice_vector(random, 2);
  if (!is_lattice)
    edge = plus({}, 0.3 * size * random.real(0, 1), {random.real(-1, 1), random.real(-1, 1), random.real(-1, 1)});
  if (random.chance(0.5)) {  // along an axis
    const int axis = random.integer(0, 2);
    const double length = edge[axis];
    edge = {};
    edge[axis] = length;
  }
  return edge;
}

RegionCase about_a_case(Random& random, kernel::ShadowKind kind) {
  const Case c = any_legal_case(random);
  RegionCase question{{c.viewpoint.kind, {c.viewpoint.value, {}}}, kind, c.occluder, c.box};
  Obb& region = question.region.box;
  const bool is_lattice = region.center.x == std::floor(region.center.x);
  for (Vec3& edge : region.half_edges) edge = half_edge(random, c.occluder, region.center, is_lattice);
  if (random.chance(0.05)) region.half_edges[0] = minus(any_vertex(random, c.occluder), region.center);
  if (random.chance(0.4)) {
    question.box =
        box_at(random, point_in_sight(random, question), size_of(minus(any_vertex(random, c.occluder), region.center)));
  }
  return question;
}

kernel::Polytope parallelepiped(const Vec3& at, const Vec3& u, const Vec3& v, const Vec3& w) {
  kernel::Polytope result;
  for (unsigned i = 0; i < 8; ++i) {
    const auto bit = [&](unsigned k) { return (i >> k & 1U) != 0 ? 1. : 0.; };
    result.vertices.push_back(plus(plus(plus(at, bit(0), u), bit(1), v), bit(2), w));
  }
  result.faces = {{0, 1, 3, 2}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 3, 7, 5}};
  return result;
}

Occluder lattice_occluder(Random& random) {
  const Vec3 at = plus({1. * random.integer(2, 5), 0, 0}, 1, lattice_vector(random, 2));
  const Vec3 u = lattice_vector(random, 4), v = lattice_vector(random, 4), w = lattice_vector(random, 4);
  const Vec3 p = plus(at, 1, u), q = plus(at, 1, v), r = plus(at, 1, w);
  switch (random.integer(0, 4)) {
    case 0:
      return Polygon{at, p, q};
    case 1:
      return Polygon{at, p, plus(p, 1, v), q};
    case 2:
      return Polygon{at, plus(at, 2, u), plus(plus(at, 2, u), 1, v), plus(p, 2, v), plus(q, 1, v)};
    case 3:
      return kernel::Polytope{{at, p, q, r}, {{0, 1, 2}, {0, 1, 3}, {0, 2, 3}, {1, 2, 3}}};
    default:
      return parallelepiped(at, u, v, w);
  }
}

RegionCase on_a_lattice(Random& random, kernel::ShadowKind kind) {
  RegionCase question{{}, kind, lattice_occluder(random), Aabb{}};
  Obb& region = question.region.box;
  region.center = lattice_vector(random, 2);
  if (random.chance(0.25)) {
    question.region.kind = Viewpoint::Kind::direction;
    region.center.x += 3;
  }
  for (Vec3& edge : region.half_edges) {
    if (random.chance(0.7)) edge = half_edge(random, question.occluder, region.center, true);
  }
  const bool is_aimed = random.chance(0.6);
  const Vec3 at = is_aimed ? point_in_sight(random, question) : plus({6, 0, 0}, 1, lattice_vector(random, 5));
  question.box = box_at(random, at, random.chance(0.5) ? 1 : 0.5);
  return question;
}

/// A rectangle of half sides a at distance n (b - a) before a rectangle of eyes of half sides b: the umbra ends at n a
/// beyond it, over the side on which b is larger. With equal differences it ends in a point for a square, else in a ridge.
RegionCase before_a_larger_region(Random& random, kernel::ShadowKind kind) {
  const std::array<double, 2> a{1. * random.integer(1, 3), 1. * random.integer(1, 3)};
  const double more = random.integer(1, 3), n = random.integer(1, 3), distance = n * more;
  const std::array<double, 2> shear{1. * random.integer(-1, 1), 1. * random.integer(-1, 1)};
  const auto at = [&](double x, double y, double z) { return Vec3{x, y + shear[0] * x, z + shear[1] * x}; };
  const double other = random.chance(0.5) ? more : random.integer(0, 4);
  RegionCase question{{}, kind, Polygon{}, Aabb{}};
  question.region.box = {{0, 0, 0}, {{{0, a[0] + more, 0}, {0, 0, a[1] + other}, {}}}};
  if (random.chance(0.3)) question.region.box.half_edges[2] = at(-1, 0, 0);  // the far end of the region is less tight
  if (random.chance(0.3)) question.region.box.center = at(-1, 0, 0);
  const double thickness = random.chance(0.3) ? random.integer(1, 2) : 0;
  if (thickness == 0) {
    question.occluder =
        Polygon{at(distance, -a[0], -a[1]), at(distance, a[0], -a[1]), at(distance, a[0], a[1]), at(distance, -a[0], a[1])};
  } else {
    question.occluder = parallelepiped(at(distance, -a[0], -a[1]), {0, 2 * a[0], 0}, {0, 0, 2 * a[1]}, at(thickness, 0, 0));
  }
  const Vec3 end = at(distance + n * a[0], 0, random.integer(-1, 1) * std::fmax(0, a[1] - a[0]));
  question.box = box_at(random, random.chance(0.7) ? end : point_in_sight(random, question), random.chance(0.5) ? 1 : 0.25);
  return question;
}

/// Permutes the axes and scales by a number that may round.
void turn_and_scale(Random& random, RegionCase& question) {
  const int turn = random.integer(0, 2);
  const double scale = random.chance(0.7) ? 1 : random.chance(0.5) ? 0.1 : std::ldexp(1, random.integer(-70, 70));
  const auto change = [&](Vec3& v) { v = {scale * v[turn], scale * v[(turn + 1) % 3], scale * v[(turn + 2) % 3]}; };
  change(question.region.box.center);
  for (Vec3& edge : question.region.box.half_edges) change(edge);
  for (Vec3& vertex : vertices_of(question.occluder)) change(vertex);
  if (auto* const aabb = std::get_if<Aabb>(&question.box)) {
    change(aabb->min);
    change(aabb->max);
    return;
  }
  Obb& box = std::get<Obb>(question.box);
  change(box.center);
  for (Vec3& edge : box.half_edges) change(edge);
}

}  // namespace

RegionCase region_question(Random& random, kernel::ShadowKind kind) {
  const int which = random.integer(0, 2);
  if (which == 0) return about_a_case(random, kind);
  RegionCase question = which == 1 ? on_a_lattice(random, kind) : before_a_larger_region(random, kind);
  turn_and_scale(random, question);
  return question;
}

}  // namespace occlude::fuzz
