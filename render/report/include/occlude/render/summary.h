// SPDX-License-Identifier: MIT
// The figures of a walk, computed once from its frames. Text, JSON and pages are written from them.
#pragma once

#include <cstddef>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "occlude/kernel/operations.h"
#include "occlude/render/machine.h"
#include "occlude/render/methods.h"
#include "occlude/render/missed_report.h"
#include "occlude/render/paint.h"
#include "occlude/render/spread.h"
#include "occlude/render/walk.h"

namespace occlude::render {

/// The optional numbers need pictures and are empty if the walk did not render.
struct Summary {
  /// Means over the frames.
  struct Mean {
    double view_frustum_polygons = 0, rendered_polygons = 0;
    std::optional<double> visible_polygons;
    std::optional<double> hidden_polygons;  ///< in the view frustum, without a pixel in the item buffer
    double occluders = 0, candidates = 0, sort_moves = 0;
    double cull_ms = 0, witness_ms = 0;
    double view_frustum_cull_ms = 0, cull_processor_ms = 0;  ///< of the processor: by all threads of the program
    std::optional<double> frame_ms, frame_ms_view_frustum_only, frame_ms_visible_only;
    std::optional<double> frame_processor_ms, frame_processor_ms_view_frustum_only;
  };

  /// Whether the speedup is above its limit by polygons, and if so, whether that may be the noise of the measured times.
  enum class AboveLimit { no, within_noise, beyond_noise };

  /// Over the frames.
  struct Spreads {
    std::optional<Spread> cull_ms, cull_processor_ms, frame_ms, frame_processor_ms, speedup;
  };

  /// Of a walk that holds.
  struct Held {
    std::size_t regions = 0;          ///< that were culled, whether for counted frames or for those between
    std::size_t frames_by_point = 0;  ///< culled for themselves, because no region held
    std::optional<double> region_ms;  ///< to cull a region: mean
    std::optional<double> frame_ms;   ///< to cull a frame for which no region was: mean
    double frames_a_region = 0;       ///< 0 without a region; frames that are not counted do here
  };

  std::string model;
  std::size_t polygons = 0, see_through_polygons = 0, triangles = 0, frames = 0;
  WalkOptions options;
  culler::BuildConfig build;
  Mean mean;
  Spreads spread;
  std::optional<Held> held;
  double culled_share = 0;  ///< of the polygons in the view frustum
  std::optional<double> culled_share_of_hidden;
  std::optional<double> speedup;
  std::optional<double> limit_by_polygons;  ///< of the speedup: ratio of polygons drawn; empty if none was
  std::optional<double> limit_by_visible;   ///< of the speedup: drawing only what is visible
  AboveLimit above_limit = AboveLimit::no;
  std::optional<std::size_t> wrong_pixels, snapped_pixels, false_culls;
  Methods methods;                     ///< this walk beside others by other methods
  std::optional<MissedCounts> missed;  ///< over all frames, if the walk rendered
  std::size_t reference_frames = 0, witnesses = 0;
  kernel::Operations operations;
  double preprocess_s = 0;
  double region = 0;  ///< as WalkResult has it
  Machine machine;
  std::optional<double> load;  ///< of it when the walk began
};

/// Beside no other method. REQUIRES: at least one frame.
[[nodiscard]] Summary summarise(const WalkResult& result, const WalkOptions& options, const std::string& model);

/// Whether no visible polygon was culled and the renderer's rounding explains every differing pixel.
[[nodiscard]] bool passed(const WalkResult& result);

/// The mean over the frames of a member of FrameRecord, or of a function of one. REQUIRES: at least one frame.
template <class Member>
[[nodiscard]] double mean(const WalkResult& result, Member&& member) {
  double sum = 0;
  for (const FrameRecord& record : result.frames) sum += static_cast<double>(std::invoke(member, record));
  return sum / static_cast<double>(result.frames.size());
}

/// The mean number of polygons in the view frustum without a pixel in the item buffer.
[[nodiscard]] double mean_hidden(const WalkResult& result);

/// Why the speedup is above its limit by polygons; empty if it is not.
[[nodiscard]] std::string limit_note(const Summary& summary);

/// What shows that others had the processors, too, so that times by the clock are too long; empty if nothing does.
[[nodiscard]] std::string busy_note(const Summary& summary);

/// Table 2 of the paper beside the figures of this run, their spread, and the checks.
[[nodiscard]] std::string text_of(const Summary& summary, const Paint& paint = {});

/// What the walk was told to do: a member of summary.json.
[[nodiscard]] nlohmann::ordered_json options_of(const Summary& summary);

/// The contents of summary.json.
[[nodiscard]] nlohmann::ordered_json json_of(const Summary& summary);

/// Members that other reports share: a spread (null if there is none), and the options.
[[nodiscard]] nlohmann::ordered_json json_of(const std::optional<Spread>& spread);
[[nodiscard]] nlohmann::ordered_json json_of(const WalkOptions& options, const culler::BuildConfig& build);

/// The names in options and reports.
[[nodiscard]] const char* name_of(kernel::Near near);
[[nodiscard]] const char* name_of(kernel::Arithmetic arithmetic);
[[nodiscard]] const char* name_of(kernel::Test test);

/// The contents of frames.csv: a header line and a line for each frame.
[[nodiscard]] std::string frames_csv(const WalkResult& result);

}  // namespace occlude::render
