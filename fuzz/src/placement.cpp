// SPDX-License-Identifier: MIT
#include "placement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "sketch.h"

namespace occlude::fuzz {
namespace {

enum class Intent { inside, poking, touching, apart };

/// A point of the frustum, and the normals of the planes of the frustum on which it lies.
struct Contact {
  Vec3 point;
  std::vector<Vec3> normals;
};

/// How far a box goes from its contact point, downwards and upwards per axis.
struct Extents {
  Vec3 down, up;
};

Intent random_intent(Random& random) {
  const double u = random.real(0, 1);
  return u < 0.4 ? Intent::inside : u < 0.5 ? Intent::poking : u < 0.65 ? Intent::touching : Intent::apart;
}

Feature random_feature(Random& random) {
  constexpr Feature kAll[] = {Feature::interior, Feature::face, Feature::ray, Feature::near, Feature::corner};
  return kAll[random.index(std::size(kAll))];
}

bool is_on_near_plane(Random& random, Feature feature) {
  return feature == Feature::near || feature == Feature::corner || (feature == Feature::face && random.chance(0.15));
}

/// Weights of the vertices; the contact lies in the direction of their weighted mean.
std::vector<double> random_weights(Random& random, std::size_t count, Feature feature) {
  std::vector<double> weights(count, 0);
  const std::size_t first = random.index(count);
  const auto weight = [&] { return static_cast<double>(random.integer(1, 3)); };
  weights[first] = weight();
  if (feature == Feature::face) weights[(first + 1) % count] = weight();
  if (feature == Feature::interior || feature == Feature::near) {
    weights[(first + 1) % count] = weight();
    weights[(first + 1 + count / 2) % count] = weight();
    weights[(first + 1 + count / 3) % count] = weight();
    if (count == 3) weights[(first + 2) % count] = weight();
  }
  return weights;
}

Vec3 weighted_sum(const std::vector<Vec3>& vertices, const std::vector<double>& weights) {
  Vec3 sum;
  for (std::size_t i = 0; i < vertices.size(); ++i) sum = sum + weights[i] * vertices[i];
  return sum;
}

/// Normals of the planes on which the contact lies: of the sides that hold every weighted vertex, perhaps of the near plane.
std::vector<Vec3> normals_at(const std::vector<SketchPlane>& planes, const Case& scene, const std::vector<double>& weights,
                             bool on_near_plane) {
  const std::size_t count = scene.polygon.size();
  std::vector<Vec3> normals;
  for (std::size_t side = 0; side < count; ++side) {
    bool holds_all = planes[side].normal != Vec3{};
    for (std::size_t i = 0; i < count; ++i) {
      const bool is_end = i == side || i == (side + 1) % count;
      if (weights[i] != 0 && !is_end && planes[side].height(scene.polygon[i]) != 0) holds_all = false;
    }
    if (holds_all) normals.push_back(planes[side].normal);
  }
  if (on_near_plane) normals.push_back(planes.back().normal);
  return normals;
}

/// The ratio of two integers in lowest terms, so that scaling by them stays small.
void reduce(double& a, double& b) {
  const auto divisor = static_cast<double>(std::gcd(static_cast<std::int64_t>(a), static_cast<std::int64_t>(b)));
  if (divisor > 1) {
    a /= divisor;
    b /= divisor;
  }
}

/// Where the near plane cuts a ray: at the eye + numerator / denominator * ray, both integers on a lattice.
struct Reach {
  double numerator, denominator;
};

Reach reach_of_near_plane(const Case& scene, const Vec3& ray, double total_weight) {
  if (scene.near == Near::surface) return {1, total_weight};
  const Vec3 farthest = sight(scene, scene.polygon[farthest_vertex(scene)]);
  return {dot(farthest, farthest), dot(ray, farthest)};
}

double random_extra(Random& random, double scale, bool on_near_plane, bool is_lattice) {
  if (on_near_plane) return 0;
  return is_lattice ? std::ceil(scale * random.real(0, 2)) : scale * random.real(0.01, 2);
}

/// The contact point seen from an eye. On a lattice the polygon is scaled about the eye so that the point is an integer.
Vec3 contact_from_eye(Random& random, Case& scene, std::vector<double>& weights, bool on_near_plane, bool is_lattice) {
  const Vec3 eye = scene.viewpoint.value;
  const auto ray_of = [&] {
    return weighted_sum(scene.polygon, weights) - std::accumulate(weights.begin(), weights.end(), 0.0) * eye;
  };
  Vec3 ray = ray_of();
  Reach reach = reach_of_near_plane(scene, ray, std::accumulate(weights.begin(), weights.end(), 0.0));
  if (reach.denominator <= 0) {  // the near plane is behind this ray of a very wide frustum: take the farthest vertex's own
    std::ranges::fill(weights, 0);
    weights[farthest_vertex(scene)] = 1;
    ray = ray_of();
    reach = reach_of_near_plane(scene, ray, 1);
  }
  if (!is_lattice) {
    const double t = reach.numerator / reach.denominator;
    return eye + (t + random_extra(random, t, on_near_plane, false)) * ray;
  }
  reduce(reach.numerator, reach.denominator);
  for (Vec3& vertex : scene.polygon) vertex = eye + reach.denominator * (vertex - eye);
  return eye + (reach.numerator + random_extra(random, reach.numerator, on_near_plane, true)) * ray;
}

/// The same for a direction of view.
Vec3 contact_along_direction(Random& random, Case& scene, const std::vector<double>& weights, bool on_near_plane,
                             bool is_lattice) {
  const Vec3 direction = scene.viewpoint.value;
  const double total = std::accumulate(weights.begin(), weights.end(), 0.0);
  const Vec3 sum = weighted_sum(scene.polygon, weights);
  double scale = total, way = 0;  // scale * (mean + ...): the point is (sum * scale / total + way * direction) / scale
  if (scene.near == Near::farthest) {
    scale = total * dot(direction, direction);
    way = dot(total * scene.polygon[farthest_vertex(scene)] - sum, direction);
  }
  const double room = std::max(way, is_lattice ? 4.0 : scale * 4);
  const Vec3 point = (scale / total) * sum + (way + random_extra(random, room, on_near_plane, is_lattice)) * direction;
  if (!is_lattice) return (1 / scale) * point;
  for (Vec3& vertex : scene.polygon) vertex = scale * vertex;
  return point;
}

void enlarge(Case& scene, Contact& contact, double factor) {
  for (Vec3& vertex : scene.polygon) vertex = factor * vertex;
  if (scene.viewpoint.is_eye()) scene.viewpoint.value = factor * scene.viewpoint.value;
  contact.point = factor * contact.point;
}

Contact make_contact(Random& random, Case& scene, Feature feature, bool is_lattice) {
  std::vector<double> weights = random_weights(random, scene.polygon.size(), feature);
  const bool on_near_plane = is_on_near_plane(random, feature);
  const std::vector<SketchPlane> planes = sketch(scene);
  const Case before = scene;
  Contact contact;
  contact.point = scene.viewpoint.is_eye() ? contact_from_eye(random, scene, weights, on_near_plane, is_lattice)
                                           : contact_along_direction(random, scene, weights, on_near_plane, is_lattice);
  contact.normals = normals_at(planes, before, weights, on_near_plane);
  if (is_lattice) enlarge(scene, contact, random.chance(0.5) ? 8 : 64);
  return contact;
}

/// Extents in which no point goes to the negative side of any of the normals, up to 1 an axis.
Extents random_extents(Random& random, const std::vector<Vec3>& normals) {
  Extents extents;
  for (int axis = 0; axis < 3; ++axis) {
    const bool may_sink = std::ranges::all_of(normals, [&](const Vec3& n) { return n[axis] <= 0; });
    const bool may_rise = std::ranges::all_of(normals, [&](const Vec3& n) { return n[axis] >= 0; });
    if (may_sink && random.chance(0.8)) extents.down[axis] = random.real(0.1, 1);
    if (may_rise && random.chance(0.8)) extents.up[axis] = random.real(0.1, 1);
  }
  return extents;
}

/// The factor at which extents about `point` first leave one of the planes that the point is not on; infinite if never.
double room_for(const std::vector<SketchPlane>& planes, const Vec3& point, const Extents& extents) {
  double room = std::numeric_limits<double>::infinity();
  for (const SketchPlane& plane : planes) {
    const double height = plane.height(point);
    double drop = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double n = plane.normal[axis];
      drop += n > 0 ? n * extents.down[axis] : -n * extents.up[axis];
    }
    if (height > 0 && drop > 0) room = std::min(room, height / drop);
  }
  return room;
}

/// A plane through the contact with the frustum on its positive side: a positive mixture of the planes there. Half the time
/// one that is parallel to an axis, so that an edge of the box can lie across an edge of the frustum.
Vec3 supporting_normal(Random& random, const std::vector<Vec3>& normals) {
  const Vec3 &n = normals[random.index(normals.size())], &m = normals[random.index(normals.size())];
  const int axis = random.integer(0, 2);
  if (n[axis] * m[axis] < 0) return std::abs(m[axis]) * n + std::abs(n[axis]) * m;
  return random.chance(0.5) ? n : n + m;
}

int main_axis(const Vec3& v) {
  const double x = std::abs(v.x), y = std::abs(v.y), z = std::abs(v.z);
  return x >= y && x >= z ? 0 : y >= z ? 1 : 2;
}

void flatten(Random& random, Extents& extents, int axes) {
  const int first = random.integer(0, 2);
  for (int i = 0; i < axes; ++i) extents.down[(first + i) % 3] = extents.up[(first + i) % 3] = 0;
}

double size_of(const Case& scene, const Vec3& point) {
  const Vec3 d = point - (scene.viewpoint.is_eye() ? scene.viewpoint.value : scene.polygon[0]);
  return std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z), 1.0});
}

