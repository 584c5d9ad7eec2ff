// SPDX-License-Identifier: MIT
#include "sweeps.h"

#include <array>

#include "bench.h"
#include "frame/culler_access.h"
#include "occlude/culler/culler.h"
#include "occlude/render/progress.h"
#include "occlude/render/stopwatch.h"
#include "pass.h"
#include "rounds.h"

namespace occlude::experiments {
namespace {

using Lists = culler::ListConfig;

/// The edge of a cube of a grid halves from one to the next.
constexpr std::array<double, 4> kRegions{512, 4096, 32768, 262144};
/// Steps of about half a decade, steradians.
constexpr std::array<double, 5> kThresholds{0.003, 0.01, 0.03, 0.1, 0.3};

/// A point and its timings, one number per round.
struct SweepTrial {
  SweepPoint point;
  std::vector<double> preprocess_s, cull_ms;
};

void run(SweepTrial& trial, const Subject& subject, const Options& options) {
  culler::BuildConfig config = options.walk.build;
  config.lists = trial.point.lists;
  const render::Stopwatch stopwatch;
  const culler::Culler culler(subject.soup, config, render::check_interrupt);
  culler.prepare(options.walk.cull.method, render::check_interrupt);
  trial.preprocess_s.push_back(stopwatch.seconds());
  const Pass pass = pass_along(culler, subject.path, options.walk, options.walk.cull);
  trial.cull_ms.push_back(pass.cull_ms);
  trial.point.entries = occluders_of(culler).lists().stored().occluders.size();
  trial.point.listed = pass.listed;
  trial.point.culled_share = culled_share(polygons_in_view(culler, subject.path, options.walk), pass.drawn);
}

SweepPoint point_of(const SweepTrial& trial, const SweepTrial& standard) {
  SweepPoint point = trial.point;
  point.preprocess_s = bench::median(trial.preprocess_s);
  point.cull_ms = bench::median(trial.cull_ms);
  point.cull_ratio = bench::median_ratio(trial.cull_ms, standard.cull_ms);
  return point;
}

}  // namespace

Sweeps measure_sweeps(const Subject& subject, const Options& options) {
  const Lists standard = options.walk.build.lists;
  std::vector<SweepTrial> trials;
  const auto add = [&](const auto& change) {
    Lists lists = standard;
    change(lists);
    trials.push_back({{lists}, {}, {}});
  };
  add([](Lists&) {});
  for (const double regions : kRegions) add([&](Lists& lists) { lists.regions = regions; });
  for (const double threshold : kThresholds) add([&](Lists& lists) { lists.threshold = threshold; });

  run_in_rounds("sweeps: lists", options.repetitions, trials, [&](SweepTrial& trial) { run(trial, subject, options); });
  Sweeps sweeps;
  for (std::size_t i = 1; i < trials.size(); ++i) {
    (i <= kRegions.size() ? sweeps.regions : sweeps.threshold).push_back(point_of(trials[i], trials[0]));
  }
  return sweeps;
}

}  // namespace occlude::experiments
