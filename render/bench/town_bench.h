// SPDX-License-Identifier: MIT
// Measures a town that stands: how long an engine waits for it, what it holds, what is drawn of it.
#pragma once

#include <cstddef>
#include <optional>

#include "occlude/culler/scene.h"
#include "occlude/render/table.h"
#include "spread.h"
#include "view_spread.h"

namespace occlude::experiments {

/// Terraces of houses along straight streets, without gaps, and cars that drive. Inside each of the first houses stands one
/// rectangle that hides; the rectangles of all houses are one mesh, and neighbours share an edge.
struct TownBenchOptions {
  std::size_t houses = 19'000, cars = 1'000;
  std::size_t walls = 17'500;    ///< houses with a rectangle that hides
  std::size_t repetitions = 15;  ///< the town is made so often
  std::size_t frames = 300;      ///< of a camera that walks along streets and turns
  culler::CoverOptions cover = {};
};

struct TownBenchResult {
  /// For each time it was made: its mesh, its objects and the first update, on one thread; milliseconds.
  Spread prepared_ms;
  /// Resident memory that one town takes, its occluders included; empty if the system does not tell.
  std::optional<std::size_t> held_bytes;
  Spread update_ms;  ///< over the frames
  ViewSpread view;
};

/// Throws Interrupted on Ctrl-C.
[[nodiscard]] TownBenchResult bench_town(const TownBenchOptions& options);

/// As a table, and as JSON.
[[nodiscard]] render::Table table_of(const TownBenchResult& result, const TownBenchOptions& options);
[[nodiscard]] std::string json_of(const TownBenchResult& result, const TownBenchOptions& options);

}  // namespace occlude::experiments
