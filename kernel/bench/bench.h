// SPDX-License-Identifier: MIT
// The benchmark of the kernel: its tests, what they cost with and without certainty, and other projects' beside them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "measurement.h"
#include "peer_results.h"
#include "table1.h"
#include "workloads.h"

namespace occlude::bench {

struct Options {
  std::size_t boxes = 32'768;  ///< of each workload
  std::size_t repetitions = 15;
  std::uint64_t seed = kDefaultSeed;
  std::string peers;  ///< the program that measures other projects' tests; empty: none
};

struct WorkloadSummary {
  std::string name, about;
  std::size_t inside = 0, partial = 0, outside = 0;  ///< boxes, by the exact answer
};

struct Result {
  Options options;
  std::vector<WorkloadSummary> workloads;
  std::vector<std::string> subjects;
  std::vector<Measurement> measurements;
  std::string fastest_gjk;         ///< of the subjects that are of the GJK kind, on `random`; none where none is installed
  std::vector<PeerSummary> peers;  ///< all that we know of
  std::string peers_fault;         ///< why their program gave nothing, if there is one
  std::vector<Cost> costs;
};

/// Tells `progress` the rounds of the kernel's tests, and then those of the peers, as many again.
[[nodiscard]] Result run(const Options& options, const Progress& progress);

/// The measurement of a subject on a workload, if there is one.
[[nodiscard]] const Measurement* find(const Result& result, std::string_view subject, std::string_view workload);

/// REQUIRES: not empty.
[[nodiscard]] double median(std::vector<double> values);

/// The median over the rounds of how many times as long `subject` takes as `reference`. REQUIRES: the same rounds.
[[nodiscard]] double ratio(const Measurement& subject, const Measurement& reference);

}  // namespace occlude::bench