/// min and max = the extents, times `factor`, about the point; whole numbers on a lattice.
kernel::Aabb make_box(const Vec3& point, const Extents& extents, double factor, bool is_lattice) {
  kernel::Aabb box;
  for (int axis = 0; axis < 3; ++axis) {
    const double down = factor * extents.down[axis], up = factor * extents.up[axis];
    box.min[axis] = point[axis] - (is_lattice ? std::floor(down) : down);
    box.max[axis] = point[axis] + (is_lattice ? std::floor(up) : up);
  }
  return box;
}

/// Moves the box off the positive side of `normal`: by one unit on a lattice, by a small part of `size` else.
void push_out(Random& random, kernel::Aabb& box, const Vec3& normal, double size, bool is_lattice) {
  const int axis = main_axis(normal);
  const double part = random.chance(0.5) ? random.real(0, 1) : 1e-5 * random.real(0, 1);
  const double step = (normal[axis] > 0 ? -1 : 1) * (is_lattice ? 1.0 : size * part);
  box.min[axis] += step;
  box.max[axis] += step;
}

}  // namespace

void place_box(Random& random, Case& scene, const Placement& placement) {
  const Intent intent = random_intent(random);
  Feature feature = placement.feature == Feature::any ? random_feature(random) : placement.feature;
  const bool is_outer = intent == Intent::touching || intent == Intent::apart;
  if (is_outer && feature == Feature::interior) feature = Feature::face;
  const Contact contact = make_contact(random, scene, feature, placement.is_lattice);
  const double size = size_of(scene, contact.point);

  const Vec3 support = contact.normals.empty() ? Vec3{} : supporting_normal(random, contact.normals);
  Extents extents = random_extents(random, is_outer ? std::vector<Vec3>{-1.0 * support} : contact.normals);
  flatten(random, extents, placement.flat_axes);
  double factor = size * random.real(0.01, 1);
  if (!is_outer) {
    factor = std::min(size, room_for(sketch(scene), contact.point, extents)) * random.real(0.3, 1);
    if (intent == Intent::poking && contact.normals.empty()) factor *= 4;
  }
  scene.box = make_box(contact.point, extents, factor, placement.is_lattice);
  if (intent == Intent::apart || intent == Intent::poking) {
    push_out(random, scene.box, support, is_outer ? size : 0.2 * factor, placement.is_lattice);
  }
}

void place_box_about_eye(Random& random, Case& scene) {
  const Extents extents{{random.real(0, 1), random.real(0, 1), random.real(0, 1)},
                        {random.real(0, 1), random.real(0, 1), random.real(0, 1)}};
  for (Vec3& vertex : scene.polygon) vertex = 8.0 * vertex;
  scene.viewpoint.value = 8.0 * scene.viewpoint.value;
  const SketchPlane near = sketch(scene).back();
  double reach = 0;
  for (int axis = 0; axis < 3; ++axis) {
    reach += std::max(near.normal[axis] * extents.up[axis], -near.normal[axis] * extents.down[axis]);
  }
  const double factor = -near.height(scene.viewpoint.value) / reach * random.real(0.3, 3);
  scene.box = make_box(scene.viewpoint.value, extents, factor, true);
}

}  // namespace occlude::fuzz
