// SPDX-License-Identifier: MIT
#include "occlude/render/log_line.h"

#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <vector>

#include "model/append_range.h"

namespace occlude::render {
namespace {

nlohmann::ordered_json numbers(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

std::vector<culler::PolygonRange> drawn(const culler::CullResult& result, const culler::Hierarchy& hierarchy) {
  std::vector<bool> is_drawn(hierarchy.face_count());
  for (const culler::PolygonRange& range : result.drawn) {
    for (std::uint32_t p = range.first; p < range.first + range.count; ++p) is_drawn[hierarchy.face(p)] = true;
  }
  std::vector<culler::PolygonRange> ranges;
  for (std::uint32_t p = 0; p < is_drawn.size(); ++p) {
    if (is_drawn[p]) culler::append_range(ranges, {p, 1});
  }
  return ranges;
}

}  // namespace

std::string log_line(const ShownFrame& frame, const culler::Hierarchy& hierarchy, const WalkOptions& options) {
  const culler::Camera& camera = frame.camera;
  nlohmann::ordered_json line{{"frame", frame.record.frame},      {"eye", numbers(camera.eye)},
                              {"target", numbers(camera.target)}, {"up", numbers(camera.up)},
                              {"near", camera.near_plane},        {"width", options.width},
                              {"height", options.height}};
  if (std::isfinite(camera.far_plane)) line["far"] = camera.far_plane;
  if (camera.projection == culler::Projection::orthographic) {
    line["projection"] = "orthographic";
    line["view_height"] = camera.height;
  } else {
    line["fov_y_deg"] = camera.fov_y_deg;
  }
  nlohmann::ordered_json& list = line["drawn"] = nlohmann::ordered_json::array();
  for (const culler::PolygonRange& range : drawn(frame.culled, hierarchy)) list.push_back({range.first, range.count});
  return line.dump();
}

}  // namespace occlude::render
