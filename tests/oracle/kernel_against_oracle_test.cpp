// SPDX-License-Identifier: MIT
// Compares the kernel with the oracle on every family of degenerate cases.
#include <gtest/gtest.h>

#include <array>
#include <string>

#include "cases/ask.h"
#include "cases/to_oracle.h"
#include "occlude/fuzz/cases.h"
#include "seed.h"

namespace kernel_against_oracle_test {

using namespace occlude;

oracle::Answer exact_answer(const fuzz::Case& c, const kernel::ShadowFrustumResult& made) {
  using fuzz::to_oracle;
  return oracle::relation(to_oracle(c.viewpoint), to_oracle(c.occluder), to_oracle(c.near, made), to_oracle(c.box));
}

class Family : public testing::TestWithParam<fuzz::Family> {};

TEST_P(Family, CertifiedEqualsOracle) {
  const std::uint64_t base = occlude::seed_of(1);
  constexpr std::uint64_t kCases = 1000;
  std::array<std::size_t, 3> answers{};
  std::array<std::size_t, 2> stages{};
  for (std::uint64_t i = 0; i < kCases; ++i) {
    const std::uint64_t seed = base * kCases + i;
    SCOPED_TRACE("family " + std::string(fuzz::name(GetParam())) + ", seed " + std::to_string(seed));
    const fuzz::Case c = fuzz::make_case(GetParam(), seed);
    const auto made = fuzz::make_frustum(c);
    const oracle::Answer exact = exact_answer(c, made);
    const bool is_taken = made.frustum && fuzz::check(c.box) == kernel::Refusal::none;
    ASSERT_EQ(is_taken, exact.refusal.empty()) << exact.refusal << " / " << kernel::to_string(made.refusal);
    if (!is_taken) continue;
    const kernel::Decision decision = fuzz::overlap(*made.frustum, c.box);
    ASSERT_EQ(static_cast<int>(decision.relation), static_cast<int>(exact.relation));
    const kernel::Decision planes = fuzz::conservative(*made.frustum, c.box);
    ASSERT_TRUE(planes.relation == decision.relation || planes.relation == kernel::Relation::partial);
    ASSERT_EQ(planes.relation == kernel::Relation::inside, decision.relation == kernel::Relation::inside);
    ++answers[static_cast<std::size_t>(decision.relation)];
    ++stages[static_cast<std::size_t>(decision.stage)];
  }
  std::printf("%-28s inside %5zu partial %5zu outside %5zu, filter %5zu exact %5zu\n",
              std::string(fuzz::name(GetParam())).c_str(), answers[0], answers[1], answers[2], stages[0], stages[1]);
  EXPECT_GT(answers[0] + answers[1] + answers[2], kCases / 2);
}

INSTANTIATE_TEST_SUITE_P(All, Family, testing::ValuesIn(fuzz::families().begin(), fuzz::families().end()),
                         [](const auto& family) { return std::string(fuzz::name(family.param)); });

}  // namespace kernel_against_oracle_test
