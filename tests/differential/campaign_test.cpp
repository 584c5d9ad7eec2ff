// SPDX-License-Identifier: MIT
// The result of a campaign does not depend on how its groups are dealt. A campaign stops when it is told to.
#include "differential/campaign.h"

#include <gtest/gtest.h>

namespace occlude::fuzz {
namespace campaign_test {

bool for_ever(std::uint64_t) { return true; }

/// Every third group has a finding. What a group counts depends on its seed.
const std::vector<Experiment> kExperiments{
    {"some",
     [](std::uint64_t seed, Report& report) {
       report.tally.cases += kGroup;
       report.tally.relations[seed % 3] += seed;
       if (seed % 3 != 0) return;
       ++report.tally.disagreements;
       report.findings.push_back({"certified", "a finding"});
     }},
    {"none", [](std::uint64_t, Report& report) { report.tally.cases += kGroup; }},
};

void expect_same(const std::vector<Report>& a, const std::vector<Report>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].tally, b[i].tally);
    ASSERT_EQ(a[i].findings.size(), b[i].findings.size());
    for (std::size_t f = 0; f < a[i].findings.size(); ++f) EXPECT_EQ(a[i].findings[f].seed, b[i].findings[f].seed);
  }
}

TEST(Campaign, CountsEveryRoundOfEveryExperiment) {
  const auto reports = run({.seed = 5, .rounds = 100, .jobs = 1}, kExperiments, for_ever);
  EXPECT_EQ(reports[0].tally.cases, 100 * kGroup);
  EXPECT_EQ(reports[1].tally.cases, 100 * kGroup);
  EXPECT_EQ(reports[0].tally.disagreements, 33U);
  ASSERT_EQ(reports[0].findings.size(), kKeptFindings);
  EXPECT_EQ(reports[0].findings.front().seed, 6U);
  EXPECT_EQ(reports[0].findings.front().family, "some");
  EXPECT_EQ(reports[0].findings.back().seed, 6U + 3 * (kKeptFindings - 1));
}

TEST(Campaign, IsTheSameForAnyNumberOfJobs) {
  const auto alone = run({.seed = 7, .rounds = 200, .jobs = 1}, kExperiments, for_ever);
  expect_same(alone, run({.seed = 7, .rounds = 200, .jobs = 4}, kExperiments, for_ever));
}

TEST(Campaign, IsTheSumOfItsParts) {
  const auto whole = run({.seed = 7, .rounds = 101, .jobs = 1}, kExperiments, for_ever);
  std::vector<Report> sum(kExperiments.size());
  for (const Campaign& campaign : {Campaign{7, 40, 2}, Campaign{47, 1, 2}, Campaign{48, 60, 2}}) {
    auto part = run(campaign, kExperiments, for_ever);
    for (std::size_t e = 0; e < sum.size(); ++e) add(sum[e], std::move(part[e]));
  }
  expect_same(whole, sum);
}

TEST(Campaign, StopsWhenTold) {
  const auto until_found = [](std::uint64_t findings) { return findings == 0; };
  const auto reports = run({.seed = 1, .rounds = 1'000'000, .jobs = 1}, kExperiments, until_found);
  EXPECT_EQ(reports[0].tally.disagreements, 1U);
  EXPECT_EQ(reports[0].findings[0].seed, 3U);
}

/// Runs all experiments for real: nothing is wrong, and any number of jobs gives the same table.
TEST(Campaign, FamiliesAgreeWithTheOracle) {
  const std::vector<Experiment>& all = experiments();
  const auto one = run({.seed = 11, .rounds = 3, .jobs = 1}, all, for_ever);
  const auto two = run({.seed = 11, .rounds = 3, .jobs = 2}, all, for_ever);
  expect_same(one, two);
  for (std::size_t e = 0; e < all.size(); ++e) {
    EXPECT_GE(one[e].tally.cases, 3 * kGroup) << all[e].name;
    EXPECT_EQ(one[e].tally.disagreements, 0U) << all[e].name << ": " << one[e].findings[0].what;
  }
}

}  // namespace campaign_test
}  // namespace occlude::fuzz
