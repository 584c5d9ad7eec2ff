// SPDX-License-Identifier: MIT
// The benchmark of the culler: the experiments of the paper's section 6.3, and open questions.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "figure4.h"
#include "growth.h"
#include "joined.h"
#include "occlude/render/summary.h"
#include "occluders.h"
#include "setting.h"
#include "sorting.h"
#include "sweeps.h"
#include "threads.h"

namespace occlude::experiments {

/// The experiments, in the order in which they run.
inline constexpr std::array kExperiments{"table2", "figure4", "sweeps", "sort", "joined", "occluders", "threads", "growth"};

/// The results of the chosen experiments; the others are empty.
struct Result {
  std::string model;
  std::size_t polygons = 0, first_frame = 0, last_frame = 0, frames = 0;
  std::optional<render::Summary> table2;    ///< by every method
  std::vector<render::FrameRecord> walked;  ///< the frames of table 2, for figures 2 and 3
  std::optional<Figure4> figure4;
  std::optional<Sweeps> sweeps;
  std::optional<Sorting> sort;
  std::optional<Joined> joined;
  std::optional<Occluders> occluders;
  std::vector<ThreadsPoint> threads;
  std::optional<Growth> growth;
};

/// Throws InputError if the path lacks the selected frames, Interrupted on Ctrl-C.
[[nodiscard]] Result run(const Subject& subject, const Options& options, const std::vector<std::string>& chosen);

// The results as text, JSON and HTML.

[[nodiscard]] std::string report_text(const Result& result, const Options& options);

/// One object. Experiments that were not run, and values that could not be measured, are null.
[[nodiscard]] std::string report_json(const Result& result, const Options& options);

/// Of a page, below its title.
[[nodiscard]] std::string report_sections(const Result& result, const Options& options);

/// One page without scripts or external addresses.
[[nodiscard]] std::string report_html(const Result& result, const Options& options);

}  // namespace occlude::experiments
