// SPDX-License-Identifier: MIT
// The figures of a walk. They are worked out once, from its frames; text, JSON and pages are written from them.
#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "occlude/kernel/operations.h"
#include "occlude/render/walk.h"

namespace occlude::render {

/// Where something was measured.
struct Machine {
  std::string processor, compiler;
  unsigned threads = 0;
  std::string renderer;  ///< as the driver names itself; empty where nothing was drawn
};

[[nodiscard]] Machine this_machine(const std::string& renderer);

/// Numbers that need pictures are none when the walk did not render.
struct Summary {
  /// Averages a frame.
  struct Mean {
    double view_frustum_polygons = 0, rendered_polygons = 0;
    std::optional<double> visible_polygons;
    std::optional<double> hidden_polygons;  ///< they pass view-frustum culling and have no pixel in the item buffer
    double occluders = 0, candidates = 0, sort_moves = 0;
    double cull_ms = 0, witness_ms = 0;
    std::optional<double> frame_ms, frame_ms_view_frustum_only, frame_ms_visible_only;
  };

  std::string model;
  std::size_t polygons = 0, triangles = 0, frames = 0;
  WalkOptions options;
  culler::BuildConfig build;
  Mean mean;
  double culled_share = 0;  ///< of the polygons in the view frustum
  std::optional<double> culled_share_of_hidden;
  std::optional<double> speedup;
  std::optional<double> limit_by_polygons;  ///< of the speedup: the ratio of polygons drawn; none where none was
  std::optional<double> limit_by_visible;   ///< of the speedup: drawing only what is visible
  std::optional<std::size_t> wrong_pixels, snapped_pixels, false_culls;
  std::size_t reference_frames = 0, witnesses = 0;
  kernel::Operations operations;
  double preprocess_s = 0;
  Machine machine;
};

/// REQUIRES: at least one frame.
[[nodiscard]] Summary summarise(const WalkResult& result, const WalkOptions& options, const std::string& model);

/// Whether no visible polygon was culled and every differing pixel is explained by the renderer's rounding.
[[nodiscard]] bool passed(const WalkResult& result);

/// The mean over the frames of a member of FrameRecord, or of what a function makes of one. REQUIRES: at least one frame.
template <class Member>
[[nodiscard]] double mean(const WalkResult& result, Member&& member) {
  double sum = 0;
  for (const FrameRecord& record : result.frames) sum += static_cast<double>(std::invoke(member, record));
  return sum / static_cast<double>(result.frames.size());
}

/// The same of the polygons that pass the view frustum and have no pixel in the item buffer.
[[nodiscard]] double mean_hidden(const WalkResult& result);

/// Table 2 of the paper beside this run, and the checks.
[[nodiscard]] std::string text_of(const Summary& summary);

/// summary.json.
[[nodiscard]] nlohmann::ordered_json json_of(const Summary& summary);

/// The members of it that another report has as well: what was chosen, and where it was measured.
[[nodiscard]] nlohmann::ordered_json json_of(const WalkOptions& options, const culler::BuildConfig& build);
[[nodiscard]] nlohmann::ordered_json json_of(const Machine& machine);

/// As options and reports write them.
[[nodiscard]] const char* name_of(kernel::Near near);
[[nodiscard]] const char* name_of(kernel::Arithmetic arithmetic);
[[nodiscard]] const char* name_of(kernel::Test test);

/// frames.csv, a header line and a line for each frame.
[[nodiscard]] std::string frames_csv(const WalkResult& result);

}  // namespace occlude::render
