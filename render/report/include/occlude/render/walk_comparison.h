// SPDX-License-Identifier: MIT
// The results of two walks side by side.
#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "occlude/render/frame_table.h"
#include "occlude/render/spread.h"

namespace occlude::render {

/// What a walk wrote.
struct WalkReading {
  std::string name;   ///< as the user gave it, printable
  std::string label;  ///< of its folder alone, or of its file if that is no summary.json
  nlohmann::json summary;
  std::map<std::size_t, std::filesystem::path> plates;  ///< from outside, by their frames
  std::optional<FrameTable> frames;
};

/// Reads summary.json, or the folder that has it, with its frames.csv and its plates if there are any. Throws InputError for
/// anything that is not of a walk. No output may replace what is read.
[[nodiscard]] WalkReading read_walk(const std::filesystem::path& place);

/// What the change from A to B means. `unjudged`: it is neither good nor bad, or its noise is not known.
enum class Verdict { unjudged, same, better, worse };

struct ComparedFigure {
  std::string name;  ///< as in summary.json
  std::optional<double> a, b;
  std::vector<double> frames_of_a, frames_of_b;  ///< the same of each frame that both have; empty if frames.csv lacks it
  std::optional<Spread> per_frame;               ///< of B / A, over these frames
  Verdict verdict = Verdict::unjudged;

  /// B / A, if A is not 0.
  [[nodiscard]] std::optional<double> ratio() const;
};

/// A model, an option or a machine that is not the same.
struct Difference {
  std::string name, a, b;  ///< printable; "-" where a summary lacks it
};

/// A walk of the two.
struct ComparedWalk {
  std::string name, label;  ///< as in WalkReading; both have labels of their own
  std::string busy;         ///< what its summary says of a busy machine
  /// A plate from outside, of the frame that is nearest to that of the other's; none if one of them has none.
  std::optional<std::pair<std::size_t, std::filesystem::path>> plate;
};

struct WalkComparison {
  ComparedWalk a, b;
  std::vector<Difference> differences;
  std::vector<ComparedFigure> figures;
  std::optional<std::vector<double>> frames;  ///< that both have, if both have a frames.csv
  /// B / A of what both do alike, frames by the view frustum alone, by the clock and of the processor; none if it is not
  /// known of both.
  std::optional<double> control, control_of_processor;

  [[nodiscard]] std::vector<std::string> worse() const;
};

/// Whether a control took the same time, but for a tenth, or is not known: else the machine was another one, or busy.
[[nodiscard]] bool is_same_pace(const std::optional<double>& control);

/// Counts got better or worse if they changed by more than a thousandth, wrong pixels and false culls by any number. Times
/// did if the median of their ratios, frame by frame, is more than 5 % from 1 and surely (95 %) on that side of 1, and the
/// pace of the machine was the same.
[[nodiscard]] WalkComparison compare_walks(const WalkReading& a, const WalkReading& b);

}  // namespace occlude::render
