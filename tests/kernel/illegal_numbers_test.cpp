// SPDX-License-Identifier: MIT
// Whatever doubles a box has, every question about it returns, and nothing is read or written out of bounds. The sanitizers
// and the checks of the standard library (presets dev and asan) would report it.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "arithmetic.h"
#include "kernel/cube.h"
#include "occlude/fuzz/random.h"
#include "occlude/kernel/batch.h"
#include "occlude/kernel/containment.h"
#include "occlude/kernel/cover.h"
#include "occlude/kernel/half_space.h"
#include "occlude/kernel/overlap.h"
#include "occlude/kernel/shadow_union.h"
#include "occlude/kernel/view_frustum.h"

namespace illegal_numbers_test {

using namespace occlude;
using namespace occlude::kernel;
using fuzz::Random;

using Limits = std::numeric_limits<double>;
constexpr std::array kNumbers{
    Limits::quiet_NaN(), Limits::infinity(), 1e308, 0x1p101, 2.0, 1.5, 1.0, 0x1p-101, 1e-300, Limits::denorm_min(), 0.0};

double number(Random& random) {
  const double x = kNumbers[random.index(kNumbers.size())];
  return random.chance(0.5) ? -x : x;
}
Vec3 vector(Random& random) {
  const double x = number(random), y = number(random);
  return {x, y, number(random)};
}

/// An expansion whose terms are all NaN has as many terms as its operands together. Finite numbers that are not legal may
/// need more than 32 terms, too.
TEST(IllegalNumbers, ExpansionsStayInTheirPlace) {
  Random random(7);
  for (int i = 0; i < 2000; ++i) {
    struct {
      Expansion sum;
      std::array<double, 128> after{};
    } place;
    for (int k = 0; k < 100; ++k) place.sum = place.sum + Expansion::difference(number(random), number(random));
    for (int k = 0; k < 4; ++k) place.sum = place.sum * (place.sum + Expansion(number(random)));
    static_cast<void>(place.sum.sign());
    ASSERT_EQ(place.after, (std::array<double, 128>{}));
  }
}

/// A sum that needs 35 terms, of which the lowest are dropped. Its sign is still that of the highest term.
TEST(IllegalNumbers, ALongSumStaysInItsPlace) {
  Expansion sum;
  for (int exponent = 1020; exponent >= -1020; exponent -= 60) sum = sum + Expansion(std::ldexp(1.0, exponent));
  EXPECT_EQ(sum.sign(), 1);
  EXPECT_EQ((-sum).sign(), -1);
}

TEST(IllegalNumbers, EveryQuestionComesBack) {
  const std::vector<Vec3> wall{{2, -1, -1}, {2, 1, -1}, {2, 1, 1}, {2, -1, 1}}, next{{2, 1, -1}, {2, 3, -1}, {2, 1, 1}};
  const std::vector<Cover::Polygon> polygons{wall, next};
  const ConvexPolytope polytope = *ConvexPolytope::make(cube({2, -1, -1})).polytope;
  Random random(8);
  std::size_t illegal = 0;
  for (const Viewpoint& view : {Viewpoint::eye({0, 0, 0}), Viewpoint::direction({1, 0, 0})}) {
    std::vector<ShadowFrustum> frusta;
    for (const Near near : {Near::surface, Near::farthest}) {
      frusta.push_back(*ShadowFrustum::make(view, wall, near).frustum);
      frusta.push_back(*ShadowFrustum::make(view, next, near).frustum);
      frusta.push_back(*ShadowFrustum::make(view, polytope, near).frustum);
    }
    const Cover cover = *Cover::make(view, polygons).cover;
    const FrustumBatch batch(frusta);
    for (int i = 0; i < 1000; ++i) {
      const Aabb aligned{vector(random), vector(random)};
      const Obb oriented{vector(random), {vector(random), vector(random), vector(random)}};
      const std::array half_spaces{HalfSpace{vector(random), number(random)}, HalfSpace{vector(random), number(random)},
                                   HalfSpace{vector(random), number(random)}};
      const auto ask = [&](const auto& box) {
        for (const ShadowFrustum& frustum : frusta) {
          for (const NearBoundary near : {NearBoundary::closed, NearBoundary::open}) {
            for (const kernel::Test test : {kernel::Test::overlap, kernel::Test::conservative}) {
              static_cast<void>(decide(frustum, box, Arithmetic::certified, test, near));
              static_cast<void>(decide(frustum, box, Arithmetic::plain, test, near));
            }
          }
        }
        static_cast<void>(overlap_certified(ShadowUnion{frusta[0], frusta[1]}, box, NearBoundary::open));
        static_cast<void>(relation(half_spaces[0], box, Arithmetic::certified));
        static_cast<void>(overlap_certified(half_spaces, box));
        const bool is_legal = check(box) == Refusal::none;
        illegal += !is_legal;
        if (!is_legal) {
          EXPECT_EQ(overlap_certified(cover, box).relation, Relation::partial);
        }
      };
      ask(aligned);
      ask(oriented);
      static_cast<void>(contains(oriented, aligned.min));
      std::vector<Relation> relations(frusta.size());
      overlap_certified(batch, aligned, NearBoundary::open, relations);
      const std::array boxes{aligned, Aabb{aligned.max, aligned.min}, Aabb{oriented.center, oriented.center}};
      std::array<Relation, 3> each{};
      overlap_certified(frusta[0], BoxBatch(boxes), NearBoundary::open, each);
    }
  }
  EXPECT_GT(illegal, 1000U);
}

}  // namespace illegal_numbers_test
