// SPDX-License-Identifier: MIT

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

#include "camera/clearance.h"
#include "frame/culler_access.h"
#include "frames.h"
#include "frusta/plane_work.h"
#include "occlude/culler/culler.h"
#include "occlude/kernel/clearance.h"
#include "scenes.h"

namespace missed_test {

using namespace occlude;
using namespace occlude::culler;

/// Why a polygon that is hidden was drawn. `original` is its number in the input.
template <class AnyCamera>
MissedReasons::Answer why_drawn_by(const AnyCamera& camera, const Culler& culler, std::uint32_t original,
                                   const CullOptions& options) {
  const CullResult frame = culler.cull(camera, options);
  const MissedReasons reasons(culler, camera, options, frame);
  const std::size_t polygons = culler.hierarchy().soup().size();
  for (std::uint32_t p = 0; p < polygons; ++p) {
    if (culler.hierarchy().original(p) != original) continue;
    EXPECT_EQ(culler.cull_of(frame, p), nullptr);
    const MissedReasons::Answer answer = reasons.answer(p);
    std::vector<bool> shows(polygons, true);
    shows[p] = false;
    const auto counts = MissedReasons::count(reasons.answers(shows));
    for (std::size_t r = 0; r < kMissedReasons; ++r)
      EXPECT_EQ(counts.reasons[r], r == static_cast<std::size_t>(answer.reason));
    return answer;
  }
  ADD_FAILURE() << "no such polygon";
  return {};
}

/// The same by a camera and by its matrix, which have the same reasons.
MissedReasons::Answer why_drawn(const Culler& culler, std::uint32_t original,
                                const CullOptions& options = {.method = Method::frusta}) {
  const MissedReasons::Answer answer = why_drawn_by(Camera(), culler, original, options);
  EXPECT_EQ(why_drawn_by(matrix_of(Camera()), culler, original, options), answer);
  return answer;
}

Culler with_leaves(const PolygonSoup& soup, std::uint32_t size) { return Culler(soup, {.hierarchy = {.leaf_size = size}}); }

TEST(Missed, IsAskedOfEachPolygon) {
  PolygonSoup soup;
  add_wall(soup, 10, -1, 1, -1, 1);
  const Culler culler = with_leaves(soup, 16);
  const CullResult frame = culler.cull(Camera(), {.method = Method::frusta});
  const MissedReasons reasons(culler, Camera(), {}, frame);
  EXPECT_EQ(refusal([&] { static_cast<void>(reasons.answers({})); }), "0 polygons that show or do not, for a model of 1");
}

TEST(Missed, NotByAShadowWhereItIsOutOfView) {
  PolygonSoup soup;
  add_wall(soup, 10, -1, 1, -1, 1);
  add_wall(soup, -20, -1, 1, -1, 1);  // behind the camera, in the leaf of what is before it
  EXPECT_EQ(why_drawn(with_leaves(soup, 16), 1).reason, Missed::out_of_view);
}

/// The far side of a shell is drawn because it is the shell's, not because its leaf is too coarse.
TEST(Missed, NotByWhatItIsAPartOf) {
  PolygonSoup soup;
  soup.add_box({10, -1, -1}, {12, 1, 1});
  const Culler culler = with_leaves(soup, 16);
  ASSERT_EQ(occluders_of(culler).shells().size(), 1U);
  const Camera camera;
  const CullResult frame = culler.cull(camera, {.method = Method::frusta});
  ASSERT_EQ(frame.occluders.size(), 1U);
  const MissedReasons reasons(culler, camera, {}, frame);
  for (std::uint32_t p = 0; p < soup.size(); ++p) {
    const Missed reason = reasons.answer(p).reason;
    EXPECT_NE(reason, Missed::coarse_node);
    EXPECT_NE(reason, Missed::straddling_box);
  }
}

TEST(Missed, BecauseItsLeafIsTooCoarse) {
  PolygonSoup soup;
  add_wall(soup, 10, -10, 10, -10, 10);
  add_wall(soup, 20, -1, 1, -1, 1);
  add_wall(soup, 20, 30, 31, -1, 1);  // shows, and shares the leaf
  const auto answer = why_drawn(with_leaves(soup, 16), 1);
  EXPECT_EQ(answer.reason, Missed::coarse_node);
  EXPECT_EQ(answer.occluder, 0U);
}

TEST(Missed, BecauseItsBoxStraddles) {
  PolygonSoup soup;
  add_wall(soup, 10, -10, 10, -10, 10);
  // Along the border of the shadow at y = x: its box has the corner (20, 39), which is beyond.
  add(soup, {{20, 19, -1}, {40, 39, -1}, {40, 39, 1}, {20, 19, 1}});
  const auto answer = why_drawn(with_leaves(soup, 1), 1);
  EXPECT_EQ(answer.reason, Missed::straddling_box);
  EXPECT_EQ(answer.occluder, 0U);
}

TEST(Missed, BecauseOnlySeveralHideIt) {
  PolygonSoup soup;
  add_wall(soup, 10, -10, 0, -10, 10);
  add(soup, {{10, 0, -10}, {12, 10, -10}, {12, 10, 10}, {10, 0, 10}});
  add_wall(soup, 20, -5, 5, -1, 1);
  EXPECT_EQ(why_drawn(with_leaves(soup, 1), 2).reason, Missed::several);
}

TEST(Missed, BecauseWhatHidesItWasNotChosen) {
  PolygonSoup soup;
  add_wall(soup, 10, -5, 5, -10, 10);
  add_wall(soup, 15, 9, 13, -2, 2);
  add_wall(soup, 20, 13, 16, -1, 1);
  const auto answer = why_drawn(with_leaves(soup, 1), 2, {.method = Method::frusta, .occluders = 1});
  EXPECT_EQ(answer.reason, Missed::not_chosen);
  EXPECT_NE(answer.occluder, Culled::kNone);
  EXPECT_EQ(why_drawn(with_leaves(soup, 1), 2, {.method = Method::frusta, .occluders = 0}).reason, Missed::not_chosen);
}

TEST(Missed, BecauseNoneHidesItAlone) {
  PolygonSoup soup;
  add_wall(soup, 10, -10, 10, -10, 10);
  add_wall(soup, 20, 19, 22, -1, 1);
  EXPECT_EQ(why_drawn(with_leaves(soup, 1), 1).reason, Missed::no_single_one);
}

TEST(Missed, OfWhatTheMarginDraws) {
  PolygonSoup soup;
  add_wall(soup, 10, -10, 10, -10, 10);
  add_wall(soup, 20, 18, 19.99, -1, 1);
  EXPECT_TRUE(is_drawn(with_leaves(soup, 1), look(with_leaves(soup, 1), {.method = Method::frusta, .margin = 0.01}), 1));
  EXPECT_EQ(why_drawn(with_leaves(soup, 1), 1, {.method = Method::frusta, .margin = 0.01}).reason, Missed::no_single_one);
}

/// Walls one behind the other, each wider than the shadow of the one before it by less than a pixel.
PolygonSoup peeking_walls(std::size_t count) {
  PolygonSoup soup;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = 10 + static_cast<double>(i) / 100, half = x / 2 * (1 + static_cast<double>(i) * 1e-9);
    add_wall(soup, x, -half, half, -half, half);
  }
  return soup;
}

