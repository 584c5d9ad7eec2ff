// SPDX-License-Identifier: MIT
#include "plain_edges.h"

#include <cstddef>

#include "plane_coefficients.h"
#include "scratch.h"

namespace occlude::kernel {
namespace {

using Plain = PlainArithmetic;
using Vector = Vector3<double>;

Vec3 point(const Vector& v) { return {v.x, v.y, v.z}; }

void add_cap_edges(const ShadowFrustum& frustum, std::vector<PlainEdge>& edges) {
  const auto relative = [&](const Vec3& v) { return point(difference<Plain>(v, frustum.origin())); };
  for (std::size_t i = 0; i < frustum.silhouette().size(); ++i) {
    edges.push_back({relative(frustum.silhouette()[i]), point(ray<Plain>(frustum, i)), true});
  }
  for (const auto& edge : frustum.cap_edges()) edges.push_back({relative(edge.from), relative(edge.to), false});
}

/// A frustum's ray of one corner, and where the near plane cuts it, if it does.
struct CutRay {
  Vector direction, start;
  double speed;  ///< of the near plane's value along the ray; it is cut when positive
};

CutRay cut_ray(const ShadowFrustum& frustum, std::size_t corner) {
  const auto near = coefficients<Plain>(frustum, plane_of(frustum, 0));
  const auto d = ray<Plain>(frustum, corner);
  const auto s = difference<Plain>(frustum.silhouette()[corner], frustum.origin());
  const double speed = dot(near.normal, d);
  return {d, s - (dot(near.normal, s) + near.offset) / speed * d, speed};
}

/// Between a ray that reaches the near plane and one that does not, the near side runs to infinity, parallel to the near
/// plane.
void add_cut_edges(const ShadowFrustum& frustum, std::vector<PlainEdge>& edges) {
  Scratch scratch;
  std::pmr::vector<CutRay> rays(&scratch.memory());
  for (std::size_t i = 0; i < frustum.silhouette().size(); ++i) rays.push_back(cut_ray(frustum, i));
  for (std::size_t i = 0; i < rays.size(); ++i) {
    const CutRay &a = rays[i], &b = rays[(i + 1) % rays.size()];
    if (a.speed > 0) edges.push_back({point(a.start), point(a.direction), true});
    if (a.speed > 0 && b.speed > 0) {
      edges.push_back({point(a.start), point(b.start), false});
    } else if (a.speed > 0) {
      edges.push_back({point(a.start), point(a.speed * b.direction - b.speed * a.direction), true});
    } else if (b.speed > 0) {
      edges.push_back({point(b.start), point(b.speed * a.direction - a.speed * b.direction), true});
    }
  }
}

}  // namespace

void append_plain_edges(const ShadowFrustum& frustum, std::vector<PlainEdge>& edges) {
  if (frustum.is_cut()) {
    add_cut_edges(frustum, edges);
  } else {
    add_cap_edges(frustum, edges);
  }
}

}  // namespace occlude::kernel
