// SPDX-License-Identifier: MIT
// One answer of the kernel's against one of the oracle's, for questions that a case file cannot hold.
#pragma once

#include <string_view>

#include "answers.h"
#include "report.h"

namespace occlude::fuzz {

/// Counts the case; a difference is a finding. `what` is the question in a few words, `family` and `seed` make it again.
inline void judge(Report& report, std::string_view family, std::uint64_t seed, std::string_view what,
                  kernel::Relation certified, kernel::Stage stage, const oracle::Answer& truth) {
  ++report.tally.cases;
  const kernel::Relation right = relation_of(truth.relation);
  report.tally.count(right, stage);
  if (truth.refusal.empty() && certified == right) return;
  ++report.tally.disagreements;
  report.findings.push_back({std::string(family), seed,
                             std::string(what) + ": certified: " + text(certified) +
                                 ", the oracle: " + (truth.refusal.empty() ? text(right) : truth.refusal),
                             std::nullopt, ""});
}

}  // namespace occlude::fuzz