TEST(Missed, AsFarAsTheWorkGoes) {
  const PolygonSoup soup = peeking_walls(500);
  const Culler culler = with_leaves(soup, 4);
  const CullResult frame = culler.cull(Camera{}, {.method = Method::frusta});
  const MissedReasons reasons(culler, Camera{}, {.method = Method::frusta}, frame);
  const std::vector<bool> shows(soup.size());  // nothing does
  const MissedReasons::Counts all = MissedReasons::count(reasons.answers(shows));
  EXPECT_EQ(all.missed, frame.stats.drawn_polygons);
  EXPECT_EQ(all.asked(), all.missed);
  constexpr std::size_t kWork = 500000;  // less than half of what all take
  const MissedReasons::Answers answers = reasons.answers(shows, {}, kWork);
  const MissedReasons::Counts some = MissedReasons::count(answers);
  EXPECT_EQ(some.missed, all.missed);
  EXPECT_LT(some.asked(), all.missed / 2);
  EXPECT_GT(some.asked(), 0U);
  EXPECT_EQ(reasons.answers(shows, {}, kWork), answers);
}

/// Walls with corners exactly on the borders of each other's shadows, so that the exact stage answers.
TEST(Missed, AnswersOneByOneAsTogether) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> place(-8, 8), size(0.1, 2);
  PolygonSoup soup;
  for (int i = 0; i < 400; ++i) {
    const double y = place(random), z = place(random);
    add_wall(soup, 10 + place(random), y, y + size(random), z, z + size(random));
  }
  const Culler culler = with_leaves(soup, 2);
  const CullOptions options{.method = Method::frusta, .occluders = 4};
  const CullResult frame = culler.cull(Camera{}, options);
  const MissedReasons reasons(culler, Camera{}, options, frame);
  std::vector<bool> shows(soup.size());
  for (std::size_t p = 0; p < shows.size(); p += 3) shows[p] = true;
  const MissedReasons::Answers together = reasons.answers(shows);
  ASSERT_GT(MissedReasons::count(together).reasons[static_cast<std::size_t>(Missed::not_chosen)], 3U);
  std::uint32_t next = 0;
  for (const auto& [polygon, answer] : together) {
    EXPECT_GE(polygon, next);
    EXPECT_FALSE(shows[polygon]);
    EXPECT_EQ(reasons.answer(polygon), answer) << polygon;
    next = polygon + 1;
  }
}

