// SPDX-License-Identifier: MIT
// The culler beside other projects that tell what is visible: all tell which leaves of one tree a camera must draw, on the
// same frames.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "occlude/render/table.h"
#include "occlude/render/walk.h"
#include "rivals.h"
#include "setting.h"

namespace occlude::experiments {

struct VisibilityOptions {
  /// Frames, pictures, tree and culling. Leaves are small, as joined shadows want them: rays find single polygons.
  render::WalkOptions walk;
  std::size_t repetitions = 5;  ///< rounds that are timed
  std::vector<RayPicture> pictures{{160, 90}, {640, 360}};
};

struct WayResult {
  std::string project, name;
  double prepare_ms = 0;                  ///< processor time of all threads; ours has the tree in it
  double drawn = 0;                       ///< polygons a frame
  double hidden_culled = 0;               ///< share of the hidden polygons
  std::size_t false_culls = 0;            ///< polygons with a pixel in the item buffer that were culled, over all frames
  std::size_t wrong_pixels = 0;           ///< that show another polygon than without culling, over all frames
  double cull_ms = 0, worst_cull_ms = 0;  ///< over the frames, each the median of the rounds: mean, and most
};

struct VisibilityResult {
  std::string model;
  std::size_t polygons = 0, leaves = 0, frames = 0;
  double tree_ms = 0;                      ///< processor time to build the tree that the others are given
  double in_view = 0, hidden = 0;          ///< polygons a frame: passed by the view frustum; of them without a pixel
  std::vector<WayResult> ways;             ///< ours first
  std::vector<bench::PeerSummary> rivals;  ///< all known ones
};

/// Throws InputError if the path lacks the selected frames, Interrupted on Ctrl-C, and as rivals() and what they prepare.
[[nodiscard]] VisibilityResult measure_visibility(const Subject& subject, const VisibilityOptions& options);

/// The result of the way of this name. REQUIRES: there is one.
[[nodiscard]] const WayResult& way_of(const VisibilityResult& result, const std::string& name);

/// As a table, and as JSON.
[[nodiscard]] render::Table table_of(const VisibilityResult& result, const VisibilityOptions& options);
[[nodiscard]] std::string json_of(const VisibilityResult& result, const VisibilityOptions& options);

}  // namespace occlude::experiments
