// SPDX-License-Identifier: MIT
// The page in which one walks through a model while the culler culls each frame: one HTML file, which needs no other and no
// network.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "occlude/culler/camera.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/render/camera_path.h"

namespace occlude::render {

/// Models with more polygons are not for pages.
inline constexpr std::size_t kMostLivePolygons = 2'000'000;

/// Where one walks, and how fast.
struct LiveStart {
  std::vector<culler::Camera> cameras;  ///< the first is where one starts; the others can be flown along
  double speed = 1;                     ///< model units a second
};

/// All cameras of a path, at the speed of a film of it with 30 frames a second.
[[nodiscard]] LiveStart start_of(const CameraPath& path, culler::SoupView model);

/// Before the model and above it.
[[nodiscard]] LiveStart start_beside(culler::SoupView model);

/// `module` is what render/live/build.sh builds. REQUIRES: at most kMostLivePolygons.
[[nodiscard]] std::string live_page(const std::string& name, culler::SoupView model, const LiveStart& start,
                                    const std::string& module);

}  // namespace occlude::render
