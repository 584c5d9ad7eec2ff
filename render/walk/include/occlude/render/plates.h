// SPDX-License-Identifier: MIT
// The paper's plates: the view of the camera, and the same frame from outside with the culled polygons in colour.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
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

/// Whether a file of plates/ is called as those of draw_plates().
[[nodiscard]] bool is_plate(const std::string& name);
/// The frame of a plate from outside; none if the name is not that of one.
[[nodiscard]] std::optional<std::size_t> frame_of_outside_plate(const std::string& name);

/// The view of the camera and a view from outside, for up to four of `frames`: those in which the most is culled, the most
/// is drawn in vain, the most is seen, and one with the usual share of culled polygons. Each is culled as in the walk, after
/// the same frames. Plates are twice as large as the walk's pictures, as far as that fits into 1280x720.
/// REQUIRES: frames; an OffscreenContext current on this thread.
[[nodiscard]] std::vector<DrawnPlate> draw_plates(const culler::Culler& culler, const CameraPath& path,
                                                  const std::vector<FrameRecord>& frames, const WalkOptions& options);

/// The view of the camera with the polygon (magenta), its node (red) and the occluder (orange); and the same from outside.
struct WhyPlates {
  Image view, outside;
};

/// REQUIRES: an OffscreenContext current on this thread.
[[nodiscard]] WhyPlates draw_why(const ReplayedFrame& frame, const Account& account);

}  // namespace occlude::render
