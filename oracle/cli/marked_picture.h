// SPDX-License-Identifier: MIT
// A picture of what a frame should have shown.
#pragma once

#include <vector>

#include "occlude/culler/camera.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/render/image.h"
#include "occlude/render/scene_renderer.h"

namespace occlude::cli {

/// All polygons, those `marked` in magenta and with their outlines. REQUIRES: the renderer holds the soup.
[[nodiscard]] render::Image marked_picture(const culler::SoupView& soup, render::SceneRenderer& renderer,
                                           const culler::Camera& camera, const std::vector<culler::PolygonRange>& marked);

}  // namespace occlude::cli
