// SPDX-License-Identifier: MIT
// The shadow frustum of an occluder (section 5 of the paper): what a convex polygon hides from a viewpoint. Reading
// order: 5.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "occlude/kernel/types.h"
#include "occlude/kernel/validity.h"

namespace occlude::kernel {

/// Where the shadow begins.
/// `farthest` (the paper's): at the plane through the silhouette vertex p farthest from the eye, normal to the line from the
/// eye to p; farthest along the direction of view for orthographic views. On a tie the lowest index in the input counts.
/// `surface` (tighter): at the polygon itself. A polygon that is not exactly coplanar is drawn as its fan of triangles; its
/// shadow begins at a support plane beyond all its vertices.
enum class Near { farthest, surface };

/// An oriented plane given by input coordinates alone: f(x) = N . (x - origin), N = a cross b or, when `direct`, N = a, with
/// a = a_to - a_from and b = b_to - b_from taken exactly. The inner side is f >= 0.
struct ExactPlane {
  bool direct = false;
  Vec3 a_to, a_from, b_to, b_from, origin;
};

/// The same plane in doubles: |f(x) - fl(normal . (x - origin))| <= bound * max_k |x - origin|_k (error_bounds.h).
struct FilterPlane {
  Vec3 normal, origin;
  double bound = 0;
};

/// The near plane as numbers, for those who prove a cull from the outside: shadow where normal . (x - point) >= 0.
struct SupportPlane {
  Vec3 normal, point;
};

struct ShadowFrustumResult;

class ShadowFrustum {
 public:
  /// Builds the frustum of the convex polygon `loop` (in order, either way round) seen from `viewpoint`, any number of
  /// sides. Everything is decided exactly; repeated vertices and vertices in line with their neighbours change nothing.
  /// Refuses, with the reason, non-finite or out-of-range numbers, fewer than three distinct silhouette vertices, a loop
  /// that is not convex seen from the viewpoint, a viewpoint in the polygon's plane, a zero direction.
  [[nodiscard]] static ShadowFrustumResult make(const Viewpoint& viewpoint, std::span<const Vec3> loop, Near near);

  [[nodiscard]] const Viewpoint& viewpoint() const { return viewpoint_; }
  /// The corners that matter, turning counter-clockwise seen from the viewpoint: side i passes through corners i, i + 1.
  [[nodiscard]] std::span<const Vec3> silhouette() const { return silhouette_; }
  /// All planes, the near plane first, then the sides.
  [[nodiscard]] std::span<const ExactPlane> exact_planes() const { return exact_planes_; }
  [[nodiscard]] std::span<const FilterPlane> filter_planes() const { return filter_planes_; }
  /// Whether the near plane is the polygon's own, exactly: then its edges are the polygon's.
  [[nodiscard]] bool near_is_polygon() const { return near_is_polygon_; }
  /// The support plane chosen for `surface` when the polygon is not exactly coplanar.
  [[nodiscard]] const std::optional<SupportPlane>& support_plane() const { return support_plane_; }

 private:
  Viewpoint viewpoint_;
  std::vector<Vec3> silhouette_;
  std::vector<ExactPlane> exact_planes_;
  std::vector<FilterPlane> filter_planes_;
  std::optional<SupportPlane> support_plane_;
  bool near_is_polygon_ = false;
};

/// A frustum, or why there is none.
struct ShadowFrustumResult {
  std::optional<ShadowFrustum> frustum;
  Refusal refusal = Refusal::none;
};

}  // namespace occlude::kernel
