// SPDX-License-Identifier: MIT
#include "occlude/render/live_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>

#include "deflated.h"
#include "occlude/culler/cull_result.h"
#include "occlude/render/formats.h"
#include "packed_soup.h"
#include "page_camera.h"
#include "page_files.h"
#include "template.h"

namespace occlude::render {
namespace {

constexpr double kAspect = 16.0 / 9;
/// The height of the picture for which margins are pixels: that of a walk.
constexpr int kHeight = 360;
/// One tree for both methods: frusta find more with small leaves as well, and take a little longer.
constexpr std::uint32_t kLeafSize = culler::leaf_size_for(culler::Method::cover);

struct Extent {
  glm::dvec3 middle;
  double size;
};

Extent extent_of(culler::SoupView model) {
  glm::dvec3 low = model.vertices[model.indices[0]], high = low;
  for (const std::uint32_t index : model.indices) {
    low = glm::min(low, model.vertices[index]);
    high = glm::max(high, model.vertices[index]);
  }
  return {0.5 * (low + high), glm::length(high - low)};
}

/// A walk through all of it in so many seconds, where no path tells.
constexpr double kSecondsThrough = 40;

std::string start_json(const std::string& model, const LiveStart& start) {
  nlohmann::ordered_json eyes = nlohmann::ordered_json::array(), targets = eyes;
  for (const culler::Camera& camera : start.cameras) {
    eyes.push_back(page_json(camera.eye));
    targets.push_back(page_json(camera.target));
  }
  const nlohmann::ordered_json json = {{"model", model},       {"lens", page_lens(start.cameras.front())},
                                       {"height", kHeight},    {"leaf", kLeafSize},
                                       {"speed", start.speed}, {"eyes", eyes},
                                       {"targets", targets}};
  return json.dump();
}

}  // namespace

LiveStart start_of(const CameraPath& path, culler::SoupView model) {
  LiveStart start;
  double length = 0;
  for (std::size_t frame = 0; frame < path.frames; ++frame) {
    start.cameras.push_back(path.camera(frame, kAspect));
    start.cameras.back().up = path.up;  // who walks keeps upright
    if (frame > 0) length += glm::distance(start.cameras[frame - 1].eye, start.cameras[frame].eye);
  }
  constexpr double kFramesASecond = 30;
  start.speed =
      length > 0 ? kFramesASecond * length / static_cast<double>(path.frames - 1) : extent_of(model).size / kSecondsThrough;
  return start;
}

LiveStart start_beside(culler::SoupView model) {
  const auto [middle, size] = extent_of(model);
  const double length = size > 0 ? size : 1;  // a model may be a point
  culler::Camera camera;
  camera.eye = middle + length * glm::dvec3{-0.5, -0.7, 0.4};
  camera.target = middle;
  camera.aspect = kAspect;
  camera.near_plane = std::min(camera.near_plane, length / 1000);
  return {{camera}, length / kSecondsThrough};
}

std::string live_page(const std::string& name, culler::SoupView model, const LiveStart& start, const std::string& module) {
  const std::map<std::string_view, std::function<std::string()>> values{
      {"model", [&] { return escaped(name); }},
      {"lead",
       [&] {
         return fmt::format("{} polygons; every frame is culled here, while you walk.",
                            grouped(static_cast<double>(model.size())));
       }},
      {"leaf", [] { return fmt::format("{}", kLeafSize); }},
      {"version", [] { return std::string(OCCLUDE_VERSION); }},
      {"parts", [&] {
         return page_part("start", start_json(name, start)) + page_part("module", module) +
                page_part("model", packed(model));
       }}};
  return filled(page_file("live.html"), [&](std::string_view value) {
    const auto found = values.find(value);
    return found == values.end() ? std::string(page_file(value)) : found->second();
  });
}

}  // namespace occlude::render
