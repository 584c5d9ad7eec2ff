// SPDX-License-Identifier: MIT
// Lines of sight refute what is culled wrongly for a region of eyes, and bent witnesses are bent enough to be refused.
#include "differential/sight_judge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <vector>

#include "culler/scenes.h"
#include "differential/rows.h"
#include "occlude/oracle/region.h"

namespace occlude::fuzz {
namespace sight_judge_test {

using culler::Culled;
using culler::EyeRegion;

/// A wall, a triangle behind it, and one that eyes 1 aside see past the wall.
culler::PolygonSoup scene() {
  culler::PolygonSoup soup;
  culler::add(soup, {{5, -4, -4}, {5, 4, -4}, {5, 4, 4}, {5, -4, 4}});
  culler::add(soup, {{10, 0, 0}, {10, 1, 0}, {10, 0, 1}});
  culler::add(soup, {{10, 7.25, 0}, {10, 7.5, 0}, {10, 7.25, 0.5}});
  return soup;
}

class SightJudge : public testing::Test {
 protected:
  SightJudge() {
    camera_.fov_y_deg = 120;
    options_.method = culler::Method::cover;
  }

  /// The fault of the frame for these eyes, in which the polygon at y = 7.25 is taken for culled, too.
  std::string fault_with_all_culled(const EyeRegion& eyes, std::uint64_t& lines) {
    camera_.eyes = eyes;
    culler::CullResult result = culler_.cull(camera_, options_);
    for (std::uint32_t i = 0; i < culler_.hierarchy().nodes().size(); ++i) {
      const culler::Hierarchy::Node& node = culler_.hierarchy().nodes()[i];
      if (node.is_leaf() && node.box.min.x == 10 && node.box.min.y == 7.25) {
        result.culled.push_back({.node = i, .by = Culled::By::cover});
      }
    }
    Random random(1);
    return fault_of_sight(random, culler_, camera_, result, lines);
  }

  culler::Culler culler_{scene(), {.hierarchy = {.leaf_size = 1}, .occluders = {}, .lists = {}}};
  culler::Camera camera_;
  culler::CullOptions options_{.method = culler::Method::frusta};
};

TEST_F(SightJudge, RefutesWhatSomeEyesSee) {
  for (const EyeRegion& eyes : {EyeRegion::ball(1), EyeRegion::box({0, 1, 0}), EyeRegion::box({0, -1, 0}, {0, 0, 0.5})}) {
    std::uint64_t lines = 0;
    EXPECT_EQ(fault_with_all_culled(eyes, lines), "culled by cover: an eye sees a point of the box");
  }
}

TEST_F(SightJudge, RefutesNothingThatNoEyeSees) {
  for (const EyeRegion& eyes : {EyeRegion::ball(0x1p-10), EyeRegion::box({0, 0, 1}), EyeRegion::box({0.5, 0, 0.5})}) {
    std::uint64_t lines = 0;
    EXPECT_EQ(fault_with_all_culled(eyes, lines), "");
    EXPECT_GE(lines, 256U);
  }
}

TEST_F(SightJudge, KnowsWhatTheNearPlaneMayTakeAway) {
  camera_.near_plane = 4.5;
  std::uint64_t lines = 0;
  EXPECT_EQ(fault_with_all_culled(EyeRegion::box({0.25, 0, 0}), lines), "");
  camera_.near_plane = 5;  // the wall is nearer than that from the foremost eye
  EXPECT_EQ(fault_with_all_culled(EyeRegion::box({0.25, 0, 0}), lines), "culled by cover: an eye sees a point of the box");
}

TEST(SomeEyes, AreInTheRegionAndHaveItsCorners) {
  Random random(1);
  const oracle::Obb box{{1, 2, 3}, {{{0.5, 0, 0}, {0, 0.25, 0}, {0, 0, 0}}}};
  const std::vector<oracle::Point> eyes = some_eyes(random, box);
  EXPECT_EQ(eyes.size(), 16U);
  for (const double x : {0.5, 1.5}) {
    for (const double y : {1.75, 2.25}) EXPECT_TRUE(std::ranges::count(eyes, oracle::Point{x, y, 3}) > 0);
  }
  for (const oracle::Point& eye : eyes) EXPECT_TRUE(oracle::contains(oracle::Box(box), eye));
  const oracle::Ball ball{{1, 2, 3}, 0.1};
  const std::vector<oracle::Point> of_ball = some_eyes(random, ball);
  EXPECT_GT(of_ball.size(), 8U);
  for (const oracle::Point& eye : of_ball) EXPECT_TRUE(oracle::contains(ball, eye));
}

TEST(RegionForgeries, AreRefutedAndRefused) {
  Report report;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) run_region_forgeries(seed, report);
  EXPECT_EQ(report.tally.disagreements, 0U);
  EXPECT_GT(report.tally.relations[0], 200U);
  EXPECT_GT(report.tally.relations[1], 100U);
  EXPECT_GT(report.tally.relations[2], 200U);
}

}  // namespace sight_judge_test
}  // namespace occlude::fuzz
