// SPDX-License-Identifier: MIT
// The benchmark of the kernel: the cost of its tests, certified and plain, and of the tests of other projects.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "measurement.h"
#include "peer_results.h"
#include "table1.h"
#include "workloads.h"

namespace occlude::bench {

struct Options {
  std::size_t boxes = 32'768;  ///< per workload
  std::size_t repetitions = 15;
  std::uint64_t seed = kDefaultSeed;
  std::string peers;  ///< the program that measures other projects' tests; empty for none
};

struct WorkloadSummary {
  std::string name, about;
  std::size_t inside = 0, partial = 0, outside = 0;  ///< numbers of boxes by exact answer
};

struct Result {
  Options options;
  std::vector<WorkloadSummary> workloads;
  std::vector<std::string> subjects;
  std::vector<Measurement> measurements;
  std::string fastest_gjk;         ///< the fastest GJK subject on `random`; empty where none is installed
  std::vector<PeerSummary> peers;  ///< all known peers, installed or not
  std::string peers_fault;         ///< why the program of the peers gave no results; empty when it gave them
  std::vector<Cost> costs;
};

/// Calls `progress` for the rounds of the kernel's tests, and then for as many rounds of the peers.
[[nodiscard]] Result run(const Options& options, const Progress& progress);

/// The measurement of a subject on a workload, or nullptr.
[[nodiscard]] const Measurement* find(const Result& result, std::string_view subject, std::string_view workload);

/// REQUIRES: `values` is not empty.
[[nodiscard]] double median(std::vector<double> values);

/// The median of value i divided by reference i. REQUIRES: as many values as references, and not none.
[[nodiscard]] double median_ratio(std::vector<double> values, const std::vector<double>& references);

/// The median over the rounds of the time of `subject` divided by that of `reference`. REQUIRES: both have the same rounds.
[[nodiscard]] double ratio(const Measurement& subject, const Measurement& reference);

}  // namespace occlude::bench
