// SPDX-License-Identifier: MIT
// What a margin takes away from shadows. It is found from the definition (camera/shadow_margin.h) without the
// culler's code: the corners of boxes are moved in the picture as far as they may be, and measured against planes through
// the vertices of the occluder.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "occlude/culler/camera.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/kernel/shadow_frustum.h"
#include "occlude/kernel/shadow_union.h"

namespace occlude::fuzz {

/// The margin is computed with rounding, and the culler knows the depth of a model only roughly. So there is a narrow range
/// in which the culler may cull or draw. `culls` counts that range as culled, `draws` as drawn.
enum class Doubt { culls, draws };

class PictureMargin {
 public:
  /// `share` is of the height of the picture. `farthest` is the distance from the eye to the farthest vertex of the model.
  PictureMargin(const culler::Camera& camera, double share, double farthest, Doubt doubt);

  /// Whether a box that is in the shadow is also in the shadow with the margin.
  [[nodiscard]] bool keeps(const kernel::ShadowFrustum& shadow, const culler::Box& box) const;
  /// The same for two shadows together. Never true for Doubt::draws, because with a margin the culler need not cull anything
  /// by two shadows: it asks for a little more than necessary, and does not ask when only the margin reaches into one of the
  /// two.
  [[nodiscard]] bool keeps(const kernel::ShadowUnion& shadows, const culler::Box& box) const;

 private:
  /// Long doubles are accurate enough for slivers.
  using Vector = glm::vec<3, long double>;

  /// The distance that a point of this depth may be moved in the picture, in units of the scene.
  [[nodiscard]] long double move(const kernel::ShadowFrustum& shadow, long double depth) const;
  [[nodiscard]] long double depth(const Vector& x) const;
  /// The least distance from a moved corner to a plane of the shadow, minus the rounding.
  [[nodiscard]] long double slack(const kernel::ShadowFrustum& shadow, const std::vector<Vector>& corners) const;

  bool is_none_, is_perspective_;
  Vector eye_, right_, up_, forward_;
  long double size_, rounding_, doubtful_;
  Doubt doubt_;
};

}  // namespace occlude::fuzz
