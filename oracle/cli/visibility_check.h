// SPDX-License-Identifier: MIT
// The culled polygons held against what the frame shows: exactly, where the model is small, or else in item buffers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "culled_sets.h"
#include "item_buffers.h"
#include "occlude/culler/culler.h"
#include "occlude/render/camera_path.h"
#include "turns.h"

namespace occlude::cli {

/// A frame's polygons: how many pass view-frustum culling, are drawn, show, and are culled and show; and of those that pass
/// view-frustum culling and do not show, how many there are and how many are culled.
struct FrameVisibility {
  std::size_t frame = 0;
  std::size_t in_view = 0, drawn = 0, visible = 0, false_culls = 0;
  std::size_t hidden = 0, hidden_culled = 0;
  std::size_t wrong_pixels = 0;  ///< of the item buffer, that show what is culled
  std::vector<bool> shows;       ///< of each polygon of the tree; only of reference frames
};

/// A polygon that is culled and shows.
struct FalseCull {
  std::size_t frame = 0;
  std::uint32_t polygon = 0;  ///< of the tree
  std::size_t witness = 0;    ///< number of the line that culls it
  std::string where;          ///< how it was seen
};

struct Visibility {
  std::vector<FrameVisibility> frames;
  std::vector<FalseCull> false_culls;  ///< of each frame the first 64
};

/// The walk whose frames are checked.
struct CheckedWalk {
  const culler::Culler& culler;
  const render::CameraPath& path;
  double aspect;  ///< of the pictures, width over height
  Turns turns;
};

/// In exact arithmetic, on all processors; a polygon shows where any of its triangles does.
[[nodiscard]] Visibility check_exactly(const CheckedWalk& walk, const CulledSets& culled);

/// By an item buffer of each frame, of the whole model: what culls it has no say in what is drawn.
[[nodiscard]] Visibility check_rendered(const CheckedWalk& walk, const CulledSets& culled, ItemBuffers& buffers);

}  // namespace occlude::cli
