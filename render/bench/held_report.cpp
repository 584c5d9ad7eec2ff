// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "held_bench.h"
#include "occlude/render/chart.h"
#include "occlude/render/machine.h"

namespace occlude::experiments {

using Json = nlohmann::ordered_json;

render::Table table_of(const HeldBenchResult& result, const HeldBenchOptions& options) {
  render::Table table{.title = "Culls that hold: " + result.model,
                      .columns = {{"milliseconds a frame"},
                                  {"held"},
                                  {"on the caller's thread"},
                                  {"worst there"},
                                  {"not by point"},
                                  {"by point"},
                                  {"hidden, of by point's"},
                                  {"drawn"},
                                  {"by point"},
                                  {"frames by point"},
                                  {"regions"}},
                      .rows = {}};
  for (const HeldMove& move : result.moves) {
    table.rows.push_back({move.name, fmt::format("{:.3f}", move.ms()), fmt::format("{:.3f}", move.own_ms),
                          fmt::format("{:.2f}", move.worst_own_ms), fmt::format("{:.2f}", move.worst_held_ms),
                          fmt::format("{:.2f}", move.point_ms), fmt::format("{:.1f} %", 100 * move.hidden_share),
                          fmt::format("{:.0f}", move.drawn), fmt::format("{:.0f}", move.drawn_by_point),
                          fmt::format("{}", move.stats.of_point), fmt::format("{}", move.stats.regions)});
  }
  table.notes = {fmt::format("{} polygons; {} frames of each, {} a second; regions are culled beside, and counted.",
                             result.polygons, options.frames, options.frames_a_second),
                 "One thread of " + text_of(render::this_machine()) + "."};
  return table;
}

std::string chart_of(const HeldBenchResult& result, const HeldBenchOptions& options) {
  render::Series held{"held, the regions that are culled beside counted", "#2f7fe0", {}};
  render::Series by_point{"each frame culled for itself", "#d9822b", {}};
  for (const HeldMove& move : result.moves) {
    held.y.push_back(move.ms());
    by_point.y.push_back(move.point_ms);
  }
  return render::svg_file(render::line_chart({"speed of the camera, model units a second", render::Scale::logarithmic},
                                             {"milliseconds a frame", render::Scale::logarithmic}, options.speeds,
                                             {held, by_point}));
}

std::string json_of(const HeldBenchResult& result, const HeldBenchOptions& options) {
  Json moves = Json::array();
  for (const HeldMove& move : result.moves) {
    moves.push_back({{"move", move.name},
                     {"ms", move.ms()},
                     {"own_ms", move.own_ms},
                     {"worst_own_ms", move.worst_own_ms},
                     {"worst_held_ms", move.worst_held_ms},
                     {"beside_ms", move.beside_ms},
                     {"worst_beside_ms", move.worst_beside},
                     {"point_ms", move.point_ms},
                     {"hidden_over_point", move.hidden_share},
                     {"drawn", move.drawn},
                     {"drawn_by_point", move.drawn_by_point},
                     {"frames_by_point", move.stats.of_point},
                     {"regions", move.stats.regions},
                     {"regions_around", move.stats.around},
                     {"regions_late", move.stats.late}});
  }
  const Json json{{"model", result.model},
                  {"polygons", result.polygons},
                  {"frames", options.frames},
                  {"frames_a_second", options.frames_a_second},
                  {"cover_size", {options.cull.cover.width, options.cull.cover.height}},
                  {"leaf", options.leaf},
                  {"moves", moves},
                  {"machine", json_of(render::this_machine())}};
  return json.dump(2) + "\n";
}

}  // namespace occlude::experiments
