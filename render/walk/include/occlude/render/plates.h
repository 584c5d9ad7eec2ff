// SPDX-License-Identifier: MIT
// The paper's plates: what the camera sees, and the same moment from outside with what was culled in colour.
#pragma once

#include <vector>

#include "occlude/culler/culler.h"
#include "occlude/render/image.h"
#include "occlude/render/walk.h"
#include "occlude/render/why.h"

namespace occlude::render {

struct DrawnPlate {
  Plate plate;
  Image image;
};

/// A street view and a view from outside for each of up to four of `frames`, spread over them.
/// REQUIRES: an OffscreenContext current on this thread.
[[nodiscard]] std::vector<DrawnPlate> draw_plates(const culler::Culler& culler, const CameraPath& path,
                                                  const std::vector<FrameRecord>& frames,
                                                  const culler::CullOptions& options);

/// What the camera sees, with the polygon (magenta), its node (red) and the occluder (orange); and the same from outside,
/// with what was culled by shadow (red).
struct WhyPlates {
  Image view, outside;
};

/// REQUIRES: an OffscreenContext current on this thread.
[[nodiscard]] WhyPlates draw_why(const ReplayedFrame& frame, const Account& account);

}  // namespace occlude::render
