// SPDX-License-Identifier: MIT
// How a model is prepared, and what its occluders hide, as sampled from each region (section 4.1). What was sampled is
// heuristics: nothing in it can make an answer wrong. Reading order: 10.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

#include "occlude/culler/checkpoint.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/culler/occluder_set.h"

namespace occlude::culler {

/// How a model is prepared.
struct BuildConfig {
  Hierarchy::Config hierarchy = {};
  OccluderSet::Config occluders = {};
  OccluderLists::Config lists = {};
};

/// How depth complexity is sampled (section 4, criterion 2). The same seed gives the same samples.
struct SampleConfig {
  enum class Pattern {
    even,    ///< a sequence of low discrepancy (Roberts 2018), shifted from region to region
    random,  ///< independent points
  };
  Pattern pattern = Pattern::even;
  /// Viewpoints in each region; 0: nothing is sampled. Takes minutes for a large model. Worth much only to frames that have
  /// no past (culler/README.md).
  std::size_t viewpoints = 0;
  std::uint64_t seed = 1;
};

class Culler;

/// What the occluders that regions [first, end) list hide, in the order of their lists: that part of `hidden` of
/// OccluderLists::Stored. On all processors.
[[nodiscard]] std::vector<float> sample_regions(const Culler& culler, const SampleConfig& samples, std::size_t first,
                                                std::size_t end, const Checkpoint& checkpoint = {});

/// Prepares the model and samples what its occluders hide: the culler of this soup with OccluderLists::Stored::hidden. Runs
/// on all processors; the result does not depend on their number. While sampling, calls progress(done, all), if given, after
/// each of all regions: on any thread, one call at a time. What it or `checkpoint` throws stops the work and is thrown on.
/// Throws also as the constructor of Culler.
[[nodiscard]] Culler preprocess(PolygonSoup soup, const BuildConfig& config, const SampleConfig& samples,
                                const std::function<void(std::size_t done, std::size_t all)>& progress = {},
                                const Checkpoint& checkpoint = {});

}  // namespace occlude::culler
