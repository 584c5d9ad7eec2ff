// SPDX-License-Identifier: MIT
// A frame from outside: from above and behind its camera.
#pragma once

#include <optional>
#include <vector>

#include "occlude/culler/culler.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/render/plate_renderer.h"
#include "occlude/render/scene_renderer.h"

namespace occlude::render {

/// The depth of the interesting part of a frame: two fifths of the drawn polygons are nearer, most others far and small.
[[nodiscard]] double depth_of_scene(const culler::Culler& culler, const culler::Camera& camera,
                                    const std::vector<PolygonRange>& drawn);

/// A camera above and behind `camera` that looks down on its view as far as `depth`.
[[nodiscard]] culler::Camera outside_camera(const culler::Camera& camera, double depth);

/// Opens a building, so that the eye of `outside` sees the camera: at half the height above it of what is between the two;
/// none if nothing is. `renderer` holds the polygons of the soup.
[[nodiscard]] std::optional<Cut> cut_between(const culler::Camera& camera, const culler::Camera& outside,
                                             SceneRenderer& renderer, culler::SoupView soup);

/// The edges of the view frustum out to `depth`.
void add_frustum(std::vector<Line>& lines, const culler::Camera& camera, double depth);

/// The side edges of a shadow frustum, from the occluder's corners to `depth` beyond.
void add_shadow(std::vector<Line>& lines, const culler::Occluder& occluder, const culler::Camera& camera, double depth);

}  // namespace occlude::render
