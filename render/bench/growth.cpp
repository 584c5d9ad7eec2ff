// SPDX-License-Identifier: MIT
#include "growth.h"

#include <utility>

#include "bench.h"
#include "occlude/culler/culler.h"
#include "occlude/render/city.h"
#include "occlude/render/progress.h"
#include "occlude/render/stopwatch.h"
#include "pass.h"
#include "peak_memory.h"
#include "rounds.h"
#include "tiled_city.h"
#include "trends.h"

namespace occlude::experiments {
namespace {

/// 20,000, 50,000, 100,000, 200,000, ... up to the largest, which is the last.
std::vector<std::size_t> sizes(std::size_t largest) {
  std::vector<std::size_t> sizes;
  for (std::size_t power = render::kSmallestCity / 2; power < largest; power *= 10) {
    for (const std::size_t factor : {1U, 2U, 5U}) {
      if (factor * power >= render::kSmallestCity && factor * power < largest) sizes.push_back(factor * power);
    }
  }
  sizes.push_back(largest);
  return sizes;
}

/// A model and its measurements, one number per round.
struct CityTrial {
  std::size_t size;
  GrowthPoint point;
  std::vector<double> build_s, cull_ms, near_cull_ms, peak_bytes, held_bytes;
};

void note(std::vector<double>& values, std::optional<std::size_t> bytes, std::size_t polygons) {
  if (bytes) values.push_back(static_cast<double>(*bytes) / static_cast<double>(polygons));
}

void run(CityTrial& trial, const render::City& tile, const Options& options) {
  render::City city = tiled(tile, trial.size);
  render::check_interrupt();
  const std::size_t polygons = city.soup.size();
  const PeakMemory memory;
  const render::Stopwatch stopwatch;
  const culler::Culler culler(std::move(city.soup), options.walk.build, render::check_interrupt);
  culler.prepare(options.walk.cull.method, render::check_interrupt);
  trial.build_s.push_back(stopwatch.seconds());
  note(trial.peak_bytes, memory.peak_bytes(), polygons);
  note(trial.held_bytes, memory.held_bytes(), polygons);
  const Pass pass = pass_along(culler, city.path, options.walk, options.walk.cull);
  trial.cull_ms.push_back(pass.cull_ms);
  render::CameraPath near_path = city.path;
  near_path.far = kNearSight;
  trial.near_cull_ms.push_back(pass_along(culler, near_path, options.walk, options.walk.cull).cull_ms);
  trial.point.near_in_view = polygons_in_view(culler, near_path, options.walk);
  trial.point.polygons = polygons;
  trial.point.in_view = polygons_in_view(culler, city.path, options.walk);
  trial.point.drawn = pass.drawn;
}

std::optional<double> median_of(const std::vector<double>& values) {
  if (values.empty()) return std::nullopt;
  return bench::median(values);
}

GrowthPoint point_of(const CityTrial& trial) {
  GrowthPoint point = trial.point;
  point.build_s = bench::median(trial.build_s);
  point.cull_ms = bench::median(trial.cull_ms);
  point.near_cull_ms = bench::median(trial.near_cull_ms);
  point.peak_bytes = median_of(trial.peak_bytes);
  point.held_bytes = median_of(trial.held_bytes);
  return point;
}

std::optional<double> exponent(const std::vector<GrowthPoint>& points, double GrowthPoint::*time) {
  std::vector<double> x, y;
  for (const GrowthPoint& point : points) {
    x.push_back(static_cast<double>(point.polygons));
    y.push_back(point.*time);
  }
  return fitted_exponent(x, y);
}

}  // namespace

Growth measure_growth(const Options& options) {
  const render::City tile = render::generate_city(render::kSmallestCity, options.seed);
  std::vector<CityTrial> trials;
  for (const std::size_t size : sizes(options.largest)) trials.push_back({size, {}, {}, {}, {}, {}, {}});
  run_in_rounds("growth: models", options.repetitions, trials, [&](CityTrial& trial) { run(trial, tile, options); });
  Growth growth;
  for (const CityTrial& trial : trials) growth.points.push_back(point_of(trial));
  growth.build_exponent = exponent(growth.points, &GrowthPoint::build_s);
  growth.cull_exponent = exponent(growth.points, &GrowthPoint::cull_ms);
  growth.near_cull_exponent = exponent(growth.points, &GrowthPoint::near_cull_ms);
  return growth;
}

}  // namespace occlude::experiments
