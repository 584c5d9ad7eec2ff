// SPDX-License-Identifier: MIT
#include "scenes.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "vector_math.h"

namespace occlude::fuzz {
namespace {

struct Step {
  int a = 0, b = 0;
};

std::int64_t cross(const Step& p, const Step& q) { return std::int64_t{p.a} * q.b - std::int64_t{p.b} * q.a; }

/// Counter-clockwise from the positive a axis.
bool has_lower_angle(const Step& p, const Step& q) {
  const auto half = [](const Step& s) { return s.b < 0 || (s.b == 0 && s.a < 0); };
  return half(p) != half(q) ? half(q) : cross(p, q) > 0;
}

bool have_one_direction(const Step& p, const Step& q) { return cross(p, q) == 0 && p.a * q.a + p.b * q.b > 0; }

/// `count - 1` random steps of different directions, and the one that leads back.
std::vector<Step> closed_steps(Random& random, int count, int reach) {
  std::vector<Step> steps;
  Step closing;
  while (static_cast<int>(steps.size()) < count - 1) {
    const Step step{random.integer(-reach, reach), random.integer(-reach, reach)};
    const bool is_old = std::ranges::any_of(steps, [&](const Step& s) { return have_one_direction(s, step); });
    if ((step.a == 0 && step.b == 0) || is_old) continue;
    steps.push_back(step);
    closing = {closing.a - step.a, closing.b - step.b};
  }
  if (closing.a != 0 || closing.b != 0) steps.push_back(closing);
  return steps;
}

/// The edges, sorted by angle, of a convex polygon of about `count` sides.
std::vector<Step> lattice_edges(Random& random, int count, int reach) {
  while (true) {
    std::vector<Step> steps = closed_steps(random, count, reach);
    if (std::ranges::all_of(steps, [&](const Step& s) { return cross(steps[0], s) == 0; })) continue;  // no area
    std::ranges::sort(steps, has_lower_angle);
    return steps;
  }
}

Vec3 lattice_vector(Random& random, int reach) {
  const auto next = [&] { return static_cast<double>(random.integer(-reach, reach)); };
  const double x = next(), y = next(), z = next();
  return {x, y, z};
}

Vec3 random_vector(Random& random, double reach) {
  const double x = random.real(-reach, reach), y = random.real(-reach, reach), z = random.real(-reach, reach);
  return {x, y, z};
}

/// Two vectors that span a plane; often axes, so that side planes fall on axis planes too.
std::array<Vec3, 2> lattice_basis(Random& random) {
  while (true) {
    const int reach = random.integer(1, 2);
    const Vec3 e = lattice_vector(random, reach), f = lattice_vector(random, reach);
    if (fuzz::cross(e, f) != Vec3{}) return {e, f};
  }
}

Near random_near(Random& random) { return random.chance(0.5) ? Near::farthest : Near::surface; }

/// The polygon of the steps in a random lattice plane.
std::vector<Vec3> embed(Random& random, const std::vector<Step>& steps) {
  const auto [e, f] = lattice_basis(random);
  std::vector<Vec3> polygon;
  Vec3 at = lattice_vector(random, 4);
  for (const Step& step : steps) {
    polygon.push_back(at);
    at = at + static_cast<double>(step.a) * e + static_cast<double>(step.b) * f;
  }
  if (random.chance(0.5)) std::ranges::reverse(polygon);
  return polygon;
}

/// A normal of the plane of a coplanar polygon.
Vec3 plane_normal(const std::vector<Vec3>& polygon) {
  for (std::size_t i = 2; i < polygon.size(); ++i) {
    const Vec3 normal = fuzz::cross(polygon[1] - polygon[0], polygon[i] - polygon[0]);
    if (normal != Vec3{}) return normal;
  }
  return {};
}

/// A lattice eye off the polygon's plane, or a direction across it.
kernel::Viewpoint lattice_viewpoint(Random& random, const std::vector<Vec3>& polygon, bool is_eye) {
  const Vec3 normal = plane_normal(polygon);
  while (true) {
    // Beside a vertex: near enough for wide frusta, and often on a common axis plane with it.
    const Vec3& vertex = polygon[random.index(polygon.size())];
    const Vec3 offset = lattice_vector(random, random.chance(0.5) ? 3 : 9);
    if (dot(normal, offset) == 0) continue;
    return is_eye ? kernel::Viewpoint::eye(vertex + offset) : kernel::Viewpoint::direction(offset);
  }
}

Case lattice_scene_of(Random& random, const std::vector<Step>& steps, bool is_eye = true) {
  Case scene;
  scene.polygon = embed(random, steps);
  scene.viewpoint = lattice_viewpoint(random, scene.polygon, is_eye);
  scene.near = random_near(random);
  return scene;
}

std::vector<Step> few_edges(Random& random) { return lattice_edges(random, random.integer(3, 6), 3); }

Case exchange_axes(Random& random, Case scene) {
  const int shift = random.integer(0, 2);
  const std::array<double, 3> sign{random.chance(0.5) ? 1.0 : -1.0, random.chance(0.5) ? 1.0 : -1.0, 1.0};
  const auto exchange = [&](Vec3& v) {
    v = {sign[0] * v[shift], sign[1] * v[(shift + 1) % 3], sign[2] * v[(shift + 2) % 3]};
  };
  std::ranges::for_each(scene.polygon, exchange);
  exchange(scene.viewpoint.value);
  return scene;
}

/// A point of the unit circle at about `turn` of a whole turn, by a rational parametrisation: no libm, the same everywhere.
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

/// A convex polygon about `centre`, its vertices on an ellipse in a random plane and off it by up to `fold`.
std::vector<Vec3> ellipse_polygon(Random& random, int sides, const Vec3& centre, double fold) {
  const Vec3 e = random_vector(random, 5), f = random_vector(random, 5), up = fuzz::cross(e, f);
  const double scale = fold / std::sqrt(dot(up, up));
  std::vector<Vec3> polygon;
  for (int i = 0; i < sides; ++i) {
    const auto [c, s] = on_circle((i + random.real(0.1, 0.9)) / sides);
    polygon.push_back(centre + c * e + s * f + (scale * random.real(-1, 1)) * up);
  }
  return polygon;
}

}  // namespace

Case random_scene(Random& random) {
  Case scene;
  const int sides = random.chance(0.5) ? 3 : random.integer(4, 6);
  scene.polygon = ellipse_polygon(random, sides, random_vector(random, 5), 0);
  scene.viewpoint = kernel::Viewpoint::eye(random_vector(random, 10));
  scene.near = sides == 3 ? random_near(random) : Near::farthest;
  return scene;
}

Case folded_scene(Random& random) {
  Case scene;
  scene.polygon = ellipse_polygon(random, 4, random_vector(random, 3), 0.5);
  const Vec3 across = fuzz::cross(scene.polygon[1] - scene.polygon[0], scene.polygon[2] - scene.polygon[0]);
  const double distance = random.real(5, 15) / std::sqrt(dot(across, across));
  scene.viewpoint = kernel::Viewpoint::eye(scene.polygon[0] + random_vector(random, 2) + distance * across);
  return scene;
}

Case sliver_scene(Random& random) {
  Case scene;
  const Vec3 start = random_vector(random, 5), along = random_vector(random, 10), aside = random_vector(random, 1);
  const double width = random.chance(0.5) ? 1e-6 : 1e-9;
  scene.polygon = {start, start + along, start + random.real(-0.2, 1.2) * along + width * aside};
  scene.viewpoint = kernel::Viewpoint::eye(random_vector(random, 10));
  scene.near = random_near(random);
  return scene;
}

Case lattice_scene(Random& random) { return lattice_scene_of(random, few_edges(random)); }

Case many_sided_scene(Random& random) {
  const int sides = random.chance(0.5) ? random.integer(3, 12) : random.integer(13, 64);
  return lattice_scene_of(random, lattice_edges(random, sides, sides < 13 ? 4 : 9));
}

Case collinear_scene(Random& random) {
  Case scene = lattice_scene(random);
  std::vector<Vec3> loop;
  for (std::size_t i = 0; i < scene.polygon.size(); ++i) {
    const Vec3 &a = scene.polygon[i], &b = scene.polygon[(i + 1) % scene.polygon.size()];
    loop.push_back(4.0 * a);
    if (random.chance(0.25)) loop.push_back(4.0 * a);
    if (random.chance(0.3)) loop.push_back(3.0 * a + b);
    if (random.chance(0.3)) loop.push_back(2.0 * a + 2.0 * b);
    if (random.chance(0.15)) loop.push_back(2.0 * a + 2.0 * b);
  }
  scene.polygon = std::move(loop);
  scene.viewpoint.value = 4.0 * scene.viewpoint.value;
  return scene;
}

Case equal_farthest_scene(Random& random) {
  constexpr std::array<Step, 12> kCircle{
      {{5, 0}, {4, 3}, {3, 4}, {0, 5}, {-3, 4}, {-4, 3}, {-5, 0}, {-4, -3}, {-3, -4}, {0, -5}, {3, -4}, {4, -3}}};
  Case scene;
  const int height = random.integer(1, 12);
  while (scene.polygon.size() < 3) {
    scene.polygon.clear();
    for (const Step& step : kCircle) {
      if (random.chance(0.4)) scene.polygon.push_back(Vec3{1.0 * step.a, 1.0 * step.b, 1.0 * height});
    }
  }
  const Vec3 offset = lattice_vector(random, 9);
  for (Vec3& vertex : scene.polygon) vertex = vertex + offset;
  scene.viewpoint = kernel::Viewpoint::eye(offset);
  return exchange_axes(random, std::move(scene));
}

Case lattice_sliver_scene(Random& random) {
  const int length = random.integer(50, 500);
  const Step along{length, random.integer(-1, 1)}, aside{random.integer(0, length), random.integer(2, 3)};
  return lattice_scene_of(random, {along, aside, {-along.a - aside.a, -along.b - aside.b}});
}

Case sturdy_lattice_scene(Random& random) {
  Case scene = lattice_scene(random);
  if (scene.polygon.size() > 3) scene.near = Near::farthest;
  return scene;
}

Case orthographic_scene(Random& random) {
  Case scene = random_scene(random);
  scene.viewpoint = kernel::Viewpoint::direction(random_vector(random, 1));
  return scene;
}

Case orthographic_lattice_scene(Random& random) { return lattice_scene_of(random, few_edges(random), false); }

}  // namespace occlude::fuzz
