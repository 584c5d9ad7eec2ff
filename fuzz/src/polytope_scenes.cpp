// SPDX-License-Identifier: MIT
#include "polytope_scenes.h"

#include <algorithm>
#include <utility>

#include "lattice.h"
#include "scenes.h"
#include "sketch.h"
#include "solids.h"

namespace occlude::fuzz {
namespace {

enum class Seen { from_eye, along_direction };

Scene scene_of(Random& random, Solid solid) {
  return {{}, std::move(solid.vertices), std::move(solid.faces), random_near(random)};
}

bool has_front_face(const Scene& scene) {
  return std::ranges::any_of(scene.faces, [&](const Loop& face) { return is_front(scene, face); });
}

/// Tries viewpoints until one sees the polytope from outside.
template <class RandomViewpoint>
Scene seen_from_outside(Scene scene, const RandomViewpoint& random_viewpoint) {
  do {
    scene.viewpoint = random_viewpoint(scene);
  } while (!has_front_face(scene));
  return scene;
}

/// Sees the scene from a lattice eye beside a vertex, or along a direction.
Scene seen_at_random(Random& random, Scene scene, Seen seen) {
  return seen_from_outside(std::move(scene), [&](const Scene& s) {
    const Vec3 offset = lattice_vector(random, random.chance(0.5) ? 3 : 9);
    if (seen == Seen::along_direction) return kernel::Viewpoint::direction(offset);
    return kernel::Viewpoint::eye(s.vertices[random.index(s.vertices.size())] + offset);
  });
}

/// Sees the scene from the plane of a face, or from the line of one of its edges.
Scene seen_edge_on(Random& random, Scene scene, Seen seen) {
  return seen_from_outside(std::move(scene), [&](const Scene& s) {
    const Loop& face = s.faces[random.index(s.faces.size())];
    const std::size_t i = random.index(face.size()), count = face.size();
    const Vec3& corner = s.vertices[face[i]];
    const Vec3 along = s.vertices[face[(i + 1) % count]] - corner, back = s.vertices[face[(i + count - 1) % count]] - corner;
    const double a = random.integer(-3, 3), b = random.chance(0.3) ? 0 : random.integer(-3, 3);
    const Vec3 offset = a * along + b * back;
    return seen == Seen::from_eye ? kernel::Viewpoint::eye(corner + offset) : kernel::Viewpoint::direction(offset);
  });
}

/// The unit vector in the direction of a vector along an axis.
Vec3 unit_along_axis(const Vec3& v) {
  const auto sign = [](double x) { return x > 0 ? 1.0 : x < 0 ? -1.0 : 0.0; };
  return {sign(v.x), sign(v.y), sign(v.z)};
}

Scene simplicial_scene(Random& random, Seen seen) {
  Scene scene = scene_of(random, simplicial_lattice_solid(random));
  return random.chance(0.5) ? seen_edge_on(random, std::move(scene), seen) : seen_at_random(random, std::move(scene), seen);
}

}  // namespace

Scene polytope_scene(Random& random) {
  return seen_from_outside(scene_of(random, simplicial_solid(random)),
                           [&](const Scene&) { return kernel::Viewpoint::eye(random_vector(random, 12)); });
}

Scene orthographic_polytope_scene(Random& random) {
  return seen_from_outside(scene_of(random, simplicial_solid(random)),
                           [&](const Scene&) { return kernel::Viewpoint::direction(random_vector(random, 1)); });
}

Scene lattice_box_scene(Random& random) {
  return seen_at_random(random, scene_of(random, lattice_box(random)), Seen::from_eye);
}

Scene lattice_hull_scene(Random& random) {
  return seen_at_random(random, scene_of(random, lattice_hull(random, 7)), Seen::from_eye);
}

Scene lattice_polytope_scene(Random& random) {
  return seen_at_random(random, scene_of(random, lattice_solid(random)), Seen::from_eye);
}

Scene orthographic_lattice_polytope_scene(Random& random) {
  return seen_at_random(random, scene_of(random, lattice_solid(random)), Seen::along_direction);
}

Scene lattice_surface_scene(Random& random) {
  Scene scene = lattice_polytope_scene(random);
  scene.near = Near::surface;
  return scene;
}

Scene many_sided_polytope_scene(Random& random) {
  return seen_at_random(random, scene_of(random, many_sided_solid(random)), Seen::from_eye);
}

Scene edge_on_scene(Random& random) { return seen_edge_on(random, scene_of(random, lattice_solid(random)), Seen::from_eye); }

Scene orthographic_edge_on_scene(Random& random) {
  return seen_edge_on(random, scene_of(random, lattice_solid(random)), Seen::along_direction);
}

Scene simplicial_lattice_scene(Random& random) { return simplicial_scene(random, Seen::from_eye); }

Scene orthographic_simplicial_lattice_scene(Random& random) { return simplicial_scene(random, Seen::along_direction); }

Scene equal_farthest_polytope_scene(Random& random) {
  const Scene polygon = equal_farthest_scene(random);  // perpendicular to an axis through the eye
  const std::vector<Vec3>& base = polygon.vertices;
  const Vec3 normal = plane_normal(base);
  const double height = dot(normal, base[0] - polygon.viewpoint.value);
  const Vec3 away = (height < 0 ? -1 : 1) * unit_along_axis(normal);
  const bool is_prism = random.chance(0.5);
  const Vec3 way = static_cast<double>(is_prism ? random.integer(1, 3) : random.chance(0.5) ? 1 : -1) * away;
  Solid solid = is_prism ? prism(base, way) : pyramid(base, base[0] + way);
  return {polygon.viewpoint, std::move(solid.vertices), std::move(solid.faces), Near::farthest};
}

Scene wide_polytope_scene(Random& random) {
  Scene scene = wide_scene(random);
  Vec3 way = way_off(random, scene.vertices, 9);
  const Vec3 normal = plane_normal(scene.vertices);
  // It leads away from the eye, so that the polygon becomes a front face.
  if (dot(normal, way) * dot(normal, scene.vertices[0] - scene.viewpoint.value) < 0) way = -1.0 * way;
  Solid solid = prism(scene.vertices, way);
  return {scene.viewpoint, std::move(solid.vertices), std::move(solid.faces), scene.near};
}

}  // namespace occlude::fuzz
