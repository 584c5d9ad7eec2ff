// SPDX-License-Identifier: MIT
// Compares the two oracles.
#include "occlude/oracle/second.h"

#include <gtest/gtest.h>

#include <string>

#include "cases/ask.h"
#include "cases/to_oracle.h"
#include "occlude/fuzz/cases.h"
#include "occlude/oracle/oracle.h"
#include "seed.h"

namespace occlude::oracle {
namespace second_test {

using fuzz::to_oracle;

class SecondOfFamily : public testing::TestWithParam<fuzz::Family> {};

TEST_P(SecondOfFamily, AgreesWithTheFirst) {
  const std::uint64_t base = occlude::seed_of(1);
  constexpr std::uint64_t kCases = 200;
  std::size_t answered = 0;
  for (std::uint64_t i = 0; i < kCases; ++i) {
    const std::uint64_t seed = base * kCases + i;
    SCOPED_TRACE("seed " + std::to_string(seed));
    const fuzz::Case c = fuzz::make_case(GetParam(), seed);
    const Viewpoint view = to_oracle(c.viewpoint);
    const Occluder occluder = to_oracle(c.occluder);
    const Near near = to_oracle(c.near, fuzz::make_frustum(c));
    const Box box = to_oracle(c.box);
    const Answer first = relation(view, occluder, near, box);
    if (!first.refusal.empty()) continue;
    const Answer other = second::relation(view, occluder, near, box);
    ASSERT_EQ(other.refusal, "");
    ASSERT_EQ(other.relation, first.relation);
    ++answered;
  }
  EXPECT_GT(answered, kCases / 2);
}

INSTANTIATE_TEST_SUITE_P(All, SecondOfFamily, testing::ValuesIn(fuzz::families().begin(), fuzz::families().end()),
                         [](const auto& family) { return std::string(fuzz::name(family.param)); });

}  // namespace second_test
}  // namespace occlude::oracle
