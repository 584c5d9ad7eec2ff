// SPDX-License-Identifier: MIT
// The results of all benchmarks in one report, and what of them is beside other projects.
#pragma once

#include <string>
#include <vector>

#include "bench.h"
#include "experiments.h"
#include "held_bench.h"
#include "report.h"
#include "scene_bench.h"
#include "town_bench.h"
#include "visibility.h"

namespace occlude::experiments {

template <class Options, class Result>
struct Measured {
  Options options;
  Result result;
};

struct AllResult {
  bench::Result kernel;
  Measured<Options, Result> culler;
  Measured<SceneBenchOptions, SceneBenchResult> scene;
  Measured<TownBenchOptions, TownBenchResult> town;
  Measured<VisibilityOptions, VisibilityResult> visibility;
  Measured<HeldBenchOptions, HeldBenchResult> held;
};

/// A time of another project over ours.
struct Beside {
  /// `box`: nanoseconds a box against one shadow frustum. `cull`: milliseconds a frame.
  enum class What { box, cull };

  std::string project;
  What what = What::box;
  std::string way;
  double theirs = 0, ours = 0, ratio = 0;
  double wrong = 0;  ///< share of the answers where boxes touch within an ulp; false culls over all frames
};

/// For every known project what is measured of it; nothing for one that is not installed.
[[nodiscard]] std::vector<Beside> beside(const AllResult& all);

/// All known projects, installed or not.
[[nodiscard]] std::vector<bench::PeerSummary> projects(const AllResult& all);

// As text, as one object of JSON, and as a page without scripts or external addresses.

[[nodiscard]] std::string report_text(const AllResult& all);
[[nodiscard]] std::string report_json(const AllResult& all);
[[nodiscard]] std::string report_html(const AllResult& all);

}  // namespace occlude::experiments
