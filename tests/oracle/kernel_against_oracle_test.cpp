// SPDX-License-Identifier: MIT
// The kernel held against the oracle on every family of degenerate cases.
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <string>
#include <variant>
#include <vector>

#include "occlude/fuzz/cases.h"
#include "occlude/kernel/overlap.h"
#include "occlude/oracle/oracle.h"
#include "oracle/judged.h"

namespace {

using namespace occlude;

using Polygon = std::vector<kernel::Vec3>;

kernel::ShadowFrustumResult make_frustum(const fuzz::Case& c) {
  if (const auto* polygon = std::get_if<Polygon>(&c.occluder)) {
    return kernel::ShadowFrustum::make(c.viewpoint, *polygon, c.near);
  }
  const auto made = kernel::ConvexPolytope::make(std::get<kernel::Polytope>(c.occluder));
  if (!made.polytope) return {std::nullopt, made.refusal};
  return kernel::ShadowFrustum::make(c.viewpoint, *made.polytope, c.near);
}

kernel::Decision overlap(const kernel::ShadowFrustum& frustum, const fuzz::Box& box) {
  return std::visit([&](const auto& kind) { return kernel::overlap_certified(frustum, kind); }, box);
}

kernel::Decision conservative(const kernel::ShadowFrustum& frustum, const fuzz::Box& box) {
  return std::visit([&](const auto& kind) { return kernel::conservative_certified(frustum, kind); }, box);
}

/// The near side of the question that the oracle is to judge.
oracle::Near near_of(const fuzz::Case& c, const std::optional<kernel::SupportPlane>& support) {
  return support ? oracle::judged(*support) : oracle::judged(c.near);
}

oracle::Answer exact_answer(const fuzz::Case& c, const std::optional<kernel::SupportPlane>& support) {
  return oracle::relation(oracle::judged(c.viewpoint), oracle::judged(c.occluder), near_of(c, support),
                          oracle::judged(c.box));
}

class Family : public testing::TestWithParam<fuzz::Family> {};

TEST_P(Family, CertifiedEqualsOracle) {
  const char* const requested = std::getenv("OCCLUDE_SEED");
  const std::uint64_t base = requested ? std::stoull(requested) : 1;
  constexpr std::uint64_t kCases = 1000;
  std::array<std::size_t, 3> answers{};
  std::array<std::size_t, 2> stages{};
  for (std::uint64_t i = 0; i < kCases; ++i) {
    const std::uint64_t seed = base * kCases + i;
    SCOPED_TRACE("family " + std::string(fuzz::name(GetParam())) + ", seed " + std::to_string(seed));
    const fuzz::Case c = fuzz::make_case(GetParam(), seed);
    const auto made = make_frustum(c);
    const auto support = made.frustum ? made.frustum->support_plane() : std::nullopt;
    const oracle::Answer exact = exact_answer(c, support);
    ASSERT_EQ(made.frustum.has_value(), exact.refusal.empty()) << exact.refusal << " / " << kernel::to_string(made.refusal);
    if (!made.frustum) continue;
    const kernel::Decision decision = overlap(*made.frustum, c.box);
    ASSERT_EQ(static_cast<int>(decision.relation), static_cast<int>(exact.relation));
    const kernel::Decision planes = conservative(*made.frustum, c.box);
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

}  // namespace
