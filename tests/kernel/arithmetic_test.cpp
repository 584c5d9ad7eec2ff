// SPDX-License-Identifier: MIT
// The number types of the kernel: expansions against integers, running errors and filter bounds against expansions.
#include "arithmetic.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>

#include "box_plane.h"
#include "occlude/kernel/half_space.h"
#include "occlude/kernel/overlap.h"

namespace arithmetic_test {

using namespace occlude::kernel;
__extension__ typedef __int128 Integer;

int sign(Integer x) { return (x > 0) - (x < 0); }

constexpr std::uint32_t kSeed = 20261;

TEST(Expansion, AgreesWithIntegers) {
  std::mt19937_64 random(kSeed);
  for (int i = 0; i < 20000; ++i) {
    // 40 bits each: products of three still fit in 128 bits, and far exceed the 53 bits of a double.
    std::int64_t v[6];
    for (auto& x : v) x = static_cast<std::int64_t>(random() >> 24U) - (std::int64_t{1} << 39U);
    if (i % 3 == 0) v[3] = v[0], v[4] = v[1], v[5] = v[2] + (i % 2);  // differences that cancel to 0 or 1
    const auto e = [&](int k) { return Expansion(static_cast<double>(v[k])); };
    const Expansion exact = e(0) * e(1) * e(2) - e(3) * e(4) * e(5);
    const Integer truth = Integer{v[0]} * v[1] * v[2] - Integer{v[3]} * v[4] * v[5];
    ASSERT_EQ(exact.sign(), sign(truth)) << "seed " << kSeed << " case " << i;
  }
}

TEST(Expansion, KeepsTheLastBit) {
  std::mt19937_64 random(kSeed);
  for (int i = 0; i < 20000; ++i) {
    Expansion factors[3];  // odd numbers of 53 bits: the product has a bit at 1 and nearly 160 above it
    for (Expansion& x : factors) x = Expansion(static_cast<double>(random() >> 11U | 1U));
    const auto& [a, b, c] = factors;
    for (const int difference : {-1, 0, 1}) {
      ASSERT_EQ((a * b * c + Expansion(difference) - c * b * a).sign(), difference) << "seed " << kSeed << " case " << i;
    }
  }
}

TEST(Expansion, DifferencesAreExact) {
  const Expansion tiny = Expansion::difference(1, 0x1p-100) - Expansion(1);
  EXPECT_EQ((tiny + Expansion(0x1p-100)).sign(), 0);
  EXPECT_EQ((tiny + Expansion(0x1.0000000000001p-100)).sign(), 1);
  EXPECT_EQ(Expansion::difference(3, 3).sign(), 0);
}

/// A coordinate difference anywhere in the legal range, sometimes zero.
double wild(std::mt19937_64& random) {
  if (random() % 8 == 0) return 0;
  const double mantissa = 1 + static_cast<double>(random() >> 12U) * 0x1p-52;
  return std::ldexp(random() % 2 ? mantissa : -mantissa, static_cast<int>(random() % 60) - 30);
}

TEST(RunningError, BoundsTheError) {
  std::mt19937_64 random(kSeed);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    double x[8];
    for (double& v : x) v = wild(random);
    const auto evaluate = [&]<class A>(A) {
      const auto d = [&](int k) { return A::difference(x[k], x[k + 1]); };
      return d(0) * d(1) * d(2) - d(3) * d(4) * d(5) + d(6);
    };
    const RunningError approximate = evaluate(FilterArithmetic{});
    const Expansion error = evaluate(ExactArithmetic{}) - Expansion(approximate.value);
    const Expansion bound(approximate.error);
    ASSERT_GE((bound - error).sign(), 0) << "seed " << kSeed << " case " << i;
    ASSERT_GE((bound + error).sign(), 0) << "seed " << kSeed << " case " << i;
    // Finds how much of the bound is used: a bound ten times too large would be sound but useless.
    for (double part = 1; part > 0.01 && worst < part; part -= 0.01) {
      const Expansion share(approximate.error * part);
      if ((share - error).sign() < 0 || (share + error).sign() < 0) worst = part;
    }
  }
  std::printf("worst error: %.2f of the bound\n", worst);
  EXPECT_GT(worst, 0.1);
}

