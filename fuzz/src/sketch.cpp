// SPDX-License-Identifier: MIT
#include "sketch.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace occlude::fuzz {
namespace {

Vec3 centroid(const Scene& scene, const Loop& loop) {
  Vec3 sum;
  for (const std::uint32_t i : loop) sum = sum + scene.vertices[i];
  return (1.0 / static_cast<double>(loop.size())) * sum;
}

Vec3 vector_area(const Scene& scene, const Loop& loop) {
  const Vec3& first = scene.vertices[loop[0]];
  Vec3 sum;
  for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
    sum = sum + cross(scene.vertices[loop[i]] - first, scene.vertices[loop[i + 1]] - first);
  }
  return sum;
}

using DirectedEdge = std::pair<std::uint32_t, std::uint32_t>;

/// The loop of the edges that only one of the faces has.
Loop boundary(const std::vector<Loop>& faces, std::size_t vertex_count) {
  std::vector<DirectedEdge> edges;
  for (const Loop& face : faces) {
    for (std::size_t i = 0; i < face.size(); ++i) edges.emplace_back(face[i], face[(i + 1) % face.size()]);
  }
  std::ranges::sort(edges);
  std::vector<std::uint32_t> next(vertex_count, 0);
  std::uint32_t start = 0;
  for (const auto& [from, to] : edges) {
    if (std::ranges::binary_search(edges, DirectedEdge{to, from})) continue;
    next[from] = to;
    start = from;
  }
  Loop loop{start};
  for (std::uint32_t i = next[start]; i != start; i = next[i]) loop.push_back(i);
  return loop;
}

SketchPlane side_plane(const Scene& scene, const Loop& silhouette, std::size_t i, const Vec3& within) {
  const Vec3& a = scene.vertices[silhouette[i]];
  const Vec3& b = scene.vertices[silhouette[(i + 1) % silhouette.size()]];
  SketchPlane plane{cross(sight(scene, a), b - a), a};
  if (plane.height(within) < 0) plane.normal = -1.0 * plane.normal;
  return plane;
}

SketchPlane face_plane(const Scene& scene, const Loop& face) {
  const Vec3 normal = vector_area(scene, face), &point = scene.vertices[face[0]];
  const double sign = dot(normal, sight(scene, point)) < 0 ? -1 : 1;
  return {sign * normal, point};
}

}  // namespace

Vec3 sight(const Scene& scene, const Vec3& point) {
  return scene.viewpoint.is_eye() ? point - scene.viewpoint.value : scene.viewpoint.value;
}

bool is_front(const Scene& scene, const Loop& face) {
  return dot(vector_area(scene, face), sight(scene, scene.vertices[face[0]])) < 0;
}

Outline outline_of(const Scene& scene) {
  Outline outline;
  if (scene.is_polygon()) {
    outline.silhouette.resize(scene.vertices.size());
    std::iota(outline.silhouette.begin(), outline.silhouette.end(), 0U);
    outline.front = {outline.silhouette};
  } else {
    std::ranges::copy_if(scene.faces, std::back_inserter(outline.front), [&](const Loop& f) { return is_front(scene, f); });
    outline.silhouette = boundary(outline.front, scene.vertices.size());
  }
  return outline;
}

std::size_t farthest_vertex(const Scene& scene, const Outline& outline) {
  std::size_t best = outline.silhouette[0];
  double most = 0;
  for (const std::uint32_t i : outline.silhouette) {
    const Vec3 to_vertex = sight(scene, scene.vertices[i]);
    const double remoteness = dot(to_vertex, scene.viewpoint.is_eye() ? to_vertex : scene.vertices[i]);
    if (i == outline.silhouette[0] || remoteness > most || (remoteness == most && i < best)) {
      best = i;
      most = remoteness;
    }
  }
  return best;
}

std::vector<SketchPlane> sketch(const Scene& scene, const Outline& outline) {
  const Vec3 within = centroid(scene, outline.silhouette);
  std::vector<SketchPlane> planes;
  for (std::size_t i = 0; i < outline.silhouette.size(); ++i) {
    planes.push_back(side_plane(scene, outline.silhouette, i, within));
  }
  if (scene.near == Near::farthest) {
    const Vec3& p = scene.vertices[farthest_vertex(scene, outline)];
    planes.push_back({sight(scene, p), p});
  } else {
    for (const Loop& face : outline.front) planes.push_back(face_plane(scene, face));
  }
  return planes;
}

}  // namespace occlude::fuzz
