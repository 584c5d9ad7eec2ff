// SPDX-License-Identifier: MIT
// Eight boxes against half-spaces are answered as one by one.
#include "occlude/kernel/box_block.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>

#include "occlude/kernel/half_space.h"

namespace {

using namespace occlude::kernel;

constexpr std::uint32_t kSeed = 17;

struct Counts {
  std::size_t inside = 0, outside = 0, partial = 0;
};

/// Expects of each asked box what relation() answers, and of the others nothing.
void expect_same(const HalfSpace& half_space, const BoxBlock& block, BoxBits asked, const BlockRelation& answer,
                 Counts& counts) {
  EXPECT_EQ((answer.inside | answer.outside) & ~asked, 0) << "not asked";
  for (unsigned i = 0; i < BoxBlock::kBoxes; ++i) {
    if ((asked >> i & 1U) == 0) continue;
    const Relation expected = relation(half_space, block.box(i), Arithmetic::certified);
    EXPECT_EQ((answer.inside >> i & 1) != 0, expected == Relation::inside) << "box " << i << ", seed " << kSeed;
    EXPECT_EQ((answer.outside >> i & 1) != 0, expected == Relation::outside) << "box " << i << ", seed " << kSeed;
    ++(expected == Relation::inside ? counts.inside : expected == Relation::outside ? counts.outside : counts.partial);
  }
}

class BoxBlockTest : public testing::Test {
 protected:
  /// A number on the grid of `step`, so that sums are often equal, moved by an ulp now and then.
  double number(double step) {
    const double x = step * (static_cast<double>(random_() % 17) - 8);
    const unsigned choice = random_() % 8;
    return choice == 0 ? std::nextafter(x, 100.0) : choice == 1 ? std::nextafter(x, -100.0) : x;
  }
  Vec3 point(double step) { return {number(step), number(step), number(step)}; }
  BoxBlock block(double step) {
    BoxBlock result;
    for (std::size_t i = 0; i < BoxBlock::kBoxes; ++i) {
      const Vec3 a = point(step), b = point(step);
      result.set(i, {{std::min(a.x, b.x), std::min(a.y, b.y), std::min(a.z, b.z)},
                     {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)}});
    }
    return result;
  }

  std::mt19937 random_{kSeed};
};

TEST_F(BoxBlockTest, AnswersAsOneByOneWhereBoxesTouch) {
  for (const double step : {1.0, 0.1, 1e-9}) {
    Counts counts;
    for (int round = 0; round < 3000; ++round) {
      const BoxBlock boxes = block(step);
      std::array<HalfSpace, 6> half_spaces;
      for (HalfSpace& h : half_spaces) h = {point(1), number(step)};
      std::array<BlockRelation, 6> answers{};
      const std::uint32_t which = random_() % 64;
      const auto asked = static_cast<BoxBits>(round % 2 == 0 ? 0xFFU : random_() % 256);
      relations(half_spaces, which, boxes, asked, answers);
      for (std::uint32_t k = 0; k < half_spaces.size(); ++k) {
        if ((which >> k & 1U) != 0) expect_same(half_spaces[k], boxes, asked, answers[k], counts);
      }
    }
    EXPECT_GT(counts.inside, 1000U);
    EXPECT_GT(counts.outside, 1000U);
    EXPECT_GT(counts.partial, 1000U);
  }
}

TEST_F(BoxBlockTest, LeavesWhatIsNotAskedAlone) {
  const std::array<HalfSpace, 2> half_spaces{HalfSpace{{1, 0, 0}, 0}, HalfSpace{{0, 1, 0}, 0}};
  std::array<BlockRelation, 2> answers{BlockRelation{1, 2}, BlockRelation{3, 4}};
  relations(half_spaces, 2, block(1), 0xFF, answers);
  EXPECT_EQ(answers[0].outside, 1);
  EXPECT_EQ(answers[0].inside, 2);
}

TEST_F(BoxBlockTest, ReturnsTheBoxesThatWereSet) {
  BoxBlock boxes;
  const Aabb box{{-1, -2, -3}, {4, 5, 6}};
  boxes.set(7, box);
  EXPECT_EQ(boxes.box(7), box);
  EXPECT_EQ(boxes.box(6), Aabb{});
}

}  // namespace
