// SPDX-License-Identifier: MIT
#include "model/outer_box.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <random>

#include "occlude/kernel/half_space.h"
#include "occlude/kernel/validity.h"
#include "scenes.h"

namespace outer_box_test {

using namespace occlude;
using namespace occlude::culler;
using kernel::Aabb;
using kernel::Obb;
using kernel::Vec3;

constexpr std::uint32_t kSeed = 20260;

/// Whether the axis-aligned box holds the oriented one, exactly: whether that is inside six half-spaces.
bool holds(const Aabb& outer, const Obb& box) {
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 up{}, down{};
    up[axis] = 1;
    down[axis] = -1;
    for (const kernel::HalfSpace& h : {kernel::HalfSpace{up, -outer.min[axis]}, {down, outer.max[axis]}}) {
      if (kernel::relation(h, box, kernel::Arithmetic::certified) != kernel::Relation::inside) return false;
    }
  }
  return true;
}

TEST(OuterBox, HoldsTheBoxExactlyAndIsLegal) {
  std::mt19937 random(kSeed);
  const auto number = [&] {
    const double magnitude = std::ldexp(uniform(random, 1, 2), static_cast<int>(random() % 190) - 95);
    return random() % 5 == 0 ? 0 : random() % 2 == 0 ? magnitude : -magnitude;
  };
  for (int i = 0; i < 20000; ++i) {
    Obb box{{number(), number(), number()}, {}};
    for (Vec3& edge : box.half_edges) edge = {number(), number(), number()};
    // Some numbers have similar magnitudes, so that they cancel.
    if (i % 2 == 0) box = {random_vector(random, -1, 1), {random_vector(random, -1, 1), random_vector(random, -1, 1), {}}};
    if (i % 4 == 0) box.center = {box.half_edges[0].x + box.half_edges[1].x, 0, box.half_edges[0].z};
    const Aabb outer = outer_box(box);
    ASSERT_EQ(kernel::check(outer), kernel::Refusal::none) << "seed " << kSeed;
    ASSERT_TRUE(holds(outer, box)) << "seed " << kSeed;
  }
}

TEST(OuterBox, IsTightAndRefusedWhereItIsNotLegal) {
  const Aabb outer = outer_box(Obb{{1, 2, 3}, {{{1, 1, 0}, {-1, 1, 0}, {0, 0, 1}}}});
  for (int axis = 0; axis < 3; ++axis) {
    const double half = axis == 2 ? 1 : 2, middle = axis + 1;
    EXPECT_NEAR(outer.min[axis], middle - half, 1e-14);
    EXPECT_NEAR(outer.max[axis], middle + half, 1e-14);
  }
}

TEST(OuterBox, RoundsWhatIsTooNearToZeroOutwards) {
  const Aabb outer = outer_box(Aabb{{-0x1p-200, 0x1p-101, 0}, {0x1p-101, 1, 0x1p-1000}});
  EXPECT_EQ(outer, (Aabb{{-0x1p-100, 0, 0}, {0x1p-100, 1, 0x1p-100}}));
}

}  // namespace outer_box_test
