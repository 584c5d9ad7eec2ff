// SPDX-License-Identifier: MIT
#include "occlude/culler/preprocess.h"

#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <mutex>
#include <utility>

#include "bounds.h"
#include "depth_complexity.h"
#include "occlude/culler/culler.h"
#include "occlude/culler/parallel.h"

namespace occlude::culler {
namespace {

/// Uniform in [0, 1), of a counter (SplitMix64, Steele and others 2014).
double uniform(std::uint64_t counter) {
  std::uint64_t z = counter * 0x9e3779b97f4a7c15U;
  z = (z ^ (z >> 30U)) * 0xbf58476d1ce4e5b9U;
  z = (z ^ (z >> 27U)) * 0x94d049bb133111ebU;
  return static_cast<double>((z ^ (z >> 31U)) >> 11U) * 0x1p-53;
}

double fraction(double x) { return x - std::floor(x); }

/// Viewpoint number `n` of a region, in the unit cube.
glm::dvec3 viewpoint(const SampleConfig& samples, std::size_t region, std::size_t n) {
  const auto random = [&](std::uint64_t key, std::uint64_t axis) {
    return uniform(((samples.seed * 0x10001U + region) * 0x10001U + key) * 3 + axis + 1);
  };
  if (samples.pattern == SampleConfig::Pattern::random) return {random(n, 0), random(n, 1), random(n, 2)};
  // Powers of the inverse of g, the real root of g^4 = g + 1: the golden ratio's like in three dimensions.
  constexpr double kRoot = 1.22074408460575947536;
  const auto step = [&](double power, std::uint64_t axis) {
    return fraction(random(0, axis) + static_cast<double>(n) * power);
  };
  return {step(1 / kRoot, 0), step(1 / (kRoot * kRoot), 1), step(1 / (kRoot * kRoot * kRoot), 2)};
}

/// What the occluders listed by a region hide on average, in the order of its list.
void sample(const Culler& culler, const SampleConfig& samples, std::size_t region, std::span<float> hidden,
            const Checkpoint& checkpoint) {
  const OccluderLists& lists = culler.occluders().lists();
  const auto listed = lists.list(region).occluders;
  const kernel::Aabb box = lists.partition().box(region);
  const glm::dvec3 corner = to_glm(box.min), size = to_glm(box.max) - corner;
  for (std::size_t n = 0; n < samples.viewpoints; ++n) {
    checkpoint();
    const glm::dvec3 eye = corner + size * viewpoint(samples, region, n);
    for (const auto& [occluder, polygons] : best_together(culler.hierarchy(), culler.occluders(), listed, eye)) {
      const auto at = static_cast<std::size_t>(std::ranges::lower_bound(listed, occluder) - listed.begin());
      hidden[at] += static_cast<float>(polygons) / static_cast<float>(samples.viewpoints);
    }
  }
}

}  // namespace

Preprocess preprocess(const PolygonSoup& soup, const BuildConfig& config, const SampleConfig& samples,
                      const std::function<void(std::size_t done, std::size_t all)>& progress, const Checkpoint& checkpoint) {
  const Culler culler(soup, config, checkpoint);
  Preprocess result{config, culler.hierarchy().layout(), culler.occluders().lists().stored()};
  if (samples.viewpoints == 0) return result;
  result.lists.hidden.assign(result.lists.occluders.size(), 0);
  std::mutex mutex;
  std::size_t done = 0;
  const std::size_t regions = culler.occluders().lists().partition().regions();
  const auto sample_region = [&](std::size_t region) {
    const std::size_t first = result.lists.first[region], count = result.lists.first[region + 1] - first;
    if (count != 0) sample(culler, samples, region, std::span(result.lists.hidden).subspan(first, count), checkpoint);
    if (!progress) return;
    const std::lock_guard lock(mutex);
    progress(++done, regions);
  };
  parallel_for(regions, sample_region, checkpoint);
  return result;
}

}  // namespace occlude::culler
