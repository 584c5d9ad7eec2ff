// SPDX-License-Identifier: MIT
#include "page_camera.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace occlude::render {

nlohmann::ordered_json page_json(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

nlohmann::ordered_json page_lens(const culler::Camera& camera) {
  // JSON has no infinity.
  nlohmann::ordered_json lens{{"aspect", camera.aspect}, {"near", camera.near_plane}, {"up", page_json(camera.up)}};
  if (camera.projection == culler::Projection::perspective) {
    lens["fovY"] = camera.fov_y_deg;
  } else {
    lens["height"] = camera.height;
  }
  if (std::isfinite(camera.far_plane)) lens["far"] = camera.far_plane;  // JSON has no infinity
  return lens;
}

}  // namespace occlude::render
