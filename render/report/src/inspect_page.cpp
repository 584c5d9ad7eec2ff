// SPDX-License-Identifier: MIT
#include "occlude/render/inspect_page.h"

#include <nlohmann/json.hpp>
#include <utility>

#include "deflated.h"
#include "packed_soup.h"
#include "page_camera.h"

namespace occlude::render {
namespace {

/// Where culler/js/page/index.html takes a model.
constexpr std::string_view kPlace = "<!-- The model of `occlude inspect` -->\n";

/// As culler/js/page/src/inside.mts reads it.
nlohmann::ordered_json path_json(const CameraPath& path) {
  nlohmann::ordered_json places = nlohmann::ordered_json::array();
  for (std::size_t frame = 0; frame < path.frames; ++frame) {
    const culler::Camera camera = path.camera(frame, 1);
    places.push_back({{"eye", page_json(camera.eye)}, {"target", page_json(camera.target)}});
  }
  constexpr double kFramesASecond = 30;
  return {{"places", std::move(places)},
          {"seconds", static_cast<double>(path.frames - 1) / kFramesASecond},
          {"lens", {{"fovY", path.fov_y_deg}, {"near", path.near}}}};
}

}  // namespace

bool is_inspect_page(std::string_view page) { return page.find(kPlace) != std::string_view::npos; }

std::string inspect_page(std::string_view page, const Inspected& inspected) {
  const auto& [name, model, colours, up, path] = inspected;
  const PackedSoup soup = packed(model, colours);
  nlohmann::ordered_json start = {
      {"name", name}, {"origin", page_json(soup.origin)}, {"up", page_json(path ? path->up : up)}};
  if (path) start["path"] = path_json(*path);
  const std::string parts = page_part("start", start.dump()) + page_part("model", soup.bytes);
  return std::string(page).replace(page.find(kPlace), kPlace.size(), parts);
}

}  // namespace occlude::render
