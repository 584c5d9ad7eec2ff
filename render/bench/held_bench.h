// SPDX-License-Identifier: MIT
// Measures culls that hold for the frames between them, beside culls of every frame by point.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "occlude/culler/held_cull.h"
#include "occlude/render/table.h"
#include "setting.h"

namespace occlude::experiments {

struct HeldBenchOptions {
  std::size_t frames = 1200;       ///< of each way to move
  std::size_t compare_every = 20;  ///< frames: how often the same frame is culled by point
  double frames_a_second = 60;
  std::uint32_t leaf = culler::leaf_size_for(culler::Method::cover);
  std::vector<double> speeds;  ///< along the path, model units a second, instead of the ways to move; may be empty
  culler::CullOptions cull = {.method = culler::Method::cover};
};

/// One way to move: what its frames take.
struct HeldMove {
  std::string name;
  std::optional<double> speed;           ///< along the path, model units a second; none of a camera that stands
  double own_ms = 0;                     ///< a frame, on the calling thread: mean
  double worst_own_ms = 0;               ///< and most
  double worst_held_ms = 0;              ///< most of a frame that was not culled by point
  double beside_ms = 0;                  ///< a frame, on the other thread: mean
  double worst_beside = 0;               ///< milliseconds of a region, most
  double point_ms = 0;                   ///< a frame by point: mean
  double hidden_share = 0;               ///< hidden polygons that are culled, of those that a frame by point culls
  double drawn = 0, drawn_by_point = 0;  ///< polygons a frame
  culler::HeldStats stats;

  [[nodiscard]] double ms() const { return own_ms + beside_ms; }
};

struct HeldBenchResult {
  std::string model;
  std::size_t polygons = 0;
  std::vector<HeldMove> moves;
};

/// Throws Interrupted on Ctrl-C.
[[nodiscard]] HeldBenchResult bench_held(const Subject& subject, const HeldBenchOptions& options);

/// As a table, and as JSON.
[[nodiscard]] render::Table table_of(const HeldBenchResult& result, const HeldBenchOptions& options);
[[nodiscard]] std::string json_of(const HeldBenchResult& result, const HeldBenchOptions& options);
/// Milliseconds a frame over the speeds, held and by point, as an SVG file. REQUIRES: speeds that ascend.
[[nodiscard]] std::string chart_of(const HeldBenchResult& result, const HeldBenchOptions& options);

}  // namespace occlude::experiments
