// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <nlohmann/json.hpp>

#include "occlude/render/machine.h"
#include "town_bench.h"

namespace occlude::experiments {

bench::Table table_of(const TownBenchResult& result, const TownBenchOptions& options) {
  const std::string held =
      result.held_bytes ? fmt::format("{:.1f} MB", static_cast<double>(*result.held_bytes) / 1e6) : "an unknown amount";
  bench::Table table{.title = "A town that stands",
                     .head = {fmt::format("made {} times, {} frames", options.repetitions, options.frames), "median",
                              "99th percentile", "maximum"},
                     .rows = {row_of("prepared, ms", result.prepared_ms, 1), row_of("update, ms", result.update_ms, 2)},
                     .notes = {fmt::format("{} houses, {} cars that drive, {} rectangles that hide, in one mesh.",
                                           options.houses, options.cars, options.walls),
                               fmt::format("The scene holds {} of resident memory, its occluders included.", held),
                               fmt::format("One thread of {}; {}.", render::processor_name(), render::compiler_name())}};
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
  json["machine"] = {{"processor", render::processor_name()}, {"compiler", render::compiler_name()}};
  return json.dump(2) + "\n";
}

}  // namespace occlude::experiments
