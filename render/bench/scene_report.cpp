// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "occlude/render/machine.h"
#include "scene_bench.h"

namespace occlude::experiments {

using Json = nlohmann::ordered_json;

namespace {

/// A budget, or none if it is as large as can be.
template <class Number>
Json budget(Number of_cull, Number none) {
  return of_cull == none ? Json() : Json(of_cull);
}

std::string budget_of(const culler::CoverOptions& cover) {
  const culler::CoverOptions none;
  if (!has_budget(cover)) return "Culls have no budget.";
  std::string text = "The budget of a cull is";
  if (cover.ms != none.ms) text += fmt::format(" {} ms", cover.ms);
  if (cover.work != none.work) text += fmt::format("{} the work of {} boxes", cover.ms != none.ms ? " and" : "", cover.work);
  return text + ". Culls are proved, and not compared with a scene made anew.";
}

}  // namespace

render::Table table_of(const SceneBenchResult& result, const SceneBenchOptions& options) {
  render::Table table{.title = "A scene that streams",
                      .columns = spread_columns(fmt::format("{} frames", options.frames)),
                      .rows = {row_of("changes, ms", result.change_ms, 2), row_of("update, ms", result.update_ms, 2)}};
  for (std::size_t v = 0; v < result.views.size(); ++v) {
    const std::string of = fmt::format("view {}: ", v + 1);
    const SceneViewResult& view = result.views[v];
    std::ranges::move(rows_of(of, view.spread), std::back_inserter(table.rows));
    table.rows.push_back(row_of(of + "view frustum alone, ms", view.view_frustum_ms, 2));
    table.notes.push_back(fmt::format("{}{:.1f} % of the objects in view hidden.", of, 100 * view.hidden_share));
  }
  const WorldSize& world = options.world;
  const std::vector<std::string> notes{
      budget_of(options.cover),
      fmt::format(
          "{} objects, {} of them in tiles that come and go, 1,000 in each frame, {} moving; {} occluders, {} moving.",
          result.objects, world.streamed, world.moving, result.occluders, world.moving_occluders),
      fmt::format("{:.0f} bytes an object; the whole world took {:.0f} ms to make.", result.bytes_of_object,
                  result.build_ms),
      fmt::format("{} frames checked: {} of {} objects culled otherwise than in a scene made anew; {} culls proved, {} not.",
                  result.frames_checked, result.different, result.objects_compared, result.proved, result.unproved),
      "One thread of " + text_of(render::this_machine()) + "."};
  std::ranges::copy(notes, std::back_inserter(table.notes));
  return table;
}

std::string json_of(const SceneBenchResult& result, const SceneBenchOptions& options) {
  const WorldSize& world = options.world;
  Json views = Json::array();
  for (const SceneViewResult& view : result.views) {
    Json of_view = json_of(view.spread);
    of_view["view_frustum_ms"] = json_of(view.view_frustum_ms);
    of_view["hidden_share"] = view.hidden_share;
    views.push_back(of_view);
  }
  const Json json{{"objects", result.objects},
                  {"streamed", world.streamed},
                  {"moving", world.moving},
                  {"occluders", result.occluders},
                  {"moving_occluders", world.moving_occluders},
                  {"frames", options.frames},
                  {"seed", options.seed},
                  {"cover_size", {options.cover.width, options.cover.height}},
                  {"budget_ms", budget(options.cover.ms, culler::CoverOptions().ms)},
                  {"budget_work", budget(options.cover.work, culler::CoverOptions().work)},
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
