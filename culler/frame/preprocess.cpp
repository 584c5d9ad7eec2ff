// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <glm/vec3.hpp>
#include <mutex>
#include <utility>

#include "base/parallel.h"
#include "frame/culler_access.h"
#include "frame/sampling.h"
#include "frusta/depth_complexity.h"
#include "model/bounds.h"

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
  const OccluderLists& lists = occluders_of(culler).lists();
  const auto listed = lists.list(region).occluders;
  const kernel::Aabb box = lists.partition().box(region);
  const glm::dvec3 corner = to_glm(box.min), size = to_glm(box.max) - corner;
  for (std::size_t n = 0; n < samples.viewpoints; ++n) {
    checkpoint();
    const glm::dvec3 eye = corner + size * viewpoint(samples, region, n);
    for (const auto& [occluder, polygons] : best_together(culler.hierarchy(), occluders_of(culler), listed, eye)) {
      const auto at = static_cast<std::size_t>(std::ranges::lower_bound(listed, occluder) - listed.begin());
      hidden[at] += static_cast<float>(polygons) / static_cast<float>(samples.viewpoints);
    }
  }
}

/// Calls done() after each region, on any thread.
template <class Done>
std::vector<float> sample_each(const Culler& culler, const SampleConfig& samples, std::size_t first, std::size_t end,
                               const Checkpoint& checkpoint, Done&& done) {
  const OccluderLists& lists = occluders_of(culler).lists();
  std::vector<std::size_t> begin{0};  // of each region's list
  for (std::size_t region = first; region < end; ++region) {
    begin.push_back(begin.back() + lists.list(region).occluders.size());
  }
  std::vector<float> hidden(begin.back());
  const auto sample_region = [&](std::size_t i) {
    const auto of_region = std::span(hidden).subspan(begin[i], begin[i + 1] - begin[i]);
    if (!of_region.empty()) sample(culler, samples, first + i, of_region, checkpoint);
    done();
  };
  parallel_for(end - first, sample_region, checkpoint);
  return hidden;
}

}  // namespace

std::vector<float> sample_regions(const Culler& culler, const SampleConfig& samples, std::size_t first, std::size_t end,
                                  const Checkpoint& checkpoint) {
  culler.prepare(Method::frusta, checkpoint);
  return sample_each(culler, samples, first, end, checkpoint, [] {});
}

Culler preprocess(PolygonSoup soup, const BuildConfig& config, const SampleConfig& samples,
                  const std::function<void(std::size_t done, std::size_t all)>& progress, const Checkpoint& checkpoint) {
  Culler culler(std::move(soup), config, checkpoint);
  culler.prepare(Method::frusta, checkpoint);
  if (samples.viewpoints == 0) return culler;
  std::mutex mutex;
  std::size_t done = 0;
  const std::size_t regions = occluders_of(culler).lists().partition().regions();
  return with_hidden(culler, sample_each(culler, samples, 0, regions, checkpoint, [&] {
                       if (!progress) return;
                       const std::lock_guard lock(mutex);
                       progress(++done, regions);
                     }));
}

}  // namespace occlude::culler
