// SPDX-License-Identifier: MIT
// A picture of what a frame should have shown.
#pragma once

#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "occlude/culler/camera.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/render/image.h"
#include "occlude/render/scene_renderer.h"

namespace occlude::cli {

/// All polygons, those `marked` in magenta and with their outlines. REQUIRES: the renderer holds the soup.
[[nodiscard]] render::Image marked_picture(const culler::SoupView& soup, render::SceneRenderer& renderer,
                                           const culler::Camera& camera, const std::vector<culler::PolygonRange>& marked);

/// Rings in magenta around places in the picture, from its upper left corner, so that what has few pixels is found. Places
/// that are near one another have one.
void add_rings(render::Image& picture, std::span<const glm::dvec2> around);

}  // namespace occlude::cli
