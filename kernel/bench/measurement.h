// SPDX-License-Identifier: MIT
// What subjects cost on workloads, and how often they are wrong.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "measure.h"
#include "subject.h"
#include "workloads.h"

namespace occlude::bench {

/// A subject on a workload.
struct Measurement {
  std::string subject, workload;
  std::vector<double> ns;  ///< a box, one number a round
  std::size_t wrong = 0;   ///< boxes answered wrongly
  bool gjk = false;        ///< as of the subject
};

/// The exact answer for each of the boxes.
[[nodiscard]] std::vector<kernel::Relation> exact_answers(const Workload& workload);

/// Every subject on every workload, in the same rounds; workload by workload.
[[nodiscard]] std::vector<Measurement> measure(std::span<const Workload> workloads, std::span<const Subject> subjects,
                                               std::size_t rounds, const Progress& progress);

}  // namespace occlude::bench
