// SPDX-License-Identifier: MIT
// Signs of planes in integers, against expansions.
#include "grid_sign.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>

#include "box_plane.h"

namespace grid_sign_test {

using namespace occlude::kernel;

constexpr std::uint32_t kSeed = 20261124;

int exact_sign(const ExactPlane& plane, const Vec3& x) { return ExactArithmetic::sign(value<ExactArithmetic>(plane, x)); }

int exact_extremal(const ExactPlane& plane, const Aabb& box, int direction) {
  ExactArithmetic exact;
  const auto n = normal<ExactArithmetic>(plane);
  const PlaneCoefficients<ExactArithmetic> coefficients{n, -dot(n, difference<ExactArithmetic>(plane.origin, {}))};
  return extremal_sign(exact, coefficients, {}, box, direction);
}

/// Coordinates of a kind.
class Coordinates {
 public:
  Coordinates(std::mt19937_64& random, int kind) : random_(random), kind_(kind) {}

  double operator()() {
    const auto integer = [&](std::int64_t most) {
      return static_cast<double>(static_cast<std::int64_t>(random_() % static_cast<std::uint64_t>(2 * most + 1)) - most);
    };
    switch (kind_) {
      case 0:
        return integer(4);  // zeros are common
      case 1:
        return integer(300) / 100;  // decimal
      case 2:
        return integer(1000000) / 1000;  // decimal, of many magnitudes
      case 3:
        return std::ldexp(integer(std::int64_t{1} << 52U), -50);  // all bits
      case 4:
        return std::ldexp(integer(8), static_cast<int>(random_() % 100) - 50);
      default:
        return std::ldexp(integer(std::int64_t{1} << 52U), static_cast<int>(random_() % 90) - 100);
    }
  }
  Vec3 vector() {
    const double x = (*this)(), y = (*this)(), z = (*this)();
    return {x, y, z};
  }

 private:
  std::mt19937_64& random_;
  int kind_;
};

TEST(GridSign, IsThatOfExpansions) {
  std::mt19937_64 random(kSeed);
  std::array<std::size_t, 3> seen{};
  std::size_t none = 0;
  for (int i = 0; i < 60000; ++i) {
    Coordinates coordinate(random, i % 6);
    ExactPlane plane{random() % 4 == 0, coordinate.vector(), coordinate.vector(), coordinate.vector(), {}, {}};
    plane.b_from = plane.origin = plane.a_from;  // as in the planes of a shadow
    // Vertices of boxes often share coordinates with what the plane was laid through.
    Vec3 x = coordinate.vector();
    for (int axis = 0; axis < 3; ++axis) {
      if (random() % 2 == 0) x[axis] = std::array{plane.a_to, plane.b_to, plane.origin}[random() % 3][axis];
    }
    const auto sign = grid_sign(plane, x);
    if (!sign) {
      ++none;
      continue;
    }
    ASSERT_EQ(*sign, exact_sign(plane, x)) << "seed " << kSeed << " case " << i;
    ++seen[static_cast<std::size_t>(*sign + 1)];
    Aabb box;
    for (int axis = 0; axis < 3; ++axis) {
      const auto [low, high] = std::minmax({x[axis], random() % 4 == 0 ? x[axis] : coordinate()});
      box.min[axis] = low;
      box.max[axis] = high;
    }
    for (const int direction : {-1, 1}) {
      const auto extremal = grid_extremal_sign(plane, box, direction);
      if (extremal) {
        ASSERT_EQ(*extremal, exact_extremal(plane, box, direction)) << "seed " << kSeed << " case " << i;
      }
    }
  }
  EXPECT_GT(std::ranges::min(seen), 1000U);  // all signs
  EXPECT_GT(none, 100U);                     // and numbers that are too far apart
  EXPECT_LT(none, 10000U);
}

/// The largest determinants that fit: an odd number at the bottom, and the largest at the top, with one and with two digits.
TEST(GridSign, HoldsAtTheLimitsOfItsDigits) {
  for (const int bits : {53, 58, 59, 60, 61, 118, 119, 120}) {
    const double large = std::ldexp(0x1.fffffffffffffp0, bits - 1);  // less than 2^bits
    for (int signs = 0; signs < 512; ++signs) {
      const auto at = [&](int k) { return (signs >> k & 1) != 0 ? large : -large; };
      // Differences are twice as large as coordinates.
      const ExactPlane plane{false,      {at(0), at(1), at(2)},   {-at(0), -at(1), -at(2)}, {at(3), at(4), at(5)},
                             {1, 0, -1}, {-at(6), -at(7), -at(8)}};
      const Vec3 x{at(6), at(7), at(8)};
      const auto sign = grid_sign(plane, x);
      ASSERT_EQ(sign.has_value(), bits <= 119) << bits;
      if (sign) {
        ASSERT_EQ(*sign, exact_sign(plane, x)) << bits << ' ' << signs;
      }
    }
  }
}

/// Points beside a plane by the last place of a coordinate.
TEST(GridSign, SeesTheLastPlace) {
  std::mt19937_64 random(kSeed);
  for (int i = 0; i < 2000; ++i) {
    Coordinates coordinate(random, 1 + i % 2);
    const Vec3 o = coordinate.vector(), a = coordinate.vector();
    const ExactPlane upright{false, a, o, {o.x, o.y, o.z + 1}, o, o};
    for (const double t : {0.0, 1.0}) {
      Vec3 x = t == 0 ? o : a;
      if (x.x == 0) continue;  // next to 0 there is nothing legal
      x.z = coordinate();
      const auto on = grid_sign(upright, x);
      x.x = std::nextafter(x.x, 1e9);
      const auto beside = grid_sign(upright, x);
      ASSERT_TRUE(on && beside);
      ASSERT_EQ(*on, 0) << i;
      ASSERT_EQ(*beside, exact_sign(upright, x)) << i;
      if (o.y != a.y) {
        ASSERT_NE(*beside, 0) << i;
      }
    }
  }
}

TEST(GridSign, OfZerosAlone) {
  EXPECT_EQ(grid_sign({}, {}), 0);
  EXPECT_EQ(grid_extremal_sign({}, {}, 1), 0);
  EXPECT_EQ(grid_sign({true, {1, 0, 0}, {}, {}, {}, {}}, {-0.0, 5, 5}), 0);
}

}  // namespace grid_sign_test
