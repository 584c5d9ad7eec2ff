// SPDX-License-Identifier: MIT
// A frustum that was never made hides nothing. The answer to every question about it is `partial`.
#include <gtest/gtest.h>

#include <array>
#include <utility>
#include <vector>

#include "kernel/cube.h"
#include "occlude/kernel/batch.h"
#include "occlude/kernel/overlap.h"
#include "occlude/kernel/polytope_overlap.h"
#include "occlude/kernel/shadow_frustum.h"
#include "occlude/kernel/shadow_union.h"
#include "occlude/kernel/view_cone.h"

namespace no_frustum_test {

using namespace occlude;
using namespace occlude::kernel;

constexpr std::array kBoundaries{NearBoundary::closed, NearBoundary::open};
const std::vector<Vec3> kWall{{2, -1, -1}, {2, 1, -1}, {2, 1, 1}, {2, -1, 1}};
/// A box behind the wall, a point, the viewpoint and a box about it.
const std::vector<Aabb> kBoxes{{{3, -0.5, -0.5}, {4, 0.5, 0.5}}, {{5, 1, 1}, {5, 1, 1}}, {}, {{-1, -1, -1}, {1, 1, 1}}};

ShadowFrustum wall() { return *ShadowFrustum::make(Viewpoint::eye({0, 0, 0}), kWall, Near::surface).frustum; }

ShadowFrustum refused() {
  ShadowFrustum frustum;
  EXPECT_EQ(frustum.assign(Viewpoint::eye({2, 0, 0}), kWall, Near::surface), Refusal::eye_in_plane);
  return frustum;
}

/// A frustum that was moved from: its planes are elsewhere.
ShadowFrustum moved_from() {
  ShadowFrustum frustum = wall();
  const ShadowFrustum elsewhere = std::move(frustum);
  EXPECT_FALSE(elsewhere.is_none());
  return frustum;  // NOLINT(bugprone-use-after-move): the test is about what is left
}

class NoFrustum : public testing::TestWithParam<ShadowFrustum (*)()> {
 protected:
  const ShadowFrustum none_ = GetParam()();
};

template <class Box>
void expect_partial(const ShadowFrustum& none, const Box& box) {
  for (const NearBoundary near : kBoundaries) {
    for (const Arithmetic arithmetic : {Arithmetic::plain, Arithmetic::certified}) {
      for (const Test test : {Test::overlap, Test::conservative}) {
        EXPECT_EQ(decide(none, box, arithmetic, test, near).relation, Relation::partial);
        EXPECT_EQ(count_operations(none, box, arithmetic, test).dot, 0U);
      }
    }
  }
}

TEST_P(NoFrustum, HasNoPlanes) {
  EXPECT_TRUE(none_.is_none());
  EXPECT_EQ(none_.plane_count(), 0U);
  EXPECT_EQ(none_.near_count(), 0U);
}

TEST_P(NoFrustum, NoBoxIsInside) {
  for (const Aabb& box : kBoxes) {
    expect_partial(none_, box);
    expect_partial(none_, Obb{box.min, {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}});
    expect_partial(none_, Obb{box.min, {}});
  }
}

TEST_P(NoFrustum, BatchesAnswerAlike) {
  const BoxBatch boxes(kBoxes);
  const ShadowFrustum real = wall();
  const std::vector<ShadowFrustum> alone{none_}, among{real, none_, real};
  for (const NearBoundary near : kBoundaries) {
    std::vector<Relation> relation(kBoxes.size(), Relation::inside);
    conservative_certified(none_, boxes, near, relation);
    EXPECT_EQ(relation, std::vector<Relation>(kBoxes.size(), Relation::partial));
    relation.assign(kBoxes.size(), Relation::inside);
    overlap_certified(none_, boxes, near, relation);
    EXPECT_EQ(relation, std::vector<Relation>(kBoxes.size(), Relation::partial));
    for (const Aabb& box : kBoxes) {
      for (const auto* frusta : {&alone, &among}) {
        std::vector<Relation> conservative(frusta->size()), overlap(frusta->size());
        conservative_certified(FrustumBatch(*frusta), box, near, conservative);
        overlap_certified(FrustumBatch(*frusta), box, near, overlap);
        for (std::size_t i = 0; i < frusta->size(); ++i) {
          EXPECT_EQ(conservative[i], conservative_certified((*frusta)[i], box, near).relation);
          EXPECT_EQ(overlap[i], overlap_certified((*frusta)[i], box, near).relation);
        }
      }
    }
  }
}

TEST_P(NoFrustum, UnionsHaveTheOtherShadowAlone) {
  const ShadowFrustum real = wall();
  for (const NearBoundary near : kBoundaries) {
    for (const Aabb& box : kBoxes) {
      const Obb oriented{box.min, {Vec3{0.25, 0, 0}, Vec3{0, 0.25, 0}, Vec3{0, 0, 0.25}}};
      EXPECT_EQ(overlap_certified(ShadowUnion{none_, none_}, box, near).relation, Relation::partial);
      EXPECT_EQ(overlap_certified(ShadowUnion{none_, none_}, oriented, near).relation, Relation::partial);
      for (const ShadowUnion& both : {ShadowUnion{real, none_}, ShadowUnion{none_, real}}) {
        EXPECT_EQ(overlap_certified(both, box, near).relation == Relation::inside,
                  overlap_certified(real, box, near).relation == Relation::inside);
        EXPECT_EQ(overlap_certified(both, oriented, near).relation == Relation::inside,
                  overlap_certified(real, oriented, near).relation == Relation::inside);
      }
    }
  }
}

TEST_P(NoFrustum, NoPolytopeOrConeIsInside) {
  const ConvexPolytope about = *ConvexPolytope::make(cube({-1, -1, -1})).polytope;
  const ConvexPolytope beyond = *ConvexPolytope::make(cube({3, -1, -1})).polytope;
  for (const NearBoundary near : kBoundaries) {
    EXPECT_EQ(overlap_certified(none_, about, near).relation, Relation::partial);
    EXPECT_EQ(overlap_certified(none_, beyond, near).relation, Relation::partial);
  }
  const ViewCone real{wall()}, none{none_};
  EXPECT_EQ(overlap_certified(none, real).relation, Relation::partial);
  EXPECT_EQ(overlap_certified(real, none).relation, Relation::partial);
  EXPECT_EQ(overlap_certified(none, none).relation, Relation::partial);
}

INSTANTIATE_TEST_SUITE_P(Kinds, NoFrustum, testing::Values([] { return ShadowFrustum(); }, &refused, &moved_from));

}  // namespace no_frustum_test
