// SPDX-License-Identifier: MIT
#include "sketch.h"

namespace occlude::fuzz {
namespace {

Vec3 centroid(const std::vector<Vec3>& polygon) {
  Vec3 sum;
  for (const Vec3& vertex : polygon) sum = sum + vertex;
  return (1.0 / static_cast<double>(polygon.size())) * sum;
}

Vec3 vector_area(const std::vector<Vec3>& polygon) {
  Vec3 sum;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    sum = sum + cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  }
  return sum;
}

SketchPlane side_plane(const Case& scene, std::size_t i, const Vec3& within) {
  const Vec3 &a = scene.polygon[i], &b = scene.polygon[(i + 1) % scene.polygon.size()];
  SketchPlane plane{cross(sight(scene, a), b - a), a};
  if (plane.height(within) < 0) plane.normal = -1.0 * plane.normal;
  return plane;
}

SketchPlane near_plane(const Case& scene) {
  if (scene.near == Near::farthest) {
    const Vec3& p = scene.polygon[farthest_vertex(scene)];
    return {sight(scene, p), p};
  }
  const Vec3 normal = vector_area(scene.polygon);
  const double sign = dot(normal, sight(scene, scene.polygon[0])) < 0 ? -1 : 1;
  return {sign * normal, scene.polygon[0]};
}

}  // namespace

Vec3 sight(const Case& scene, const Vec3& point) {
  return scene.viewpoint.is_eye() ? point - scene.viewpoint.value : scene.viewpoint.value;
}

std::size_t farthest_vertex(const Case& scene) {
  std::size_t best = 0;
  double most = 0;
  for (std::size_t i = 0; i < scene.polygon.size(); ++i) {
    const Vec3 to_vertex = sight(scene, scene.polygon[i]);
    const double remoteness = dot(to_vertex, scene.viewpoint.is_eye() ? to_vertex : scene.polygon[i]);
    if (i == 0 || remoteness > most) {
      best = i;
      most = remoteness;
    }
  }
  return best;
}

std::vector<SketchPlane> sketch(const Case& scene) {
  const Vec3 within = centroid(scene.polygon);
  std::vector<SketchPlane> planes;
  for (std::size_t i = 0; i < scene.polygon.size(); ++i) planes.push_back(side_plane(scene, i, within));
  planes.push_back(near_plane(scene));
  return planes;
}

}  // namespace occlude::fuzz
