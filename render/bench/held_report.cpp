// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "held_bench.h"
#include "occlude/render/chart.h"
#include "occlude/render/machine.h"

namespace occlude::experiments {

render::Table table_of(const HeldBenchResult& result, const HeldBenchOptions& options) {
  render::Table table{.title = "Culls that hold: " + result.model,
                      .columns = {{"milliseconds a frame", "move"},
                                  {"", "speed"},
                                  {"held", "ms", render::rounded<3>},
                                  {"on the caller's thread", "own_ms", render::rounded<3>},
                                  {"worst there", "worst_own_ms", render::rounded<2>},
                                  {"not by point", "worst_held_ms", render::rounded<2>},
                                  {"", "beside_ms"},
                                  {"", "worst_beside_ms"},
                                  {"by point", "point_ms", render::rounded<2>},
                                  {"hidden, of by point's", "hidden_over_point", render::percent},
                                  {"drawn", "drawn"},
                                  {"by point", "drawn_by_point"},
                                  {"frames by point", "frames_by_point"},
                                  {"regions", "regions"},
                                  {"", "regions_around"},
                                  {"", "regions_late"}},
                      .rows = {}};
  for (const HeldMove& move : result.moves) {
    const culler::HeldStats& stats = move.stats;
    table.rows.push_back({move.name, render::if_known(move.speed), move.ms(), move.own_ms, move.worst_own_ms,
                          move.worst_held_ms, move.beside_ms, move.worst_beside, move.point_ms, move.hidden_share,
                          move.drawn, move.drawn_by_point, stats.of_point, stats.regions, stats.around, stats.late});
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
  const nlohmann::ordered_json json{{"model", result.model},
                                    {"polygons", result.polygons},
                                    {"frames", options.frames},
                                    {"frames_a_second", options.frames_a_second},
                                    {"cover_size", {options.cull.cover.width, options.cull.cover.height}},
                                    {"leaf", options.leaf},
                                    {"moves", json_of(table_of(result, options))},
                                    {"machine", json_of(render::this_machine())}};
  return json.dump(2) + "\n";
}

}  // namespace occlude::experiments
