// SPDX-License-Identifier: MIT
#include "scenes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "lattice.h"

namespace occlude::fuzz {
namespace {

/// A lattice eye off the polygon's plane, or a direction that is not parallel to the plane.
kernel::Viewpoint lattice_viewpoint(Random& random, const std::vector<Vec3>& polygon, bool is_eye) {
  const Vec3 normal = plane_normal(polygon);
  while (true) {
    // A point beside a vertex is near enough for wide frusta, and often on a common axis plane with the vertex.
    const Vec3& vertex = polygon[random.index(polygon.size())];
    const Vec3 offset = lattice_vector(random, random.chance(0.5) ? 3 : 9);
    if (dot(normal, offset) == 0) continue;
    return is_eye ? kernel::Viewpoint::eye(vertex + offset) : kernel::Viewpoint::direction(offset);
  }
}

Scene lattice_scene_of(Random& random, const std::vector<Step>& steps, bool is_eye = true) {
  Scene scene;
  scene.vertices = embed(random, steps);
  scene.viewpoint = lattice_viewpoint(random, scene.vertices, is_eye);
  scene.near = random_near(random);
  return scene;
}

Scene exchange_axes(Random& random, Scene scene) {
  const int shift = random.integer(0, 2);
  const std::array<double, 3> sign{random.chance(0.5) ? 1.0 : -1.0, random.chance(0.5) ? 1.0 : -1.0, 1.0};
  const auto exchange = [&](Vec3& v) {
    v = {sign[0] * v[shift], sign[1] * v[(shift + 1) % 3], sign[2] * v[(shift + 2) % 3]};
  };
  std::ranges::for_each(scene.vertices, exchange);
  exchange(scene.viewpoint.value);
  return scene;
}

/// A point of the unit circle at about the fraction `turn` of a turn. The parametrisation is rational. It does not need
/// libm, so it gives the same on every machine.
std::array<double, 2> on_circle(double turn) {
  const double quarter = std::floor(turn * 4), t = turn * 4 - quarter;
  const double c = (1 - t * t) / (1 + t * t), s = 2 * t / (1 + t * t);
  switch (static_cast<int>(quarter) & 3) {
    case 0:
      return {c, s};
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    default:
      return {s, -c};
  }
}

Vec3 unit(const Vec3& v) { return (1 / std::sqrt(dot(v, v))) * v; }

/// A convex polygon about `centre`. Its vertices are on an ellipse in a random plane, moved off that plane by up to `fold`.
std::vector<Vec3> ellipse_polygon(Random& random, int sides, const Vec3& centre, double fold) {
  const Vec3 e = random_vector(random, 5), f = random_vector(random, 5), up = cross(e, f);
  const double scale = fold / std::sqrt(dot(up, up));
  std::vector<Vec3> polygon;
  for (int i = 0; i < sides; ++i) {
    const auto [c, s] = on_circle((i + random.real(0.1, 0.9)) / sides);
    polygon.push_back(centre + c * e + s * f + (scale * random.real(-1, 1)) * up);
  }
  return polygon;
}

/// The rectangle perpendicular to the axis whose opposite corners, seen along the axis, are `start` and `end`, or three of
/// its corners.
std::vector<Vec3> axis_rectangle(Random& random, int axis, const Vec3& start, const Vec3& end) {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  std::vector<Vec3> corners(4, start);
  corners[1][u] = corners[2][u] = end[u];
  corners[2][v] = corners[3][v] = end[v];
  if (random.chance(0.5)) corners.pop_back();
  return corners;
}

Vec3 lattice_sizes(Random& random) {
  const double x = random.integer(1, 6), y = random.integer(1, 6), z = random.integer(1, 6);
  return {x, y, z};
}

/// An offset along the axis. The offsets along the other axes are mostly zero.
Vec3 offset_along_axes(Random& random, int axis) {
  Vec3 offset;
  const int along = random.integer(1, 9);
  offset[axis] = random.chance(0.5) ? along : -along;
  for (const int other : {(axis + 1) % 3, (axis + 2) % 3}) {
    if (random.chance(0.4)) offset[other] = random.integer(-9, 9);
  }
  return offset;
}

}  // namespace

Near random_near(Random& random) { return random.chance(0.5) ? Near::farthest : Near::surface; }

Scene random_scene(Random& random) {
  Scene scene;
  const int sides = random.chance(0.5) ? 3 : random.integer(4, 6);
  scene.vertices = ellipse_polygon(random, sides, random_vector(random, 5), 0);
  scene.viewpoint = kernel::Viewpoint::eye(random_vector(random, 10));
  scene.near = sides == 3 ? random_near(random) : Near::farthest;
  return scene;
}

Scene folded_scene(Random& random) {
  Scene scene;
  scene.vertices = ellipse_polygon(random, 4, random_vector(random, 3), 0.5);
  const Vec3 across = cross(scene.vertices[1] - scene.vertices[0], scene.vertices[2] - scene.vertices[0]);
  const double distance = random.real(5, 15) / std::sqrt(dot(across, across));
  scene.viewpoint = kernel::Viewpoint::eye(scene.vertices[0] + random_vector(random, 2) + distance * across);
  return scene;
}

Scene cospherical_scene(Random& random) {
  const int sides = random.chance(0.5) ? random.integer(3, 12) : random.integer(13, 200);
  const Vec3 u = unit(random_vector(random, 1)), v = unit(cross(u, random_vector(random, 1))), axis = cross(u, v);
  const double distance = random.real(1, 20), radius = random.real(1, 5);
  Scene scene;
  scene.viewpoint = kernel::Viewpoint::eye(random_vector(random, 10));
  for (int i = 0; i < sides; ++i) {
    const auto [c, s] = on_circle((i + random.real(0.1, 0.9)) / sides);
    scene.vertices.push_back(scene.viewpoint.value + distance * axis + (radius * c) * u + (radius * s) * v);
  }
  return scene;
}

Scene edge_at_eye_scene(Random& random) {
  // (p - e) x (2 p - e) = p x e, and e is almost parallel to p. The products are about 2^80, and what is left of them is
  // below 2^-20.
  const Vec3 p = random_vector(random, 0x1p40);
  const Vec3 e = 0x1p-60 * p + random_vector(random, std::ldexp(1, -random.integer(60, 68)));
  Scene scene;
  scene.vertices = {p, 2.0 * p, random_vector(random, 0x1p41)};
  scene.viewpoint = kernel::Viewpoint::eye(e);
  scene.near = random_near(random);
  return scene;
}

Scene level_with_eye_scene(Random& random) {
  // All numbers are multiples of the unit, below 2 about the origin and below 2^5 elsewhere, so sums of a few of them are
  // exact. Slopes are sixteenths, and what they multiply are multiples of at least 16 units, so these products are exact
  // too.
  const bool at_origin = random.chance(0.5);
  const double unit = at_origin ? 0x1p-52 : 0x1p-48;
  const auto multiple = [&](double step, double low, double high) {
    return step * std::floor(random.real(low, high) / step);
  };
  const auto slope = [&] { return random.integer(-8, 8) / 16.0; };
  const double along = slope(), a = slope(), b = slope();
  // The narrower the polygon looks, the larger is the share of rounding in its mean normal.
  const double width = std::ldexp(0.5, -random.integer(0, 20));
  const Vec3 eye = at_origin ? Vec3{} : lattice_vector(random, 9);
  std::array<Vec3, 4> spread;
  for (Vec3& v : spread) {
    const double x = multiple(256 * unit, 0.25, 1), y = along * x + multiple(16 * unit, -width, width);
    v = {x, y, a * x + b * y};
  }
  std::ranges::sort(spread, {}, [](const Vec3& v) { return v.y / v.x; });
  // Two vertices are seen between the others. They are moved to opposite sides of the plane, so the loop is convex.
  spread[1].z -= unit * random.integer(1, 4);
  spread[2].z += unit * random.integer(1, 4);
  Scene scene;
  for (const int i : {0, 1, 3, 2}) scene.vertices.push_back(eye + spread[static_cast<std::size_t>(i)]);
  if (random.chance(0.5)) std::ranges::reverse(scene.vertices);
  scene.viewpoint = kernel::Viewpoint::eye(eye);
  scene.near = random_near(random);
  return exchange_axes(random, std::move(scene));
}

Scene sliver_scene(Random& random) {
  Scene scene;
  const Vec3 start = random_vector(random, 5), along = random_vector(random, 10), aside = random_vector(random, 1);
  const double width = random.chance(0.5) ? 1e-6 : 1e-9;
  scene.vertices = {start, start + along, start + random.real(-0.2, 1.2) * along + width * aside};
  scene.viewpoint = kernel::Viewpoint::eye(random_vector(random, 10));
  scene.near = random_near(random);
  return scene;
}

Scene lattice_scene(Random& random) { return lattice_scene_of(random, few_edges(random)); }

Scene many_sided_scene(Random& random) {
  const int sides = random.chance(0.5) ? random.integer(3, 12) : random.integer(13, 64);
  return lattice_scene_of(random, lattice_edges(random, sides, sides < 13 ? 4 : 9));
}

Scene collinear_scene(Random& random) {
  Scene scene = lattice_scene(random);
  std::vector<Vec3> loop;
  for (std::size_t i = 0; i < scene.vertices.size(); ++i) {
    const Vec3 &a = scene.vertices[i], &b = scene.vertices[(i + 1) % scene.vertices.size()];
    loop.push_back(4.0 * a);
    if (random.chance(0.25)) loop.push_back(4.0 * a);
    if (random.chance(0.3)) loop.push_back(3.0 * a + b);
    if (random.chance(0.3)) loop.push_back(2.0 * a + 2.0 * b);
    if (random.chance(0.15)) loop.push_back(2.0 * a + 2.0 * b);
  }
  scene.vertices = std::move(loop);
  scene.viewpoint.value = 4.0 * scene.viewpoint.value;
  return scene;
}

Scene equal_farthest_scene(Random& random) {
  constexpr std::array<Step, 12> kCircle{
      {{5, 0}, {4, 3}, {3, 4}, {0, 5}, {-3, 4}, {-4, 3}, {-5, 0}, {-4, -3}, {-3, -4}, {0, -5}, {3, -4}, {4, -3}}};
  Scene scene;
  const int height = random.integer(1, 12);
  while (scene.vertices.size() < 3) {
    scene.vertices.clear();
    for (const Step& step : kCircle) {
      if (random.chance(0.4)) scene.vertices.push_back(Vec3{1.0 * step.a, 1.0 * step.b, 1.0 * height});
    }
  }
  const Vec3 offset = lattice_vector(random, 9);
  for (Vec3& vertex : scene.vertices) vertex = vertex + offset;
  scene.viewpoint = kernel::Viewpoint::eye(offset);
  return exchange_axes(random, std::move(scene));
}

Scene lattice_sliver_scene(Random& random) {
  const int length = random.integer(50, 500);
  const Step along{length, random.integer(-1, 1)}, aside{random.integer(0, length), random.integer(2, 3)};
  return lattice_scene_of(random, {along, aside, {-along.a - aside.a, -along.b - aside.b}});
}

Scene sturdy_lattice_scene(Random& random) {
  Scene scene = lattice_scene(random);
  if (scene.vertices.size() > 3) scene.near = Near::farthest;
  return scene;
}

Scene wide_scene(Random& random) {
  Scene scene;
  scene.vertices = embed(random, few_edges(random));
  for (Vec3& vertex : scene.vertices) vertex = 16.0 * vertex;
  const std::size_t count = scene.vertices.size(), i = random.index(count);
  const Vec3 &a = scene.vertices[i], &b = scene.vertices[(i + 1) % count], &c = scene.vertices[(i + 1 + count / 2) % count];
  // The foot has integer coordinates, because the differences are multiples of 16.
  const double to_b = random.integer(0, 12) / 16.0, to_c = random.integer(1, 12) / 16.0;
  const Vec3 foot = a + to_b * (b - a) + to_c * (c - a), normal = plane_normal(scene.vertices);
  Vec3 offset;
  while (dot(normal, offset) == 0) offset = lattice_vector(random, 2);
  scene.viewpoint = kernel::Viewpoint::eye(foot + offset);
  scene.near = random.chance(0.8) ? Near::farthest : Near::surface;
  return scene;
}

Scene axis_aligned_scene(Random& random) {
  const int axis = random.integer(0, 2);
  const Vec3 start = lattice_vector(random, 4), size = lattice_sizes(random);
  Scene scene;
  scene.vertices = axis_rectangle(random, axis, start, start + size);
  const Vec3& corner = scene.vertices[random.index(scene.vertices.size())];
  scene.viewpoint = kernel::Viewpoint::eye(corner + offset_along_axes(random, axis));
  scene.near = random_near(random);
  return scene;
}

Scene orthographic_axis_aligned_scene(Random& random) {
  const int axis = random.integer(0, 2);
  const Vec3 start = lattice_vector(random, 4), size = lattice_sizes(random);
  Scene scene;
  scene.vertices = axis_rectangle(random, axis, start, start + size);
  scene.viewpoint = kernel::Viewpoint::direction(offset_along_axes(random, axis));
  scene.near = random_near(random);
  return scene;
}

Scene large_lattice_scene(Random& random) {
  constexpr int kReach = 1 << 24;
  Scene scene;
  for (int i = 0; i < 3; ++i) scene.vertices.push_back(lattice_vector(random, kReach));
  scene.viewpoint = kernel::Viewpoint::eye(lattice_vector(random, kReach));
  scene.near = random_near(random);
  return scene;
}

Scene shared_coordinates_scene(Random& random) {
  const int axis = random.integer(0, 2);
  const Vec3 start = random_vector(random, 5), end = random_vector(random, 5);
  Scene scene;
  scene.vertices = axis_rectangle(random, axis, start, end);
  if (scene.vertices.size() == 3 && random.chance(0.5)) scene.vertices[2] = random_vector(random, 5);
  const Vec3& corner = scene.vertices[random.index(scene.vertices.size())];
  Vec3 eye = random_vector(random, 10);
  for (const int other : {(axis + 1) % 3, (axis + 2) % 3}) {
    if (random.chance(0.3)) eye[other] = corner[other];
  }
  scene.viewpoint = kernel::Viewpoint::eye(eye);
  scene.near = random_near(random);
  return scene;
}

Scene orthographic_scene(Random& random) {
  Scene scene = random_scene(random);
  scene.viewpoint = kernel::Viewpoint::direction(random_vector(random, 1));
  return scene;
}

Scene orthographic_lattice_scene(Random& random) { return lattice_scene_of(random, few_edges(random), false); }

}  // namespace occlude::fuzz
