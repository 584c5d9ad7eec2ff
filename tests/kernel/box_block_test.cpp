// SPDX-License-Identifier: MIT
// Eight boxes against half-spaces and against shadows are answered as one by one.
#include "occlude/kernel/box_block.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "occlude/kernel/half_space.h"
#include "occlude/kernel/overlap.h"
#include "occlude/kernel/shadow_frustum.h"
#include "only_target.h"

namespace box_block_test {

using namespace occlude::kernel;

constexpr std::uint32_t kSeed = 17;

struct Counts {
  std::size_t inside = 0, outside = 0, partial = 0;
};

/// Expects of each asked box what relation() answers, and of the others nothing.
void expect_same(std::span<const HalfSpace> half_spaces, const BoxBlock& block, BoxBytes asked,
                 const BlockRelations& answers, Counts& counts) {
  EXPECT_EQ((answers.inside | answers.outside) & ~asked, 0U) << "not asked";
  for (unsigned place = 0; place < 64; ++place) {
    if ((asked >> place & 1U) == 0) continue;
    const Relation expected = relation(half_spaces[place / 8], block.box(place % 8), Arithmetic::certified);
    EXPECT_EQ((answers.inside >> place & 1U) != 0, expected == Relation::inside) << "place " << place << ", seed " << kSeed;
    EXPECT_EQ((answers.outside >> place & 1U) != 0, expected == Relation::outside)
        << "place " << place << ", seed " << kSeed;
    ++(expected == Relation::inside ? counts.inside : expected == Relation::outside ? counts.outside : counts.partial);
  }
}

/// On one of the instruction sets of this machine.
class BoxBlockTest : public testing::TestWithParam<std::int64_t> {
 protected:
  /// A number on the grid of `step`, so that sums are often equal, moved now and then: by an ulp, or by as little as floats
  /// can just tell, or not.
  double number(double step) {
    const double x = middle_ + step * (static_cast<double>(random_() % 17) - 8);
    const unsigned choice = random_() % 16;
    if (choice == 0) return std::nextafter(x, 100.0);
    if (choice == 1) return std::nextafter(x, -100.0);
    return choice < 5 ? x + step * std::ldexp(choice % 2 == 0 ? 1 : -1, -static_cast<int>(14 + random_() % 14)) : x;
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
  /// Boxes of at most an eighth of a step, which often are within a shadow.
  BoxBlock small_boxes(double step) {
    BoxBlock result;
    for (std::size_t i = 0; i < BoxBlock::kBoxes; ++i) {
      const Vec3 a = point(step);
      const auto end = [&](double x) { return x + step / 16 * static_cast<double>(random_() % 3); };
      result.set(i, {a, {end(a.x), end(a.y), end(a.z)}});
    }
    return result;
  }

  occlude::OnlyTarget target_{GetParam()};
  std::mt19937 random_{kSeed};
  double middle_ = 0;  ///< of the grid
};

TEST_P(BoxBlockTest, AnswersAsOneByOneWhereBoxesTouch) {
  for (const double step : {1.0, 0.1, 1e-9}) {
    Counts counts;
    for (int round = 0; round < 3000; ++round) {
      const BoxBlock boxes = block(step);
      std::array<HalfSpace, 8> half_spaces;
      for (HalfSpace& h : half_spaces) h = {point(1), number(step)};
      BoxBytes asked = 0;
      for (std::size_t k = 0; k < half_spaces.size(); ++k) {
        const std::uint32_t choice = random_() % 4;
        asked |= BoxBytes{choice == 0 ? 0U : choice == 1 ? random_() % 256 : 0xFFU} << 8 * k;
      }
      expect_same(half_spaces, boxes, asked, relations(half_spaces, boxes, asked), counts);
    }
    EXPECT_GT(counts.inside, 1000U);
    EXPECT_GT(counts.outside, 1000U);
    EXPECT_GT(counts.partial, 1000U);
  }
}

TEST_P(BoxBlockTest, NeedsNoHalfSpaceThatIsNotAskedAbout) {
  const std::array<HalfSpace, 2> half_spaces{HalfSpace{{1, 0, 0}, 0}, HalfSpace{{0, 1, 0}, -4}};
  BoxBlock boxes;
  boxes.set(3, {{1, 5, 1}, {2, 6, 2}});
  const BlockRelations answers = relations(half_spaces, boxes, BoxBytes{0x09} << 8);
  EXPECT_EQ(answers.outside, BoxBytes{0x01} << 8);
  EXPECT_EQ(answers.inside, BoxBytes{0x08} << 8);
}

TEST_P(BoxBlockTest, ReturnsTheBoxesThatWereSet) {
  BoxBlock boxes;
  const Aabb box{{-1, -2, -3}, {4, 5, 6}};
  boxes.set(7, box);
  EXPECT_EQ(boxes.box(7), box);
  EXPECT_EQ(boxes.box(6), Aabb{});
}

/// Expects of each box what conservative_certified() answers, where the filter knows it.
void expect_same(const ShadowFrustum& frustum, const BoxBlock& block, const BlockQuestions& questions, std::size_t k,
                 Counts& counts, std::size_t& unknown) {
  for (unsigned i = 0; i < BoxBlock::kBoxes; ++i) {
    const auto has = [&](BoxBytes answers) { return (boxes_of(answers, k) >> i & 1) != 0; };
    EXPECT_LE(has(questions.inside) + has(questions.outside) + has(questions.unknown), 1);
    if (has(questions.unknown)) {
      ++unknown;
      continue;
    }
    for (const NearBoundary near : {NearBoundary::open, NearBoundary::closed}) {
      const Relation expected = conservative_certified(frustum, block.box(i), near).relation;
      EXPECT_EQ(has(questions.inside), expected == Relation::inside) << "box " << i << ", seed " << kSeed;
      EXPECT_EQ(has(questions.outside), expected == Relation::outside) << "box " << i << ", seed " << kSeed;
      ++(expected == Relation::inside ? counts.inside : expected == Relation::outside ? counts.outside : counts.partial);
    }
  }
}

/// Shadows of triangles from several eyes and directions, in one block of questions. Some are so large that floats overflow.
TEST_P(BoxBlockTest, ShadowsAreAnsweredAsOneByOne) {
  Counts counts;
  std::size_t unknown = 0;
  for (int round = 0; round < 5000; ++round) {
    struct Grid {
      double step, middle = 0;
    };
    // The steps of the last are in the last places of the least numbers: as floats they are not normal, or nothing.
    constexpr std::array kGrids{Grid{1}, Grid{0.1}, Grid{1e-20}, Grid{1e20}, Grid{1e28}, Grid{0x1p-147, 0x1p-99}};
    const auto [step, middle] = kGrids[static_cast<std::size_t>(round) % kGrids.size()];
    middle_ = middle;
    std::vector<ShadowFrustum> frusta;
    while (frusta.size() < 12) {
      const Viewpoint viewpoint = random_() % 4 == 0 ? Viewpoint::direction(point(step)) : Viewpoint::eye(point(step));
      const std::vector<Vec3> loop{point(step), point(step), point(step)};
      auto made = ShadowFrustum::make(viewpoint, loop, random_() % 2 == 0 ? Near::surface : Near::farthest);
      if (made.frustum) frusta.push_back(std::move(*made.frustum));
    }
    std::vector<const ShadowFrustum*> pointers;
    for (const ShadowFrustum& frustum : frusta) pointers.push_back(&frustum);
    const BoxBlock boxes = round % 3 == 0 ? block(step) : small_boxes(step);
    BlockQuestions questions{};
    questions.count = 1 + static_cast<std::uint32_t>(random_() % BlockQuestions::kMost);
    for (std::size_t k = 0; k < questions.count; ++k)
      questions.frustum[k] = static_cast<std::uint32_t>(random_() % frusta.size());
    conservative_filter(pointers, boxes, questions);
    for (std::size_t k = 0; k < questions.count; ++k) {
      expect_same(frusta[questions.frustum[k]], boxes, questions, k, counts, unknown);
    }
    for (std::size_t k = questions.count; k < BlockQuestions::kMost; ++k) {
      EXPECT_EQ(boxes_of(questions.inside | questions.outside | questions.unknown, k), 0) << "not asked";
    }
  }
  EXPECT_GT(counts.inside, 50U);
  EXPECT_GT(counts.outside, 10000U);
  EXPECT_GT(counts.partial, 1000U);
  EXPECT_GT(unknown, 100U);
}

TEST_P(BoxBlockTest, AFrustumThatIsNoneStraddlesAll) {
  const ShadowFrustum none;
  const std::array<const ShadowFrustum*, 1> frusta{&none};
  BlockQuestions questions{};
  questions.count = 1;
  conservative_filter(frusta, block(1), questions);
  EXPECT_EQ(questions.inside | questions.outside | questions.unknown, 0U);
}

INSTANTIATE_TEST_SUITE_P(Targets, BoxBlockTest, testing::ValuesIn(hwy::SupportedAndGeneratedTargets()),
                         [](const auto& target) { return std::string(hwy::TargetName(target.param)); });

TEST(BoxBytes, CountTheBoxesOfAllQuestions) {
  EXPECT_EQ(count(BoxBytes{0}), 0U);
  EXPECT_EQ(count(~BoxBytes{0}), 64U);
  EXPECT_EQ(count(for_all(0b1010'0001)), 24U);
  EXPECT_EQ(boxes_of(BoxBytes{0x42} << 24, 3), 0x42);
}

}  // namespace box_block_test
