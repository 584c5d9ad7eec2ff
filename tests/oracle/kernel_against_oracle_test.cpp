// SPDX-License-Identifier: MIT
// The kernel held against the oracle on every family of degenerate cases.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iterator>
#include <string>
#include <variant>
#include <vector>

#include "occlude/fuzz/cases.h"
#include "occlude/kernel/overlap.h"
#include "occlude/oracle/oracle.h"

namespace {

using namespace occlude;

using Polygon = std::vector<kernel::Vec3>;

/// What the kernel and the oracle answer so far: polygons and axis-aligned boxes.
bool is_answered(const fuzz::Case& c) {
  return std::holds_alternative<Polygon>(c.occluder) && std::holds_alternative<kernel::Aabb>(c.box);
}

kernel::ShadowFrustumResult make_frustum(const fuzz::Case& c) {
  return kernel::ShadowFrustum::make(c.viewpoint, std::get<Polygon>(c.occluder), c.near);
}

kernel::Decision overlap(const kernel::ShadowFrustum& frustum, const fuzz::Box& box) {
  return kernel::overlap_certified(frustum, std::get<kernel::Aabb>(box));
}

kernel::Decision conservative(const kernel::ShadowFrustum& frustum, const fuzz::Box& box) {
  return kernel::conservative_certified(frustum, std::get<kernel::Aabb>(box));
}

oracle::Point point(const kernel::Vec3& v) { return {v.x, v.y, v.z}; }

oracle::Answer exact_answer(const fuzz::Case& c, const std::optional<kernel::SupportPlane>& support) {
  oracle::Near near{c.near == kernel::Near::farthest ? oracle::Near::Kind::farthest : oracle::Near::Kind::surface, {}, {}};
  if (support) near = {oracle::Near::Kind::plane, point(support->normal), point(support->point)};
  std::vector<oracle::Point> loop;
  for (const kernel::Vec3& v : std::get<Polygon>(c.occluder)) loop.push_back(point(v));
  const auto& box = std::get<kernel::Aabb>(c.box);
  return oracle::relation({point(c.viewpoint.value), !c.viewpoint.is_eye()}, loop, near, {point(box.min), point(box.max)});
}

class Family : public testing::TestWithParam<fuzz::Family> {};

TEST_P(Family, CertifiedEqualsOracle) {
  const char* const requested = std::getenv("OCCLUDE_SEED");
  const std::uint64_t base = requested ? std::stoull(requested) : 1;
  constexpr std::uint64_t kCases = 4000;
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

std::vector<fuzz::Family> answered_families() {
  std::vector<fuzz::Family> families;
  std::ranges::copy_if(fuzz::families(), std::back_inserter(families),
                       [](fuzz::Family family) { return is_answered(fuzz::make_case(family, 0)); });
  return families;
}

INSTANTIATE_TEST_SUITE_P(All, Family, testing::ValuesIn(answered_families()),
                         [](const auto& family) { return std::string(fuzz::name(family.param)); });

}  // namespace
