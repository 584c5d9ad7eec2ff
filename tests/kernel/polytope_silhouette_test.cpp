// SPDX-License-Identifier: MIT
// Silhouettes updated from viewpoint to viewpoint, and frusta assigned over others.
#include "occlude/kernel/polytope_silhouette.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

#include "occlude/kernel/batch.h"
#include "occlude/kernel/overlap.h"
#include "occlude/kernel/shadow_frustum.h"
#include "stored_frustum.h"

namespace polytope_silhouette_test {

using namespace occlude::kernel;

/// Two pyramids over the polygon of the points (k, k^2), |k| <= `reach`: 4 reach + 2 faces, no two of them coplanar.
ConvexPolytope bipyramid(int reach) {
  Polytope solid;
  for (int k = -reach; k <= reach; ++k) solid.vertices.push_back({static_cast<double>(k), static_cast<double>(k * k), 0});
  const auto corners = static_cast<std::uint32_t>(solid.vertices.size());
  const double middle = reach * reach / 2.0;
  solid.vertices.push_back({0, middle, 30});
  solid.vertices.push_back({0, middle, -30});
  for (std::uint32_t i = 0; i < corners; ++i) {
    for (const std::uint32_t apex : {corners, corners + 1}) solid.faces.push_back({i, (i + 1) % corners, apex});
  }
  return *ConvexPolytope::make(solid).polytope;
}

std::vector<std::uint32_t> vertices_of(const PolytopeSilhouette& seen) {
  std::vector<std::uint32_t> vertices;
  for (const auto& step : seen.loop()) vertices.push_back(step.vertex);
  return vertices;
}

void expect_same(const PolytopeSilhouette& followed, const Viewpoint& viewpoint, const ConvexPolytope& polytope) {
  PolytopeSilhouette fresh;
  fresh.update(viewpoint, polytope);
  EXPECT_TRUE(std::ranges::equal(followed.turned_faces(), fresh.turned_faces()));
  EXPECT_EQ(vertices_of(followed), vertices_of(fresh));
  EXPECT_EQ(fresh.faces_asked(), polytope.faces().size());
}

TEST(PolytopeSilhouette, FollowedIsWhatAFreshOneIs) {
  constexpr std::uint32_t kSeed = 5;
  std::mt19937 random(kSeed);
  const ConvexPolytope polytope = bipyramid(8);
  const auto coordinate = [&](unsigned reach) { return static_cast<double>(random() % (2 * reach + 1)) - reach; };
  PolytopeSilhouette followed;
  std::size_t seen_from_outside = 0, from_inside = 0;
  // The viewpoint jumps to any point of a lattice: into the polytope, onto planes of faces, to the other side.
  for (int i = 0; i < 3000; ++i) {
    const unsigned reach = i % 3 == 0 ? 9 : 120;
    const Vec3 at{coordinate(reach), coordinate(reach), coordinate(reach)};
    const bool is_direction = i % 5 == 0 && at != Vec3{};
    const Viewpoint viewpoint = is_direction ? Viewpoint::direction(at) : Viewpoint::eye(at);
    followed.update(viewpoint, polytope);
    expect_same(followed, viewpoint, polytope);
    ++(followed.loop().empty() ? from_inside : seen_from_outside);
    ASSERT_FALSE(HasFailure()) << "seed " << kSeed << " viewpoint " << i;
  }
  EXPECT_GT(seen_from_outside, 1000U);
  EXPECT_GT(from_inside, 5U);
}

TEST(PolytopeSilhouette, ASmallStepAsksTheFacesAlongItAlone) {
  const ConvexPolytope polytope = bipyramid(50);
  PolytopeSilhouette followed;
  followed.update(Viewpoint::eye({-200, 1000, 7}), polytope);
  EXPECT_EQ(followed.faces_asked(), polytope.faces().size());
  std::size_t asked = 0;
  for (int i = 1; i <= 100; ++i) {
    const Viewpoint viewpoint = Viewpoint::eye({-200.0 + i, 1000, 7});
    followed.update(viewpoint, polytope);
    asked += followed.faces_asked();
    expect_same(followed, viewpoint, polytope);
  }
  EXPECT_LT(asked, 100 * polytope.faces().size() / 10);
}

/// A frustum assigned over another keeps nothing of it.
TEST(ShadowFrustum, AssignedIsWhatAMadeOneIs) {
  const ConvexPolytope polytope = bipyramid(3);
  const std::vector<Vec3> flat{{4, -1, -1}, {4, 1, -1}, {4, 1, 1}, {4, -1, 1}},
      bent{{4, -1, -1}, {4, 1, -1}, {4.5, 1, 1}, {4, -1, 1}};
  const Viewpoint eye = Viewpoint::eye({-20, 3, 1});
  PolytopeSilhouette seen;
  ShadowFrustum frustum;
  const auto expect_same_as = [&](const ShadowFrustumResult& made) {
    EXPECT_FALSE(stored(frustum)->has_profile);
    frustum.prepare_overlap();
    const StoredFrustum &here = *stored(frustum), &there = *stored(*made.frustum);
    EXPECT_EQ(here.viewpoint.kind, there.viewpoint.kind);
    EXPECT_EQ(here.viewpoint.value, there.viewpoint.value);
    EXPECT_EQ(here.origin, there.origin);
    EXPECT_EQ(here.silhouette, there.silhouette);
    EXPECT_EQ(here.recipes, there.recipes);
    EXPECT_EQ(here.filter_planes, there.filter_planes);
    EXPECT_EQ(here.coarse_planes, there.coarse_planes);
    EXPECT_EQ(here.coarse_bound, there.coarse_bound);
    EXPECT_EQ(here.refined_planes, there.refined_planes);
    EXPECT_EQ(here.cap_edges, there.cap_edges);
    EXPECT_EQ(here.cap_vertices, there.cap_vertices);
    EXPECT_EQ(here.filter_bound, there.filter_bound);
    EXPECT_EQ(here.profile_bound, there.profile_bound);
    EXPECT_EQ(here.support_plane, there.support_plane);
    EXPECT_EQ(here.plane_count, there.plane_count);
    EXPECT_EQ(here.near_count, there.near_count);
  };
  for (const Near near : {Near::surface, Near::farthest}) {
    for (int round = 0; round < 2; ++round) {
      EXPECT_EQ(frustum.assign(eye, polytope, near, seen), Refusal::none);
      expect_same_as(ShadowFrustum::make(eye, polytope, near));
      EXPECT_EQ(frustum.assign(eye, bent, near), Refusal::none);
      expect_same_as(ShadowFrustum::make(eye, bent, near));
      EXPECT_EQ(frustum.assign(eye, flat, near), Refusal::none);
      EXPECT_EQ(frustum.assign(Viewpoint::eye({4, 5, 5}), flat, near), Refusal::eye_in_plane);
      expect_same_as(ShadowFrustum::make(eye, flat, near));
    }
  }
}

/// A frustum that was assigned answers overlap tests as one that was made, also before it is prepared for them.
TEST(ShadowFrustum, OverlapNeedsNoPreparation) {
  const std::vector<Vec3> loop{{4, 0, -1}, {4, 1, 0}, {4, 0, 1}, {4, -1, 0}};
  const Viewpoint eye = Viewpoint::eye({-3, 0.5, 0.25});
  std::vector<Aabb> boxes;
  for (int i = 0; i < 4096; ++i) {
    const Vec3 corner{i % 16 - 1.0, i / 16 % 16 / 2.0 - 4, i / 256 / 2.0 - 4};
    boxes.push_back({corner, {corner.x + 1, corner.y + 2, corner.z + 2}});
  }
  for (const Near near : {Near::surface, Near::farthest}) {
    const ShadowFrustum made = *ShadowFrustum::make(eye, loop, near).frustum;
    ShadowFrustum assigned;
    ASSERT_EQ(assigned.assign(eye, loop, near), Refusal::none);
    std::vector<Relation> batch(boxes.size());
    overlap_certified(assigned, BoxBatch(boxes), NearBoundary::closed, batch);
    std::size_t beside_planes = 0;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      const Relation relation = overlap_certified(made, boxes[i]).relation;
      EXPECT_EQ(overlap_certified(assigned, boxes[i]).relation, relation) << "box " << i;
      EXPECT_EQ(batch[i], relation) << "box " << i;
      if (conservative_certified(made, boxes[i]).relation != relation) ++beside_planes;
    }
    EXPECT_GT(beside_planes, 10U);
  }
}

}  // namespace polytope_silhouette_test
