// SPDX-License-Identifier: MIT
#include "contact.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace occlude::fuzz {
namespace {

/// A weight for each vertex of the scene. The contact lies in the direction of the weighted mean.
using Weights = std::vector<double>;

bool is_on_near_plane(Random& random, Feature feature) {
  return feature == Feature::near || feature == Feature::near_edge || feature == Feature::corner ||
         feature == Feature::vertex || (feature == Feature::face && random.chance(0.15));
}

/// The loop whose vertices get weights: the silhouette, or one of the front faces for a contact on the surface of a
/// polytope.
const Loop& choose_loop(Random& random, const Scene& scene, const Outline& outline, Feature feature) {
  const bool is_of_surface =
      feature == Feature::near || feature == Feature::near_edge || feature == Feature::corner || feature == Feature::vertex;
  if (scene.is_polygon() || scene.near == Near::farthest || !is_of_surface) return outline.silhouette;
  return outline.front[random.index(outline.front.size())];
}

Weights random_weights(Random& random, std::size_t vertex_count, const Loop& loop, Feature feature) {
  Weights weights(vertex_count, 0);
  const std::size_t count = loop.size(), first = random.index(count);
  const auto weigh = [&](std::size_t i) { weights[loop[i % count]] = random.integer(1, 3); };
  weigh(first);
  if (feature == Feature::face || feature == Feature::near_edge) weigh(first + 1);
  if (feature == Feature::interior || feature == Feature::near) {
    weigh(first + 1);
    weigh(first + 1 + count / 2);
    weigh(first + 1 + count / 3);
    if (count == 3) weigh(first + 2);
  }
  return weights;
}

Vec3 weighted_sum(const std::vector<Vec3>& vertices, const Weights& weights) {
  Vec3 sum;
  for (std::size_t i = 0; i < vertices.size(); ++i) sum = sum + weights[i] * vertices[i];
  return sum;
}

/// Whether all weighted vertices are on the plane. Those for which `is_own` holds are on it by construction. For the others
/// the computed height must be exactly zero.
template <class IsOwn>
bool holds_weighted(const SketchPlane& plane, const Scene& scene, const Weights& weights, const IsOwn& is_own) {
  if (plane.normal == Vec3{}) return false;
  for (std::size_t i = 0; i < weights.size(); ++i) {
    if (weights[i] != 0 && !is_own(i) && plane.height(scene.vertices[i]) != 0) return false;
  }
  return true;
}

/// Normals of the planes on which the contact lies: sides that contain every weighted vertex, and near planes if it is on
/// one.
std::vector<Vec3> normals_at(const Scene& scene, const Outline& outline, const Weights& weights, bool on_near_plane) {
  const std::vector<SketchPlane> planes = sketch(scene, outline);
  const Loop& silhouette = outline.silhouette;
  const std::size_t sides = silhouette.size();
  std::vector<Vec3> normals;
  for (std::size_t side = 0; side < sides; ++side) {
    const auto is_end = [&](std::size_t i) { return i == silhouette[side] || i == silhouette[(side + 1) % sides]; };
    if (holds_weighted(planes[side], scene, weights, is_end)) normals.push_back(planes[side].normal);
  }
  if (!on_near_plane) return normals;
  if (planes.size() == sides + 1) {
    normals.push_back(planes.back().normal);
    return normals;
  }
  for (std::size_t i = 0; i < outline.front.size(); ++i) {
    const auto is_corner = [&](std::size_t v) { return std::ranges::find(outline.front[i], v) != outline.front[i].end(); };
    if (holds_weighted(planes[sides + i], scene, weights, is_corner)) normals.push_back(planes[sides + i].normal);
  }
  return normals;
}

/// Reduces the ratio of two integers to lowest terms, so that scaling by them keeps numbers small.
void reduce(double& a, double& b) {
  const auto divisor = static_cast<double>(std::gcd(static_cast<std::int64_t>(a), static_cast<std::int64_t>(b)));
  if (divisor > 1) {
    a /= divisor;
    b /= divisor;
  }
}

/// The near plane cuts a ray at eye + numerator / denominator * ray. On a lattice both are integers.
struct Reach {
  double numerator, denominator;
};

Reach reach_of_near_plane(const Scene& scene, std::size_t farthest, const Vec3& ray, double total_weight) {
  if (scene.near == Near::surface) return {1, total_weight};
  const Vec3 sight_line = sight(scene, scene.vertices[farthest]);
  return {dot(sight_line, sight_line), dot(ray, sight_line)};
}

double random_extra(Random& random, double scale, bool on_near_plane, bool is_lattice) {
  if (on_near_plane) return 0;
  return is_lattice ? std::ceil(scale * random.real(0, 2)) : scale * random.real(0.01, 2);
}

double total_of(const Weights& weights) { return std::accumulate(weights.begin(), weights.end(), 0.0); }

Vec3 weighted_ray(const Scene& scene, const Weights& weights) {
  return weighted_sum(scene.vertices, weights) - total_of(weights) * scene.viewpoint.value;
}

void put_all_weight_on(std::size_t vertex, Weights& weights) {
  std::ranges::fill(weights, 0);
  weights[vertex] = 1;
}

/// In a very wide frustum the near plane may be behind the eye on some rays. Then the ray of the farthest vertex is used.
void avoid_rays_behind(const Scene& scene, std::size_t farthest, Weights& weights) {
  if (!scene.viewpoint.is_eye()) return;
  const Reach reach = reach_of_near_plane(scene, farthest, weighted_ray(scene, weights), total_of(weights));
  if (reach.denominator <= 0) put_all_weight_on(farthest, weights);
}

/// The contact point for an eye. On a lattice the vertices are scaled about the eye so that the point has integer
/// coordinates.
Vec3 contact_from_eye(Random& random, Scene& scene, std::size_t farthest, const Weights& weights, bool on_near_plane,
                      bool is_lattice) {
  const Vec3 eye = scene.viewpoint.value, ray = weighted_ray(scene, weights);
  Reach reach = reach_of_near_plane(scene, farthest, ray, total_of(weights));
  if (!is_lattice) {
    const double t = reach.numerator / reach.denominator;
    return eye + (t + random_extra(random, t, on_near_plane, false)) * ray;
  }
  reduce(reach.numerator, reach.denominator);
  for (Vec3& vertex : scene.vertices) vertex = eye + reach.denominator * (vertex - eye);
  return eye + (reach.numerator + random_extra(random, reach.numerator, on_near_plane, true)) * ray;
}

/// The same for a direction of view.
Vec3 contact_along_direction(Random& random, Scene& scene, std::size_t farthest, const Weights& weights, bool on_near_plane,
                             bool is_lattice) {
  const Vec3 direction = scene.viewpoint.value;
  const double total = total_of(weights);
  const Vec3 sum = weighted_sum(scene.vertices, weights);
  double scale = total, way = 0;  // the point is (sum * scale / total + way * direction) / scale
  if (scene.near == Near::farthest) {
    scale = total * dot(direction, direction);
    way = dot(total * scene.vertices[farthest] - sum, direction);
  }
  const double room = std::max(way, is_lattice ? 4.0 : scale * 4);
  const Vec3 point = (scale / total) * sum + (way + random_extra(random, room, on_near_plane, is_lattice)) * direction;
  if (!is_lattice) return (1 / scale) * point;
  for (Vec3& vertex : scene.vertices) vertex = scale * vertex;
  return point;
}

}  // namespace

