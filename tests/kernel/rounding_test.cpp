// SPDX-License-Identifier: MIT
// Where the processor does not round to nearest, nothing is made, so that nothing is answered wrongly.
#include "kernel/rounding.h"

#include <gtest/gtest.h>

#include <vector>

#include "kernel/cube.h"
#include "occlude/kernel/convex_polytope.h"
#include "occlude/kernel/cover.h"
#include "occlude/kernel/overlap.h"
#include "occlude/kernel/shadow_frustum.h"
#include "occlude/kernel/view_cone.h"

namespace rounding_test {

using namespace occlude;
using namespace occlude::kernel;

/// The refusals of everything that checks the rounding mode.
std::vector<Refusal> refusals(const ConvexPolytope& polytope) {
  const Viewpoint eye = Viewpoint::eye({0, 0, 0}), direction = Viewpoint::direction({1, 0, 0});
  const std::vector<Vec3> loop{{2, -1, -1}, {2, 1, -1}, {2, 0, 1}};
  const std::vector<Cover::Polygon> polygons{loop};
  std::vector<Refusal> result{ConvexPolytope::make(cube({2, -1, -1})).refusal};
  for (const Viewpoint& view : {eye, direction}) {
    for (const Near near : {Near::surface, Near::farthest}) {
      ShadowFrustum frustum;
      PolytopeSilhouette seen;
      result.push_back(ShadowFrustum::make(view, loop, near).refusal);
      result.push_back(ShadowFrustum::make(view, polytope, near).refusal);
      result.push_back(frustum.assign(view, loop, near));
      result.push_back(frustum.assign(view, polytope, near, seen));
    }
    result.push_back(ViewCone::make(view, loop).refusal);
    result.push_back(ViewCone::make(view, polytope).refusal);
    result.push_back(Cover::make(view, polygons).refusal);
  }
  return result;
}

TEST(Rounding, NothingIsMadeUnlessToNearest) {
  if (!kHasOtherRoundings) GTEST_SKIP() << "there is no other rounding here";
  const ConvexPolytope polytope = *ConvexPolytope::make(cube({2, -1, -1})).polytope;
  for (const Refusal refusal : refusals(polytope)) EXPECT_EQ(refusal, Refusal::none);
  for (const int mode : kOtherRoundings) {
    const WithRounding other(mode);
    for (const Refusal refusal : refusals(polytope)) EXPECT_EQ(refusal, Refusal::rounding_mode) << "mode " << mode;
  }
  EXPECT_EQ(check_rounding(), Refusal::none) << "the mode is what it was";
}

/// A refusal leaves a frustum as it was, and without a frustum nothing is inside.
TEST(Rounding, ARefusalChangesNoFrustum) {
  if (!kHasOtherRoundings) GTEST_SKIP() << "there is no other rounding here";
  const std::vector<Vec3> near{{2, -1, -1}, {2, 1, -1}, {2, 0, 1}}, far{{4, -1, -1}, {4, 1, -1}, {4, 0, 1}};
  const Viewpoint eye = Viewpoint::eye({0, 0, 0});
  const Aabb behind_near{{3, 0, 0}, {3, 0, 0}};
  ShadowFrustum frustum = *ShadowFrustum::make(eye, near, Near::surface).frustum, none;
  for (const int mode : kOtherRoundings) {
    const WithRounding other(mode);
    EXPECT_EQ(frustum.assign(eye, far, Near::surface), Refusal::rounding_mode);
    EXPECT_EQ(none.assign(eye, near, Near::surface), Refusal::rounding_mode);
    EXPECT_TRUE(none.is_none());
    EXPECT_EQ(overlap_certified(none, behind_near).relation, Relation::partial);
  }
  EXPECT_EQ(overlap_certified(frustum, behind_near).relation, Relation::inside);
}

}  // namespace rounding_test
