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

/// Half the height above the camera of what is between it and the eye of `outside`; none if nothing is. `renderer` holds the
/// polygons of the soup.
[[nodiscard]] std::optional<double> cut_height(const culler::Camera& camera, const culler::Camera& outside,
                                               SceneRenderer& renderer, culler::SoupView soup);

/// The polygons of the ranges that are not wholly more than `height` above the camera, so that one looks into a building.
[[nodiscard]] std::vector<PolygonRange> cut_away(const std::vector<PolygonRange>& ranges, const culler::Camera& camera,
                                                 double height, culler::SoupView soup);

/// The edges of the view frustum out to `depth`.
void add_frustum(std::vector<Line>& lines, const culler::Camera& camera, double depth);

/// The side edges of a shadow frustum, from the occluder's corners to `depth` beyond.
void add_shadow(std::vector<Line>& lines, const culler::Occluder& occluder, const culler::Camera& camera, double depth);

}  // namespace occlude::render
