// SPDX-License-Identifier: MIT
// Compares one answer of the kernel with one of the oracle, for questions that a case file cannot hold.
#pragma once

#include <optional>
#include <string>

#include "answers.h"
#include "occlude/fuzz/random.h"
#include "report.h"

namespace occlude::fuzz {

/// Whether a case is asked of the second oracle too. That is slow, so it is one case in a hundred.
[[nodiscard]] inline bool is_judged_twice(std::uint64_t number) { return Random(number).bits() % 100 == 0; }

/// Adds a finding about a question that a case file cannot hold.
inline void add_finding(Report& report, const std::string& kind, const std::string& what) {
  ++report.tally.disagreements;
  report.findings.push_back({kind, what});
}

/// Counts the case. A difference is a finding. `what` is the question in a few words. `stage` is empty when the answer has
/// none.
inline void judge(Report& report, const std::string& what, kernel::Relation certified, std::optional<kernel::Stage> stage,
                  const oracle::Answer& truth) {
  ++report.tally.cases;
  const kernel::Relation right = relation_of(truth.relation);
  ++report.tally.relations[static_cast<std::size_t>(right)];
  if (stage) ++report.tally.stages[static_cast<std::size_t>(*stage)];
  if (truth.refusal.empty() && certified == right) return;
  add_finding(report, "certified",
              what + ": " + text(certified) + ", the oracle: " + (truth.refusal.empty() ? text(right) : truth.refusal));
}

}  // namespace occlude::fuzz
