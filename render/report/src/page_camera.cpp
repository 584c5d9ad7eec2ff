// SPDX-License-Identifier: MIT
#include "page_camera.h"

#include <cmath>
#include <nlohmann/json.hpp>

namespace occlude::render {

nlohmann::ordered_json page_json(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

nlohmann::ordered_json page_lens(const culler::Camera& camera) {
  // JSON has no infinity.
  const nlohmann::ordered_json far = std::isfinite(camera.far_plane) ? nlohmann::ordered_json(camera.far_plane) : nullptr;
  return {{"projection", camera.projection == culler::Projection::perspective ? "perspective" : "orthographic"},
          {"fov_y_deg", camera.fov_y_deg},
          {"height", camera.height},
          {"aspect", camera.aspect},
          {"near", camera.near_plane},
          {"far", far},
          {"up", page_json(camera.up)}};
}

}  // namespace occlude::render
