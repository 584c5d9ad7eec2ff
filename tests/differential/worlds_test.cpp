// SPDX-License-Identifier: MIT
// Worlds in which something was wrong once.
#include <gtest/gtest.h>

#include <cstdint>

#include "differential/report.h"
#include "differential/rows.h"

namespace occlude::fuzz {
namespace worlds_test {

/// In these, objects were hidden from several eyes together with others, and not by their own boxes.
TEST(WorldsOnceWrong, CullsOfSeveralObjectsFromSeveralEyesAreProved) {
  for (const std::uint64_t seed : {588578U, 595033U, 604900U}) {
    Report report;
    run_worlds(seed, report);
    for (const Finding& found : report.findings) ADD_FAILURE() << "seed " << seed << ": " << found.what;
    EXPECT_GT(report.tally.cases, 0U);
  }
}

}  // namespace worlds_test
}  // namespace occlude::fuzz
