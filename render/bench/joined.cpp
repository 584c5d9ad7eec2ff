// SPDX-License-Identifier: MIT
#include "joined.h"

#include <array>
#include <limits>

#include "bench.h"
#include "occlude/culler/culler.h"
#include "occlude/render/progress.h"
#include "pass.h"
#include "rounds.h"

namespace occlude::experiments {
namespace {

/// Each has about twice as many pixels as the one before, around the default, in the ratio 16:9.
constexpr std::array<int, 5> kWidths{256, 384, 512, 768, 1024};
constexpr std::array<std::uint32_t, 5> kLeaves{1, 2, 4, 8, 16};
constexpr std::array kBudgets{0.25, 0.5, 1.0, 2.0, 4.0};
/// The values of the parameters that are not varied.
constexpr int kWidth = 512;
constexpr std::uint32_t kLeaf = culler::leaf_size_for(culler::Method::cover);
constexpr double kBudget = std::numeric_limits<double>::infinity();

JoinedPoint point_at(int width, std::uint32_t leaf, double budget_ms) {
  return {width, width * 9 / 16, leaf, budget_ms, 0, 0, 0};
}

/// A point and its timings, one number per round.
struct JoinedTrial {
  JoinedPoint point;
  std::vector<double> cull_ms;
};

void run(JoinedTrial& trial, const Subject& subject, const Options& options) {
  render::WalkOptions walk = options.walk;
  walk.build.hierarchy.leaf_size = trial.point.leaf;
  walk.build.lists.regions = 1;  // no list is used
  walk.cull.method = culler::Method::cover;
  walk.cull.cover.width = trial.point.width;
  walk.cull.cover.height = trial.point.height;
  walk.cull.cover.ms = trial.point.budget_ms;
  const culler::Culler culler = make_culler(subject.soup, walk);
  const Pass pass = pass_along(culler, subject.path, walk, walk.cull);
  trial.cull_ms.push_back(pass.cull_ms);
  trial.point.drawn = pass.drawn;
  trial.point.culled_share = culled_share(polygons_in_view(culler, subject.path, walk), pass.drawn);
}

}  // namespace

Joined measure_joined(const Subject& subject, const Options& options) {
  std::vector<JoinedTrial> trials;
  std::vector<std::vector<JoinedPoint> Joined::*> curves;  // of each trial
  const auto add = [&](std::vector<JoinedPoint> Joined::*curve, const JoinedPoint& point) {
    trials.push_back({point, {}});
    curves.push_back(curve);
  };
  for (const int width : kWidths) add(&Joined::pictures, point_at(width, kLeaf, kBudget));
  for (const std::uint32_t leaf : kLeaves) add(&Joined::leaves, point_at(kWidth, leaf, kBudget));
  for (const double ms : kBudgets) add(&Joined::budgets, point_at(kWidth, kLeaf, ms));

  run_in_rounds("joined shadows", options.repetitions, trials, [&](JoinedTrial& trial) { run(trial, subject, options); });
  Joined joined;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    trials[i].point.cull_ms = bench::median(trials[i].cull_ms);
    (joined.*curves[i]).push_back(trials[i].point);
  }
  return joined;
}

}  // namespace occlude::experiments