TEST(Missed, CountsTheExactStageAsWork) {
  PolygonSoup soup;
  for (int i = 0; i < 200; ++i) {
    const double x = std::exp2(i / 100.0);
    add_wall(soup, x, -x, x, -x, x);
  }
  const Culler culler = with_leaves(soup, 4);
  const CullOptions options{.method = Method::frusta, .margin = 1e-6};
  const CullResult frame = culler.cull(Camera{}, options);
  const MissedReasons reasons(culler, Camera{}, options, frame);
  constexpr std::size_t kExact = 500;  // answers of the exact stage; each wall asks dozens
  const MissedReasons::Counts some =
      MissedReasons::count(reasons.answers(std::vector<bool>(soup.size()), {}, kExact * PlaneWork::kExact));
  EXPECT_LT(some.asked(), some.missed / 2);
}

TEST(Missed, StopsWhenItsCheckpointThrows) {
  const PolygonSoup soup = peeking_walls(50);
  const Culler culler = with_leaves(soup, 4);
  const CullResult frame = culler.cull(Camera{}, {.method = Method::frusta});
  const MissedReasons reasons(culler, Camera{}, {.method = Method::frusta}, frame);
  const auto stop = [] { throw std::runtime_error("stopped"); };
  EXPECT_THROW(static_cast<void>(reasons.answers(std::vector<bool>(soup.size()), stop)), std::runtime_error);
}

TEST(Clearance, IsTheDistanceToTheNearestPlane) {
  const std::vector<kernel::Vec3> wall{{10, -10, -10}, {10, 10, -10}, {10, 10, 10}, {10, -10, 10}};
  const auto shadow = kernel::ShadowFrustum::make(kernel::Viewpoint::eye({0, 0, 0}), wall, kernel::Near::surface).frustum;
  const auto of = [&](const auto& box) { return clearance(*shadow, box); };
  EXPECT_NEAR(of(kernel::Aabb{{12, -1, -1}, {14, 1, 1}}).distance, 2, 1e-12);
  EXPECT_NEAR(certain_distance(*shadow, kernel::Aabb{{12, -1, -1}, {14, 1, 1}}), 2, 1e-5);
  EXPECT_LT(of(kernel::Aabb{{12, -1, -1}, {14, 1, 1}}).plane, shadow->near_count());
  // The side y = x is nearest to the corner (30, 29).
  const kernel::Clearance side = of(kernel::Obb{{31, 28, 0}, {kernel::Vec3{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}});
  EXPECT_NEAR(side.distance, std::sqrt(0.5), 1e-12);
  EXPECT_GE(side.plane, shadow->near_count());
  EXPECT_NEAR(of(kernel::Aabb{{20, 20, 0}, {21, 22, 0}}).distance, -2 * std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(distance_beyond({{0, 0, 2}, -4}, kernel::Aabb{{0, 0, -3}, {1, 1, 1}}), 1, 1e-12);
  EXPECT_NEAR(distance_beyond({{0, 0, 2}, -4}, kernel::Aabb{{0, 0, -3}, {1, 1, 5}}), -3, 1e-11);
}

}  // namespace missed_test
