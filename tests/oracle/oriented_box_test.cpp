// SPDX-License-Identifier: MIT
// The oracle on oriented boxes.
#include <gtest/gtest.h>

#include <array>
#include <utility>

#include "occlude/fuzz/cases.h"
#include "occlude/fuzz/random.h"
#include "occlude/oracle/oracle.h"
#include "oracle/vocabulary.h"

namespace occlude::oracle {
namespace oriented_box_test {

constexpr Point kZero{};

TEST(OrientedBox, RefusesNumbersThatAreNotLegal) {
  const auto refusal = [](const Obb& box) { return relation(kOrigin, kSquare, kSurface, box).refusal; };
  EXPECT_EQ(refusal({{0, 0, kNan}, {}}), "a number is not finite");
  EXPECT_EQ(refusal({{0, 0, 2}, {{kZero, kZero, {0, kInfinity, 0}}}}), "a number is not finite");
  EXPECT_EQ(refusal({{0, 0, 2}, {{kZero, {0x1p-101, 0, 0}, kZero}}}), "a coordinate is out of range");
  EXPECT_EQ(refusal({{0, 0, 2}, {{kZero, {0x1p101, 0, 0}, kZero}}}), "a coordinate is out of range");
  EXPECT_EQ(refusal({{0, 0, 2}, {{kZero, {0x1p-100, 0, 0}, {0x1p100, 0, 0}}}}), "");
}

/// The same box with its axes in another order and direction. All numbers are integers, so nothing is rounded.
Obb oriented(const Aabb& box, fuzz::Random& random) {
  Obb result;
  std::array<std::size_t, 3> order{0, 1, 2};
  for (std::size_t k = 2; k > 0; --k) std::swap(order[k], order[random.index(k + 1)]);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    result.center[axis] = (box.min[axis] + box.max[axis]) / 2;
    const double half = (box.max[axis] - box.min[axis]) / 2;
    result.half_edges[order[axis]][axis] = random.chance(0.5) ? half : -half;
  }
  return result;
}

Point to_point(const kernel::Vec3& v) { return {v.x, v.y, v.z}; }

TEST(OrientedBox, AlongTheAxesIsAnAxisAlignedBox) {
  using fuzz::Family;
  fuzz::Random random(7);
  std::array<int, 3> counts{};
  for (const Family family : {Family::lattice, Family::ray_touch, Family::collinear, Family::eye_in_box}) {
    for (std::uint64_t seed = 0; seed < 1000; ++seed) {
      const fuzz::Case made = fuzz::make_case(family, seed);
      const Viewpoint view{to_point(made.viewpoint.value), !made.viewpoint.is_eye()};
      Loop loop;
      for (const kernel::Vec3& v : std::get<std::vector<kernel::Vec3>>(made.occluder)) loop.push_back(to_point(v));
      const auto& [min, max] = std::get<kernel::Aabb>(made.box);
      const Aabb box{to_point(min), to_point(max)};
      for (const Near& near : {kFarthest, kSurface}) {
        const Answer aligned = relation(view, loop, near, box), turned = relation(view, loop, near, oriented(box, random));
        ASSERT_EQ(aligned.refusal.empty(), turned.refusal.empty()) << fuzz::name(family) << " " << seed;
        ASSERT_EQ(aligned.relation, turned.relation) << fuzz::name(family) << " " << seed;
        if (aligned.refusal.empty()) ++counts[static_cast<std::size_t>(aligned.relation)];
      }
    }
  }
  for (const int count : counts) EXPECT_GT(count, 200);
}

TEST(OrientedBox, ProofsOfCulls) {
  const auto box = [](double height) { return Obb{{0, 0, height}, {{{1, 1, 0}, {1, -1, 0}, {0, 0, 1}}}}; };
  EXPECT_EQ(refute_shadow_cull(kOrigin, kSquare, kSurface, box(3)), "");
  EXPECT_EQ(refute_shadow_cull(kOrigin, kSquare, kSurface, box(below(3))), "the box is not inside the frustum");
  const Obb standing{{0, 0, 2}, {{{0.5, 0.5, 0}, {0.5, -0.5, 0}, {0, 0, 1}}}};
  EXPECT_EQ(refute_shadow_cull(kOrigin, kSquare, kSurface, standing), "the box touches the near plane");
  // 1.3 - 0.3 in doubles is slightly more than 1, and would be rounded to 1.
  EXPECT_EQ(refute_shadow_cull(kOrigin, kSquare, kSurface, Obb{{0, 0, 1.3}, {{kZero, kZero, {0, 0, 0.3}}}}), "");
  EXPECT_EQ(refute_view_cull({1, 0, 0, -3}, box(0)), "");
  EXPECT_EQ(refute_view_cull({1, 0, 0, -2}, box(0)), "the box reaches the plane");
  EXPECT_EQ(refute_view_cull({1, 0, 0, -3}, Obb{{kNan, 0, 0}, {}}), "a number is not finite");
}

TEST(OrientedBox, ContainsItsPointsExactly) {
  const Obb skew{{1, 1, 1}, {{{2, 0, 0}, {1, 1, 0}, {0, 0, 3}}}};
  EXPECT_TRUE(contains(skew, {4, 2, 4}));
  EXPECT_TRUE(contains(skew, {-2, 0, -2}));
  EXPECT_FALSE(contains(skew, {above(4), 2, 4}));
  EXPECT_FALSE(contains(skew, {4, 2, above(4)}));
  EXPECT_FALSE(contains(skew, {4, 0, 1}));
  const Obb flat{{1, 1, 1}, {{{2, 0, 0}, {1, 1, 0}, {-1, -1, 0}}}};
  EXPECT_TRUE(contains(flat, {5, 3, 1}));
  EXPECT_FALSE(contains(flat, {above(5), 3, 1}));
  EXPECT_FALSE(contains(flat, {1, 1, above(1)}));
  EXPECT_FALSE(contains(flat, {1, 1, below(1)}));
  EXPECT_TRUE(contains(Obb{{1, 1, 1}, {}}, {1, 1, 1}));
  EXPECT_FALSE(contains(Obb{{1, 1, 1}, {}}, {1, above(1), 1}));
  EXPECT_FALSE(contains(Obb{{1, kNan, 1}, {}}, {1, 1, 1}));
  EXPECT_FALSE(contains(Obb{{1, 1, 1}, {{{kInfinity, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}, {1, 1, 1}));
  EXPECT_TRUE(contains(Obb{{1, 1, 1}, {{{1e308, 1e308, 0}, {-1e308, 1e308, 0}, {0, 0, 1e-308}}}}, {1e308, 1, 1}));
  EXPECT_FALSE(contains(Obb{{1, 1, 1}, {{{1e308, 1e308, 0}, {-1e308, 1e308, 0}, {0, 0, 1e-308}}}}, {1e308, 1, above(1)}));
  EXPECT_TRUE(contains(Aabb{{0, 0, 0}, {1, 1, 1}}, {0, 1, 0.5}));
  EXPECT_FALSE(contains(Aabb{{0, 0, 0}, {1, 1, 1}}, {0, above(1), 0.5}));
}

}  // namespace oriented_box_test
}  // namespace occlude::oracle
