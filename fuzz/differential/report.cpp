// SPDX-License-Identifier: MIT
#include "report.h"

#include <algorithm>
#include <iterator>

namespace occlude::fuzz {

Tally& Tally::operator+=(const Tally& other) {
  cases += other.cases;
  refused += other.refused;
  for (std::size_t i = 0; i < relations.size(); ++i) relations[i] += other.relations[i];
  for (std::size_t i = 0; i < stages.size(); ++i) stages[i] += other.stages[i];
  judged_twice += other.judged_twice;
  lines_of_sight += other.lines_of_sight;
  disagreements += other.disagreements;
  planes_asked += other.planes_asked;
  undecided += other.undecided;
  others_asked += other.others_asked;
  plain += other.plain;
  float32 += other.float32;
  fused += other.fused;
  return *this;
}

void sign(Report& report, const std::string& family, std::uint64_t seed) {
  for (Finding& finding : report.findings) {
    finding.family = family;
    finding.seed = seed;
  }
}

void add(Report& whole, Report&& part) {
  whole.tally += part.tally;
  whole.core_seconds += part.core_seconds;
  std::vector<Finding>& findings = whole.findings;
  std::ranges::move(part.findings, std::back_inserter(findings));
  std::ranges::stable_sort(findings, {}, &Finding::seed);
  if (findings.size() > kKeptFindings) findings.resize(kKeptFindings);
}

}  // namespace occlude::fuzz
