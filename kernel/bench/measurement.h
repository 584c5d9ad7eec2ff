// SPDX-License-Identifier: MIT
// The cost of subjects on workloads, and how often they are wrong.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "measure.h"
#include "subject.h"
#include "workloads.h"

namespace occlude::bench {

/// The measurement of a subject on a workload.
struct Measurement {
  std::string subject, workload;
  std::vector<double> ns;  ///< time per box, one number per round
  std::size_t wrong = 0;   ///< boxes answered wrongly
  bool gjk = false;        ///< the same as Subject::gjk
};

/// The exact answer for each of the boxes.
[[nodiscard]] std::vector<kernel::Relation> exact_answers(const Workload& workload);

/// Measures every subject on every workload, all in the same rounds. The result is ordered by workload.
[[nodiscard]] std::vector<Measurement> measure(std::span<const Workload> workloads, std::span<const Subject> subjects,
                                               std::size_t rounds, const Progress& progress);

}  // namespace occlude::bench
