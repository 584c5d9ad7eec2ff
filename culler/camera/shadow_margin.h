// SPDX-License-Identifier: MIT
// By how much shadows are made smaller for renderers that round: a rasteriser that snaps vertices to a grid draws borders a
// little beside where they are. Reading order: 8.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "occlude/culler/box.h"
#include "occlude/kernel/half_space.h"
#include "occlude/kernel/shadow_frustum.h"
#include "occlude/kernel/shadow_union.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

struct FrameView;    // camera/frame_view.h
class ShrunkShadow;  // frusta/shrunk_shadow.h

/// The shadow less the margin is the set of points that stay in the shadow under both of these moves:
/// 1. In the picture, by up to the margin. Each plane n . x >= d of the shadow, relative to the eye, becomes
///    (n - m |n_across| forward) . x >= d. Here n_across is the part of n perpendicular to the line of sight, and m the
///    margin at distance 1 along it. Sides move inwards; the near plane moves away from the eye by as much as its depth
///    changes over the margin. For parallel rays: n . x >= d + m |n_across|, where m is a length.
/// 2. In space, by up to `rounding`: the error with which a renderer in single precision places the occluder and the box. A
///    vertex of the occluder at v from the eye, w along the line of sight, is then off by up to
///    rounding |v| / (w (w - rounding)) in the picture, or by `rounding` along parallel rays. The largest of these is added
///    to m. And d grows by rounding |n| for the near plane, and by rounding |n'| for the box, n' being the new normal.
///
/// It is computed in doubles and has their rounding. That cannot make a cull wrong: the margin only takes away from what is
/// exactly in the shadow. Const calls may run on several threads at once.
///
/// Where the eye V of a camera is not known exactly (MatrixCamera), a box must be in the shadow from wherever it may be, V +
/// e with |e| <= d. Let all points within r = d (D + d) / (w - d) of a point b of the box be in the shadow from V, where the
/// corners of the silhouette are w or more along the line of sight and b is D or less. Then the segment from V + e to b
/// meets the occluder:
/// 1. The point at the share t of this segment is also at the share t of the segment from V to b(t) = b + e (1 - t) / t.
/// 2. From t0 = (w - d) / (D + d) on, b(t) is within r of b, so that the segment from V to b(t) meets the occluder. It
///    enters at a share a(t) <= 1. It passes the hull of the silhouette's corners, of the occluder or behind its surface, at
///    a share of w or more along the line of sight, which is t0 or more; so it leaves the occluder at c(t) >= t0.
/// 3. m(t) = max(a(t), min(c(t), t0)) is in the occluder, and continuous. It is at least t0 at t0, and at most 1 at 1. So
///    somewhere it is t.
/// The kernel decides exactly whether the box grown by r is in the shadow. With parallel rays points move by at most d, and
/// r is 2 d. Of two shadows together this is not true, as a gap may open between them: they hide nothing then.
class ShadowMargin {
 public:
  /// No margin: the shadow itself.
  ShadowMargin() = default;
  /// A margin of `share` times the height of the view's picture; no margin if `share` is 0. REQUIRES: share >= 0.
  ShadowMargin(const FrameView& view, double share);

  /// Whether shadows are not made smaller.
  [[nodiscard]] bool is_none() const { return size_ == 0 && eye_error_ == 0; }
  /// Whether the eye is one point, known exactly. Otherwise two shadows together hide nothing.
  [[nodiscard]] bool is_of_one_eye() const { return eye_error_ == 0; }

  /// Whether a box that is in the shadow is also in the shadow less the margin. False if the shadow is none.
  /// REQUIRES: the box is in the shadow; the shadow is from the view's viewpoint.
  [[nodiscard]] bool keeps(const kernel::ShadowFrustum& shadow, const kernel::Aabb& box) const;
  [[nodiscard]] bool keeps(const kernel::ShadowFrustum& shadow, const kernel::Obb& box) const;
  /// The same for the union of two shadows, if it is_of_one_eye(). Conservative: it may say no of a box that is in the union
  /// less the margin.
  [[nodiscard]] bool keeps(const kernel::ShadowUnion& shadows, const Box& box) const;

 private:
  friend class ShrunkShadow;

  /// Replaces `planes` with the planes of the shadow less the margin, relative to shadow.origin(); none if is_none(). What
  /// is in the shadow and in all of them is kept.
  void move_planes(const kernel::ShadowFrustum& shadow, std::vector<kernel::HalfSpace>& planes) const;
  /// Whether visit(plane) is true for all these planes. The first for which it is false is the last that is visited.
  template <class Visit>
  [[nodiscard]] bool all_moved_planes(const kernel::ShadowFrustum& shadow, const Visit& visit) const;
  [[nodiscard]] kernel::HalfSpace moved(const kernel::HalfSpace& plane, double size) const;
  /// Whether a box that is in the shadow is in it from wherever the eye may be.
  [[nodiscard]] bool holds_from_all_eyes(const kernel::ShadowFrustum& shadow, const kernel::Aabb& box) const;
  /// m of this shadow.
  [[nodiscard]] double size(const kernel::ShadowFrustum& shadow) const;
  /// Holds all that the box becomes by moves of up to m in the picture, and some more.
  [[nodiscard]] kernel::Aabb grown(const kernel::Aabb& box, double size) const;
  template <class AnyBox>
  [[nodiscard]] bool keeps_in(const kernel::ShadowFrustum& shadow, const AnyBox& box) const;

  glm::dvec3 eye_{0, 0, 0}, forward_{1, 0, 0};
  bool is_perspective_ = true;
  double size_ = 0, rounding_ = 0;  ///< m, and units of the scene
  double eye_error_ = 0;            ///< d
};

}  // namespace occlude::culler
