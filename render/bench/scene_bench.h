// SPDX-License-Identifier: MIT
// Measures a scene that streams: changes, updates and culls, frame by frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "occlude/culler/scene.h"
#include "occlude/render/table.h"
#include "scene_world.h"
#include "spread.h"
#include "view_spread.h"

namespace occlude::experiments {

struct SceneBenchOptions {
  WorldSize world;
  std::size_t frames = 600;
  std::size_t settling = 100;     ///< frames before those that count
  std::size_t check_every = 100;  ///< frames; 0: nothing is checked
  std::size_t proofs = 20;        ///< culls that are proved, for each view of a frame that is checked
  std::uint64_t seed = 1;
  culler::CoverOptions cover = {};  ///< of the culls, with their budget
};

/// What is measured of one camera.
struct SceneViewResult {
  ViewSpread spread;
  Spread view_frustum_ms;   ///< of culls by the view frustum alone
  double hidden_share = 0;  ///< of the objects in view, in all frames together
};

struct SceneBenchResult {
  std::size_t objects = 0, occluders = 0;  ///< at the end
  double build_ms = 0;                     ///< of the whole world
  double bytes_of_object = 0;
  Spread change_ms, update_ms;
  std::vector<SceneViewResult> views;
  std::size_t frames_checked = 0, objects_compared = 0;
  std::size_t different = 0;             ///< objects that a scene made anew culls otherwise
  std::size_t proved = 0, unproved = 0;  ///< culls by occluders
};

[[nodiscard]] inline bool has_budget(const culler::CoverOptions& cover) {
  return cover.ms != culler::CoverOptions().ms || cover.work != culler::CoverOptions().work;
}

/// Whether the polygons that are named hide the box of the object from the camera.
using Prove = std::function<bool(const culler::Camera&, const culler::ObjectFate&, const culler::Box&)>;

/// progress(done, all) is called after each frame, and may throw.
[[nodiscard]] SceneBenchResult bench_scene(const SceneBenchOptions& options, const Prove& prove,
                                           const std::function<void(std::size_t, std::size_t)>& progress);

/// As a table, and as JSON.
[[nodiscard]] render::Table table_of(const SceneBenchResult& result, const SceneBenchOptions& options);
[[nodiscard]] std::string json_of(const SceneBenchResult& result, const SceneBenchOptions& options);

}  // namespace occlude::experiments
