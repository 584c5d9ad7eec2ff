// SPDX-License-Identifier: MIT
// The benchmark of the culler: the experiments of the paper's section 6.3, and what it leaves open.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "figure4.h"
#include "growth.h"
#include "joined.h"
#include "methods.h"
#include "occlude/render/summary.h"
#include "setting.h"
#include "sorting.h"
#include "sweeps.h"

namespace occlude::experiments {

/// In the order in which they are made.
inline constexpr std::array kExperiments{"table2", "figure4", "sweeps", "sort", "joined", "growth"};

/// Of the experiments that were chosen.
struct Result {
  std::string model;
  std::size_t polygons = 0, first_frame = 0, last_frame = 0, frames = 0;
  std::optional<render::Summary> table2;
  std::optional<Methods> methods;           ///< beside table2: the same walk by each
  std::vector<render::FrameRecord> walked;  ///< the frames of table 2, which are figures 2 and 3
  std::optional<Figure4> figure4;
  std::optional<Sweeps> sweeps;
  std::optional<Sorting> sort;
  std::optional<Joined> joined;
  std::optional<Growth> growth;
};

/// Throws InputError for a path without the frames asked for, Interrupted on Ctrl-C.
[[nodiscard]] Result run(const Subject& subject, const Options& options, const std::vector<std::string>& chosen);

// What they found, for people and for programs.

[[nodiscard]] std::string report_text(const Result& result, const Options& options);

/// One object; experiments that were not made, and what could not be measured, are null.
[[nodiscard]] std::string report_json(const Result& result, const Options& options);

/// One page without scripts or outside addresses.
[[nodiscard]] std::string report_html(const Result& result, const Options& options);

}  // namespace occlude::experiments
