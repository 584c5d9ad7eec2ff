// SPDX-License-Identifier: MIT
// Whether a frame that is there already does for a camera.
#pragma once

#include "camera/frame_view.h"
#include "occlude/culler/camera.h"

namespace occlude::culler {

/// As View::holds_for(), for a frame of this view. Throws as require_sound(). The eye may be off by as much as `eye_error`.
[[nodiscard]] bool holds_for(const FrameView& frame, const Camera& camera, double eye_error = 0);
[[nodiscard]] bool holds_for(const FrameView& frame, const MatrixCamera& camera);

}  // namespace occlude::culler
