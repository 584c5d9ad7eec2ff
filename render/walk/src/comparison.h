// SPDX-License-Identifier: MIT
// Checks a frame's culling by comparing pictures.
#pragma once

#include "occlude/culler/culler.h"
#include "occlude/render/image.h"
#include "occlude/render/walk.h"

namespace occlude::render {

/// A picture of a frame and its item buffer.
struct Picture {
  Image image;
  ItemBuffer items;
};

/// Fills visible_polygons, wrong_pixels, snapped_pixels and false_culls of `record`. `full` is the picture with
/// view-frustum culling alone, or of the whole model; `culled` the picture with occlusion culling as `result` left it.
/// Returns the visible polygons, ascending.
std::vector<std::uint32_t> compare(const Picture& full, const Picture& culled, const culler::Culler& culler,
                                   const culler::Camera& camera, const culler::CullResult& result, FrameRecord& record);

}  // namespace occlude::render
