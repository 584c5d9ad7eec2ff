// SPDX-License-Identifier: MIT
// The same seed gives the same cases and the same counts, with every compiler, because findings are made again from their
// seed.
#include <gtest/gtest.h>

#include <cstdint>

#include "differential/campaign.h"
#include "differential/experiment.h"

namespace occlude::fuzz {
namespace golden_test {

/// FNV-1a over the numbers of a tally.
std::uint64_t hash_of(const Tally& t) {
  std::uint64_t hash = 0xcbf29ce484222325U;
  for (const std::uint64_t number :
       {t.cases, t.refused, t.relations[0], t.relations[1], t.relations[2], t.stages[0], t.stages[1], t.judged_twice,
        t.lines_of_sight, t.planes_asked, t.undecided, t.plain.culls, t.plain.draws, t.float32.culls, t.float32.draws,
        t.fused.culls, t.fused.draws}) {
    hash = (hash ^ number) * 0x100000001b3U;
  }
  return hash;
}

TEST(Golden, ExperimentsCountWhatTheyDid) {
  Tally all;
  for (const Report& report : run({.seed = 1, .rounds = 20, .jobs = 2}, experiments(), [](auto) { return true; })) {
    EXPECT_EQ(report.tally.disagreements, 0U);
    all += report.tally;
  }
  EXPECT_EQ(hash_of(all), 0x642153cd9e6e6ac5U) << std::hex << hash_of(all) << " of " << std::dec << all.cases << " cases";
}

}  // namespace golden_test
}  // namespace occlude::fuzz
