// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "occlude/render/machine.h"
#include "scene_bench.h"

namespace occlude::experiments {

using Json = nlohmann::ordered_json;

render::Table table_of(const SceneBenchResult& result, const SceneBenchOptions& options) {
  render::Table table{.title = "A scene that streams",
                      .columns = spread_columns(fmt::format("{} frames", options.frames)),
                      .rows = {row_of("changes, ms", result.change_ms, 2), row_of("update, ms", result.update_ms, 2)}};
  for (std::size_t v = 0; v < result.views.size(); ++v) {
    std::ranges::move(rows_of(fmt::format("view {}: ", v + 1), result.views[v]), std::back_inserter(table.rows));
  }
  const WorldSize& world = options.world;
  table.notes = {
      fmt::format(
          "{} objects, {} of them in tiles that come and go, 1,000 in each frame, {} moving; {} occluders, {} moving.",
          result.objects, world.streamed, world.moving, result.occluders, world.moving_occluders),
      fmt::format("{:.0f} bytes an object; the whole world took {:.0f} ms to make.", result.bytes_of_object,
                  result.build_ms),
      fmt::format("{} frames checked: {} of {} objects culled otherwise than in a scene made anew; {} culls proved, {} not.",
                  result.frames_checked, result.different, result.objects_compared, result.proved, result.unproved),
      "One thread of " + text_of(render::this_machine()) + "."};
  return table;
}

std::string json_of(const SceneBenchResult& result, const SceneBenchOptions& options) {
  const WorldSize& world = options.world;
  Json views = Json::array();
  for (const ViewSpread& view : result.views) views.push_back(json_of(view));
  const Json json{{"objects", result.objects},
                  {"streamed", world.streamed},
                  {"moving", world.moving},
                  {"occluders", result.occluders},
                  {"moving_occluders", world.moving_occluders},
                  {"frames", options.frames},
                  {"seed", options.seed},
                  {"cover_size", {options.cover.width, options.cover.height}},
                  {"build_ms", result.build_ms},
                  {"bytes_of_object", result.bytes_of_object},
                  {"change_ms", json_of(result.change_ms)},
                  {"update_ms", json_of(result.update_ms)},
                  {"views", views},
                  {"checked",
                   {{"frames", result.frames_checked},
                    {"objects", result.objects_compared},
                    {"different", result.different},
                    {"proved", result.proved},
                    {"unproved", result.unproved}}},
                  {"machine", json_of(render::this_machine())}};
  return json.dump(2) + "\n";
}

}  // namespace occlude::experiments
