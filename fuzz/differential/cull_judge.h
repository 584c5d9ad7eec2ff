// SPDX-License-Identifier: MIT
// What culling promises, held against what a frame culled.
#pragma once

#include <string>

#include "occlude/culler/culler.h"

namespace occlude::fuzz {

/// What is wrong with `result`, which culler.cull(camera, options) gave; empty when nothing is. Whatever the options: every
/// polygon is drawn, or in a culled subtree, exactly once; without occluders nothing less is drawn; the counts are right. Of
/// certified arithmetic also: every subtree culled by view is exactly beyond its half-space, which cuts nothing off that the
/// camera shows, and every one culled by shadow is exactly in the shadow of its occluder, or of its two together, and
/// strictly beyond the near plane, an occluder being polygons outside of it that hide what it does and that the camera's
/// near plane does not clip. Of one culled by cover the polygons that the culler names hide it, by the oracle.
[[nodiscard]] std::string fault_of(const culler::Culler& culler, const culler::Camera& camera,
                                   const culler::CullOptions& options, const culler::CullResult& result);

}  // namespace occlude::fuzz