TEST(HalfSpace, DecidesExactlyOnThePlane) {
  // x + y + z = 0.3 at 0.1 + 0.1 + 0.1: the sum in doubles is 0.30000000000000004, and the exact sum exceeds the double 0.3
  // too.
  const HalfSpace h{{1, 1, 1}, -0.3};
  const Aabb touching{{-1, -1, -1}, {0.1, 0.1, 0.1}};
  EXPECT_EQ(relation(h, touching, Arithmetic::certified), Relation::partial);
  const HalfSpace thirds{{1, 1, 1}, -1};
  const double third = 1.0 / 3;  // below 1/3: three of them fall short of 1 by 2^-54, and round to 1
  EXPECT_EQ(relation(thirds, Aabb{{-1, -1, -1}, {third, third, third}}, Arithmetic::certified), Relation::outside);
  EXPECT_EQ(relation(thirds, Aabb{{-1, -1, -1}, {third, third, third}}, Arithmetic::plain), Relation::partial);
  EXPECT_EQ(relation(thirds, Aabb{{0.5, 0.25, 0.25}, {1, 1, 1}}, Arithmetic::certified), Relation::inside);
}

TEST(HalfSpace, BoundHoldsWhereTheSumCancels) {
  std::mt19937_64 random(kSeed);
  std::size_t misled = 0;
  for (int i = 0; i < 20000; ++i) {
    const auto coordinate = [&] { return 1 + static_cast<double>(random() >> 11U) * 0x1p-53; };
    const Vec3 n{coordinate(), -coordinate(), coordinate()}, x{coordinate(), coordinate(), -coordinate()};
    const double sum = n.x * x.x + n.y * x.y + n.z * x.z;
    const HalfSpace h{n, -sum * (1 + static_cast<double>(static_cast<int>(random() % 5) - 2) * 0x1p-52)};
    const auto product = [](double a, double b) { return Expansion(a) * Expansion(b); };
    const Expansion exact = product(n.x, x.x) + product(n.y, x.y) + product(n.z, x.z) + Expansion(h.offset);
    const Relation expected = exact.sign() >= 0 ? Relation::inside : Relation::outside;
    ASSERT_EQ(relation(h, Aabb{x, x}, Arithmetic::certified), expected) << "seed " << kSeed << " case " << i;
    misled += relation(h, Aabb{x, x}, Arithmetic::plain) != expected;
  }
  std::printf("plain is wrong on %zu of 20000 points at a plane\n", misled);
  EXPECT_GT(misled, 0U);
}

TEST(Operations, AFewDotProductsAPlaneAndNoCrossProductEver) {
  const std::vector<Vec3> wall{{2, -1, -1}, {2, 1, -1}, {2, 1, 1}, {2, -1, 1}};
  const auto frustum = *ShadowFrustum::make(Viewpoint::eye({0, 0, 0}), wall, Near::farthest).frustum;
  const auto overlap = occlude::kernel::Test::overlap;
  const Aabb before{{0.1, 0, 0}, {0.2, 0.1, 0.1}}, behind{{9, 0, 0}, {10, 1, 1}};
  // The paper's best case takes only the farthest vertex against the first plane. `certified` takes both centre and spread.
  EXPECT_EQ(count_operations(frustum, before, Arithmetic::plain, overlap).dot, 1U);
  EXPECT_EQ(count_operations(frustum, before, Arithmetic::certified, overlap).dot, 2U);
  for (const Arithmetic arithmetic : {Arithmetic::plain, Arithmetic::certified}) {
    EXPECT_EQ(count_operations(frustum, before, arithmetic, overlap).cross, 0U);
    const Operations all_planes = count_operations(frustum, behind, arithmetic, overlap);
    EXPECT_EQ(all_planes.dot, 10U);
    EXPECT_EQ(all_planes.cross, 0U);
  }
}

}  // namespace arithmetic_test
