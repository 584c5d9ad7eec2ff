// SPDX-License-Identifier: MIT
// A case that was made smaller still shows what it showed, and has nothing that it does not need.
#include "differential/minimise.h"

#include <gtest/gtest.h>

#include <variant>

#include "cases/ask.h"
#include "differential/overlap.h"
#include "occlude/fuzz/cases.h"
#include "occlude/fuzz/neighbours.h"

namespace occlude::fuzz {
namespace minimise_test {

using kernel::Relation;
using kernel::Vec3;

/// Whether the paper's arithmetic would cull the box although it sticks out.
bool is_wrong_cull(const Case& c) {
  if (check(c.box) != kernel::Refusal::none) return false;
  const auto made = make_frustum(c);
  return made.frustum && overlap_plain(*made.frustum, c.box) == Relation::inside &&
         overlap(*made.frustum, c.box).relation != Relation::inside;
}

/// The first wrong culls among the neighbours of the family's cases.
std::vector<Case> wrong_culls(Family family, std::size_t count) {
  std::vector<Case> cases;
  for (std::uint64_t seed = 0; cases.size() < count && seed < 10'000; ++seed) {
    Case c = make_case(family, seed);
    c.box = neighbour(c.box, seed);
    if (is_wrong_cull(c)) cases.push_back(std::move(c));
  }
  EXPECT_EQ(cases.size(), count);
  return cases;
}

TEST(Minimise, StillShowsIt) {
  for (const Family family : {Family::random, Family::many_sided, Family::obb_random, Family::polytope_random}) {
    for (const Case& c : wrong_culls(family, 3)) EXPECT_TRUE(is_wrong_cull(minimise(c, is_wrong_cull)));
  }
}

TEST(Minimise, LeavesOutVertices) {
  for (const Case& c : wrong_culls(Family::many_sided, 3)) {
    const Case small = minimise(c, is_wrong_cull);
    EXPECT_EQ(std::get<Polygon>(small.occluder).size(), 3U);
  }
}

TEST(Minimise, MakesPolytopesTetrahedra) {
  for (const Family family : {Family::polytope_random, Family::polytope_many}) {
    for (const Case& c : wrong_culls(family, 3)) {
      const Case small = minimise(c, is_wrong_cull);
      EXPECT_LE(std::get<kernel::Polytope>(small.occluder).vertices.size(), 5U);
    }
  }
}

/// One coordinate of the second vertex matters. When the second vertex is gone, the third takes its place.
TEST(Minimise, KeepsOnlyWhatMatters) {
  const auto shows = [](const Case& c) {
    const auto& polygon = std::get<Polygon>(c.occluder);
    return polygon.size() >= 2 && polygon[1].y > 2.5;
  };
  const Case c{kernel::Viewpoint::eye({0.1, 0.2, 0.3}), Polygon{{1.1, 2, 3}, {4, 5.7, 6}, {7, 8, 9.9}, {7, 8, 12}},
               Near::surface, kernel::Aabb{{0.3, 1, 2}, {3, 4, 5.1}}};
  const Case small = minimise(c, shows);
  EXPECT_EQ(std::get<Polygon>(small.occluder), (Polygon{{0, 0, 0}, {0, 8, 0}}));
  EXPECT_EQ(small.viewpoint.value, Vec3{});
  EXPECT_EQ(std::get<kernel::Aabb>(small.box), kernel::Aabb{});
}

TEST(Minimise, MovesASceneFarAwayToTheOrigin) {
  const double far = 0x1p40;
  const auto shows = [](const Case& c) {
    const auto& box = std::get<kernel::Aabb>(c.box);
    return box.min.x - c.viewpoint.value.x == 2 && box.max.y - box.min.y == 1 && !std::get<Polygon>(c.occluder).empty() &&
           std::get<Polygon>(c.occluder)[0].z - c.viewpoint.value.z == 3;
  };
  const Case c{kernel::Viewpoint::eye({far, far, far}), Polygon{{far, far, far + 3}}, Near::surface,
               kernel::Aabb{{far + 2, far, far}, {far + 2, far + 1, far}}};
  const Case small = minimise(c, shows);
  EXPECT_EQ(small.viewpoint.value, Vec3{});
  EXPECT_EQ(std::get<kernel::Aabb>(small.box).min.x, 2);
}

TEST(Disagreement, IsNoneWhereTheKernelIsRight) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Case c = make_case(Family::ulp_lattice, seed);
    EXPECT_FALSE(find_again(c, "certified"));
    EXPECT_EQ(judged_answer(c), kernel::to_string(overlap(*make_frustum(c).frustum, c.box).relation));
  }
}

}  // namespace minimise_test
}  // namespace occlude::fuzz
