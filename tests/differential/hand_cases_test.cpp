// SPDX-License-Identifier: MIT
// The hand cases as starting points of the fuzzer.
#include "hand_cases.h"

#include <gtest/gtest.h>

#include <vector>

#include "differential/experiment.h"
#include "differential/overlap.h"
#include "occlude/fuzz/neighbours.h"

namespace occlude::fuzz {
namespace hand_cases_test {

/// As a group of a family: the kernel in every way that it can be asked, against both oracles.
TEST(HandCases, AndTheirNeighboursAgreeWithTheOracle) {
  std::uint64_t seed = 0;
  Tally all;
  for (const HandCase& c : hand_cases()) {
    std::vector<Box> boxes{c.question.box};
    while (boxes.size() < kGroup) boxes.push_back(neighbour(c.question.box, seed * kGroup + boxes.size()));
    Report report;
    judge_overlap(c.question, boxes, seed++, report);
    for (const Finding& finding : report.findings) ADD_FAILURE() << c.id << ": " << finding.kind << ": " << finding.what;
    all += report.tally;
  }
  EXPECT_EQ(all.cases, kGroup * hand_cases().size());
  for (const std::uint64_t answers : all.relations) EXPECT_GT(answers, all.cases / 10);
}

}  // namespace hand_cases_test
}  // namespace occlude::fuzz
