// SPDX-License-Identifier: MIT
// What can be found out about a model once and used again (section 4.1): the order of its tree, the lists of its regions and
// what occluders hide as seen from there. Heuristics and order alone: nothing of it can make an answer wrong. Reading
// order: 10.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

#include "occlude/culler/checkpoint.h"
#include "occlude/culler/hierarchy.h"
#include "occlude/culler/occluder_set.h"

namespace occlude::culler {

/// How a model is prepared.
struct BuildConfig {
  Hierarchy::Config hierarchy = {};
  OccluderSet::Config occluders = {};
  OccluderGrid::Config grid = {};
};

/// How depth complexity is sampled (section 4, criterion 2).
struct SampleConfig {
  enum class Pattern {
    even,    ///< a sequence of low discrepancy (Roberts 2018), shifted from region to region
    random,  ///< independent points
  };
  Pattern pattern = Pattern::even;
  /// In each region; 0: none. Minutes for a large model, worth much only to frames that have no past (culler/README.md).
  std::size_t viewpoints = 0;
  std::uint64_t seed = 1;
};

struct Preprocess {
  BuildConfig config;
  Hierarchy::Layout layout;
  OccluderGrid::Lists lists;
};

/// Prepares the model and samples what its occluders hide, on all processors; the same for any number of them. Calls
/// progress(done, all), if given, after each region that is sampled, from any thread, one call at a time. What it or
/// `checkpoint` throws stops the work and comes out. Throws std::invalid_argument as Culler does.
[[nodiscard]] Preprocess preprocess(const PolygonSoup& soup, const BuildConfig& config, const SampleConfig& samples,
                                    const std::function<void(std::size_t done, std::size_t all)>& progress = {},
                                    const Checkpoint& checkpoint = {});

}  // namespace occlude::culler
