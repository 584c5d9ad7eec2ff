// SPDX-License-Identifier: MIT
// Averages over the frames of a walk.
#pragma once

#include <algorithm>
#include <functional>

#include "occlude/render/walk.h"

namespace occlude::render {

/// Of a member of FrameRecord, or of what a function makes of one. REQUIRES: at least one frame.
template <class Member>
[[nodiscard]] double mean(const WalkResult& result, Member&& member) {
  double sum = 0;
  for (const FrameRecord& record : result.frames) sum += static_cast<double>(std::invoke(member, record));
  return sum / static_cast<double>(result.frames.size());
}

/// Polygons that pass the view frustum and have no pixel in the item buffer.
[[nodiscard]] inline double mean_hidden(const WalkResult& result) {
  return mean(result, [](const FrameRecord& r) {
    return r.view_frustum_polygons - std::min(r.view_frustum_polygons, r.visible_polygons);
  });
}

}  // namespace occlude::render
