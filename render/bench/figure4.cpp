// SPDX-License-Identifier: MIT
#include "figure4.h"

#include <algorithm>
#include <functional>
#include <mutex>

#include "base/parallel.h"
#include "frame/culler_access.h"
#include "occlude/culler/culler.h"
#include "occlude/render/progress.h"
#include "occlude/render/stopwatch.h"
#include "pass.h"
#include "trends.h"

namespace occlude::experiments {
namespace {

using culler::Objective;

/// A way to choose occluders. A weight of 0 leaves a criterion out.
struct Mix {
  const char *name, *about;
  Objective objective;
  std::size_t probes = culler::CullOptions{}.probes;
};

bool needs_samples(const Mix& mix) { return mix.objective.depth_complexity != 0; }

/// Solid angle, depth complexity, coherence: the weights.
Objective weights(double solid_angle, double depth_complexity, double coherence) {
  return {Objective::Angle::area, solid_angle, depth_complexity, coherence};
}

std::vector<Mix> mixes(bool are_sampled) {
  std::vector<Mix> mixes{
      {"area_angle", "area-angle", weights(1, 0, 0)},
      {"solid_angle", "solid angle", {Objective::Angle::exact, 1, 0, 0}},
      {"depth_complexity", "depth complexity", weights(0, 1, 0)},
      {"area_angle_depth_complexity", "area-angle and depth complexity", weights(1, 1, 0)},
      {"coherence", "coherence", weights(0, 0, 1)},
      {"area_angle_coherence", "area-angle and coherence", weights(1, 0, 1)},
      {"area_angle_coherence_no_probes", "the same without probes", weights(1, 0, 1), 0},
      {"all_three", "all three", weights(1, 1, 1)},
  };
  if (!are_sampled) std::erase_if(mixes, needs_samples);
  return mixes;
}

/// The culler with sampled depth complexity.
culler::Culler sampled(const Subject& subject, const Options& options, const culler::BuildConfig& config) {
  const culler::SampleConfig samples{.viewpoints = options.samples};
  render::Watch watch("figure 4: sampled regions");
  return culler::preprocess(subject.soup, config, samples, std::ref(watch), render::check_interrupt);
}

}  // namespace

std::optional<double> share_at(const Figure4& figure, std::string_view name, std::size_t occluders) {
  const auto curve = std::ranges::find(figure.curves, name, &Curve::name);
  if (curve == figure.curves.end()) return std::nullopt;
  return curve->share[static_cast<std::size_t>(std::ranges::find(kOccluders, occluders) - kOccluders.begin())];
}

Figure4 measure_figure4(const Subject& subject, const Options& options) {
  Figure4 figure;
  const render::Stopwatch stopwatch;
  const bool are_sampled = options.samples != 0;
  culler::BuildConfig config = options.walk.build;
  config.lists.regions = static_cast<double>(options.regions);
  // One culler for all curves: those without depth complexity give it no weight.
  const culler::Culler culler =
      are_sampled ? sampled(subject, options, config) : culler::Culler(subject.soup, config, render::check_interrupt);
  culler.prepare(culler::Method::frusta, render::check_interrupt);
  figure.regions = occluders_of(culler).lists().partition().regions();
  if (are_sampled) figure.sampling_s = stopwatch.seconds();

  const double in_view = polygons_in_view(culler, subject.path, options.walk);
  const std::vector<Mix> all = mixes(are_sampled);
  for (const Mix& mix : all) figure.curves.push_back({mix.name, mix.about, {}, 0});
  // Nothing is timed, so all processors can work.
  render::Progress progress("figure 4: passes along the path", all.size() * kOccluders.size());
  std::mutex mutex;
  std::size_t done = 0;
  culler::parallel_for(all.size() * kOccluders.size(), [&](std::size_t i) {
    const std::size_t curve = i % all.size(), at = i / all.size();
    culler::CullOptions cull = options.walk.cull;
    cull.occluders = kOccluders[at];
    cull.objective = all[curve].objective;
    cull.probes = all[curve].probes;
    figure.curves[curve].share[at] = culled_share(in_view, pass_along(culler, subject.path, options.walk, cull).drawn);
    const std::lock_guard lock(mutex);
    progress.update(++done);
  });
  for (Curve& curve : figure.curves) curve.knee = kOccluders[knee(curve.share)];
  return figure;
}

}  // namespace occlude::experiments
