// SPDX-License-Identifier: MIT
// What a margin takes away from shadows, found from the definition (occlude/culler/shadow_margin.h) with no code of the
// culler's: corners of boxes are moved in the picture, as far as they may be, and measured against planes through the
// occluder's vertices.
#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "occlude/culler/camera.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/kernel/shadow_frustum.h"
#include "occlude/kernel/shadow_union.h"

namespace occlude::fuzz {

/// The margin is computed in numbers that round, and the depth of a model is known to the culler but roughly: between what
/// it may cull and what it must lies a little that it may cull or draw.
enum class Doubt { culls, draws };

class PictureMargin {
 public:
  /// `share` of the picture's height, in a model whose farthest vertex is so far away from the eye.
  PictureMargin(const culler::Camera& camera, double share, double farthest, Doubt doubt);

  /// Whether a box that is in the shadow is so with the margin.
  [[nodiscard]] bool keeps(const kernel::ShadowFrustum& shadow, const culler::Box& box) const;
  /// The same of two together, of which a culler with a margin must cull nothing: it asks a little more than it need, and
  /// not at all where only the margin reaches into one of the two.
  [[nodiscard]] bool keeps(const kernel::ShadowUnion& shadows, const culler::Box& box) const;

 private:
  /// Accurate enough for slivers.
  using Vector = glm::vec<3, long double>;

  /// By how much a point of this depth may be moved in the picture: units of the scene.
  [[nodiscard]] long double move(const kernel::ShadowFrustum& shadow, long double depth) const;
  [[nodiscard]] long double depth(const Vector& x) const;
  /// What is left of the least distance of a corner from a plane of the shadow.
  [[nodiscard]] long double slack(const kernel::ShadowFrustum& shadow, const std::vector<Vector>& corners) const;

  bool is_none_, is_perspective_;
  Vector eye_, right_, up_, forward_;
  long double size_, rounding_, doubtful_;
  Doubt doubt_;
};

}  // namespace occlude::fuzz
