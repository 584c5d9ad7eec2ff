// SPDX-License-Identifier: MIT
// How much smaller than it is a shadow is taken, for renderers that round: a rasteriser with vertices on a grid draws
// borders a little beside where they are. Reading order: 8.
#pragma once

#include <glm/vec3.hpp>

#include "occlude/culler/box.h"
#include "occlude/kernel/shadow_frustum.h"
#include "occlude/kernel/shadow_union.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

struct FrameView;

/// The shadow less the margin is what stays in the shadow however it is moved by up to the margin in the picture. So each
/// plane n . x >= d of it, relative to the eye, becomes (n - m |n_across| forward) . x >= d, n_across being the part of n
/// across the line of sight and m the margin at distance 1 along it: sides move inwards, and the near plane away from the
/// eye by what its depth changes along the margin. For parallel rays n . x >= d + m |n_across|, m a length.
///
/// And it is what stays in the shadow when the renderer, in single precision, has positions out by up to `rounding`, those
/// of the occluder and those of the box. An occluder that is w away then casts a shadow that is out by rounding / w in the
/// picture, which is added to m, and d grows by 2 rounding |n|.
///
/// Computed in doubles: the margin is a promise to a renderer that rounds, and takes away from what is exactly in the
/// shadow.
class ShadowMargin {
 public:
  /// None: the shadow itself.
  ShadowMargin() = default;
  /// `share` of the height of the view's picture; none if the share is 0. REQUIRES: share >= 0.
  ShadowMargin(const FrameView& view, double share);

  [[nodiscard]] bool is_none() const { return size_ == 0; }

  /// Whether a box that is in the shadow is so with the margin. REQUIRES: a shadow from the camera's viewpoint.
  [[nodiscard]] bool keeps(const kernel::ShadowFrustum& shadow, const kernel::Aabb& box) const;
  [[nodiscard]] bool keeps(const kernel::ShadowFrustum& shadow, const kernel::Obb& box) const;
  /// The same of two shadows together; now and then not, where it is.
  [[nodiscard]] bool keeps(const kernel::ShadowUnion& shadows, const Box& box) const;

 private:
  /// m of this shadow.
  [[nodiscard]] double size(const kernel::ShadowFrustum& shadow) const;
  /// Holds all that the box becomes by moves of up to m in the picture, and some more.
  [[nodiscard]] kernel::Aabb grown(const kernel::Aabb& box, double size) const;
  template <class AnyBox>
  [[nodiscard]] bool keeps_in(const kernel::ShadowFrustum& shadow, const AnyBox& box) const;

  glm::dvec3 eye_{0, 0, 0}, forward_{1, 0, 0};
  bool is_perspective_ = true;
  double size_ = 0, rounding_ = 0;  ///< m, and units of the scene
};

}  // namespace occlude::culler
