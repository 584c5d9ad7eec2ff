// SPDX-License-Identifier: MIT
// A shadow that is prepared for many boxes answers like a new shadow for each box, whatever was asked before.
#include <gtest/gtest.h>

#include <string>
#include <utility>
#include <vector>

#include "cases/to_oracle.h"
#include "occlude/fuzz/cases.h"
#include "occlude/oracle/oracle.h"
#include "oracle/vocabulary.h"

namespace occlude::oracle {
namespace shadow_test {

using fuzz::to_oracle;

class ShadowOfFamily : public testing::TestWithParam<fuzz::Family> {};

/// Asks about boxes that touch this frustum, and about boxes of other cases of the family.
TEST_P(ShadowOfFamily, KeepsNoTraceOfOtherBoxes) {
  constexpr std::uint64_t kBoxes = 12;
  std::vector<fuzz::Case> cases;
  for (std::uint64_t seed = 0; seed < kBoxes; ++seed) cases.push_back(fuzz::make_case(GetParam(), seed));
  for (const fuzz::Case& c : cases) {
    const Viewpoint view = to_oracle(c.viewpoint);
    const Occluder occluder = to_oracle(c.occluder);
    const Near near = to_oracle(c.near);
    Shadow shadow(view, occluder, near);
    for (const fuzz::Case& other : cases) {
      const Box box = to_oracle(other.box);
      const Answer alone = relation(view, occluder, near, box), kept = shadow.relation(box);
      ASSERT_EQ(kept.refusal, alone.refusal);
      ASSERT_EQ(kept.relation, alone.relation);
      ASSERT_EQ(shadow.refute_cull(box), refute_shadow_cull(view, occluder, near, box));
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, ShadowOfFamily, testing::ValuesIn(fuzz::families().begin(), fuzz::families().end()),
                         [](const auto& family) { return std::string(fuzz::name(family.param)); });

TEST(Shadow, NamesTheFirstFaultOfShadowAndBox) {
  const Aabb good{{-1, -1, 2}, {1, 1, 3}}, bad{{1, 1, 3}, {-1, -1, 2}};
  const std::string not_finite = "a number is not finite", reversed = "the box has min > max";

  Shadow infinite({{0, kInfinity, 0}, false}, kSquare, kFarthest);
  EXPECT_EQ(infinite.refusal(), not_finite);
  EXPECT_EQ(infinite.relation(bad).refusal, not_finite);

  Shadow flat({{1, 1, 1}, false}, kSquare, kFarthest);
  EXPECT_EQ(flat.refusal(), "the eye lies in the polygon's plane");
  EXPECT_EQ(flat.relation(good).refusal, flat.refusal());
  EXPECT_EQ(flat.relation(bad).refusal, reversed);
  EXPECT_EQ(flat.refute_cull(bad), reversed);

  Shadow blind(kOrigin, kSquare, {Near::Kind::plane, {0, 0, kNan}, {0, 0, 1}});
  EXPECT_EQ(blind.refusal(), not_finite);
  EXPECT_EQ(blind.relation(bad).refusal, reversed);

  Shadow sound(kOrigin, kSquare, kSurface);
  EXPECT_EQ(sound.refusal(), "");
  EXPECT_EQ(sound.relation(bad).refusal, reversed);
  EXPECT_EQ(sound.relation(Aabb{{-1, below(0x1p-100), 2}, {1, 1, 3}}).refusal, "a coordinate is out of range");
  EXPECT_EQ(sound.relation(good).relation, kInside);
}

TEST(Shadow, Moves) {
  Shadow square(kOrigin, kSquare, kSurface), diamond(kOrigin, kDiamond, kSurface);
  const Aabb at_square{{1, 1, 1}, {1, 1, 1}};  // a corner of the square, on the diamond's edge
  const Aabb at_diamond{{2, 0, 1}, {2, 0, 1}};
  EXPECT_EQ(square.relation(at_diamond).relation, kOutside);
  square = std::move(diamond);
  EXPECT_EQ(square.relation(at_diamond).relation, kInside);
  EXPECT_EQ(square.relation(at_square).relation, kInside);
}

}  // namespace shadow_test
}  // namespace occlude::oracle
