// SPDX-License-Identifier: MIT
// Compares the culled polygons with what the frame shows: exactly for a small model, else in item buffers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "culled_sets.h"
#include "item_buffers.h"
#include "occlude/culler/culler.h"
#include "occlude/render/camera_path.h"
#include "turns.h"

namespace occlude::cli {

/// Counts of the polygons of a frame. `in_view` pass view-frustum culling, `visible` are visible, `false_culls` are culled
/// and visible. `hidden` pass view-frustum culling and are not visible. `hidden_culled` are those of them that are culled.
struct FrameVisibility {
  std::size_t frame = 0;
  std::size_t in_view = 0, drawn = 0, visible = 0, false_culls = 0;
  std::size_t hidden = 0, hidden_culled = 0;
  std::size_t wrong_pixels = 0;  ///< pixels of the item buffer that show something culled
  std::vector<bool> shows;       ///< for each polygon of the tree; only for reference frames
};

/// A polygon that is culled and visible.
struct FalseCull {
  std::size_t frame = 0;
  std::uint32_t polygon = 0;  ///< its index in the tree
  std::size_t witness = 0;    ///< the number of the line that culls it
};

/// False culls of a frame that are named, and not only counted.
inline constexpr std::size_t kNamed = 64;

struct Visibility {
  std::vector<FrameVisibility> frames;
  std::vector<FalseCull> false_culls;  ///< the first kNamed of each frame
};

/// The walk whose frames are checked.
struct CheckedWalk {
  const culler::Culler& culler;
  const render::CameraPath& path;
  double aspect;  ///< width over height of the pictures
  Turns turns;
};

/// Checks in exact arithmetic, on all processors. A polygon is visible when any of its triangles is.
[[nodiscard]] Visibility check_exactly(const CheckedWalk& walk, const CulledSets& culled);

/// Checks with an item buffer of each frame. It shows the whole model, so the culling does not influence what is drawn.
[[nodiscard]] Visibility check_rendered(const CheckedWalk& walk, const CulledSets& culled, ItemBuffers& buffers);

}  // namespace occlude::cli
