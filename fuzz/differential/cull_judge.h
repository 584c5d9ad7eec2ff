// SPDX-License-Identifier: MIT
// Checks what a frame culled against what culling promises.
#pragma once

#include <string>

#include "occlude/culler/culler.h"
#include "proof/camera_picture.h"

namespace occlude::fuzz {

/// What is wrong with `result`, which culler.cull(camera, options) returned. Empty when nothing is. With any options these
/// must hold: every polygon is drawn, or in a culled subtree, exactly once; without occluders nothing less is drawn; the
/// counts are right. With certified arithmetic these must also hold:
/// - A subtree culled by view is exactly beyond its half-space, which does not cut off anything that the camera shows.
/// - A subtree culled by shadow is exactly in the shadow of its occluder, or of its two occluders together, and strictly
///   beyond the near plane. An occluder consists of polygons outside of the subtree that hide what it hides and that the
///   camera's near plane does not clip.
/// - A subtree culled by cover is hidden by the polygons that the culler names, by the oracle. Of a camera with several eyes
///   some are asked, each as far away as it may be.
[[nodiscard]] std::string fault_of(const culler::Culler& culler, const proof::AnyCamera& camera,
                                   const culler::CullOptions& options, const culler::CullResult& result);

}  // namespace occlude::fuzz
