// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "occlude/render/machine.h"
#include "town_bench.h"

namespace occlude::experiments {

render::Table table_of(const TownBenchResult& result, const TownBenchOptions& options) {
  const std::string held =
      result.held_bytes ? fmt::format("{:.1f} MB", static_cast<double>(*result.held_bytes) / 1e6) : "an unknown amount";
  render::Table table{
      .title = "A town that stands",
      .columns = spread_columns(fmt::format("made {} times, {} frames", options.repetitions, options.frames)),
      .rows = {row_of("prepared, ms", result.prepared_ms, 1), row_of("update, ms", result.update_ms, 2)},
      .notes = {fmt::format("{} houses, {} cars that drive, {} rectangles that hide, in one mesh.", options.houses,
                            options.cars, options.walls),
                fmt::format("The scene holds {} of resident memory, its occluders included.", held),
                "One thread of " + text_of(render::this_machine()) + "."}};
  std::ranges::move(rows_of("", result.view), std::back_inserter(table.rows));
  return table;
}

std::string json_of(const TownBenchResult& result, const TownBenchOptions& options) {
  using Json = nlohmann::ordered_json;
  Json json{{"houses", options.houses},
            {"cars", options.cars},
            {"walls", options.walls},
            {"repetitions", options.repetitions},
            {"frames", options.frames},
            {"prepared_ms", json_of(result.prepared_ms)},
            {"held_bytes", result.held_bytes ? Json(*result.held_bytes) : Json(nullptr)},
            {"update_ms", json_of(result.update_ms)}};
  json.update(json_of(result.view));
  json["machine"] = json_of(render::this_machine());
  return json.dump(2) + "\n";
}

}  // namespace occlude::experiments