Feature resolve(Random& random, Feature feature) {
  constexpr Feature kAny[] = {Feature::interior, Feature::face, Feature::ray, Feature::near, Feature::corner};
  constexpr Feature kEdge[] = {Feature::ray, Feature::near_edge};
  constexpr Feature kFront[] = {Feature::near, Feature::near_edge, Feature::corner};
  switch (feature) {
    case Feature::any:
      return kAny[random.index(std::size(kAny))];
    case Feature::edge:
      return kEdge[random.index(std::size(kEdge))];
    case Feature::front:
      return kFront[random.index(std::size(kFront))];
    default:
      return feature;
  }
}

Contact make_contact(Random& random, Scene& scene, const Outline& outline, Feature feature, bool is_lattice) {
  const Loop& loop = choose_loop(random, scene, outline, feature);
  Weights weights = random_weights(random, scene.vertices.size(), loop, feature);
  const bool on_near_plane = is_on_near_plane(random, feature);
  const std::size_t farthest = farthest_vertex(scene, outline);
  const bool is_vertex = feature == Feature::vertex;
  if (is_vertex && scene.near == Near::farthest) put_all_weight_on(farthest, weights);
  avoid_rays_behind(scene, farthest, weights);
  std::vector<Vec3> normals = normals_at(scene, outline, weights, on_near_plane);
  if (is_vertex) {
    const auto hit = std::ranges::find_if(weights, [](double w) { return w != 0; });
    return {scene.vertices[static_cast<std::size_t>(hit - weights.begin())], std::move(normals)};
  }
  const auto contact_point = scene.viewpoint.is_eye() ? contact_from_eye : contact_along_direction;
  return {contact_point(random, scene, farthest, weights, on_near_plane, is_lattice), std::move(normals)};
}

}  // namespace occlude::fuzz
