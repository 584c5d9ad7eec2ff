// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <random>
#include <span>
#include <stdexcept>
#include <vector>

#include "forged_parts.h"
#include "frame/culler_access.h"
#include "frames.h"
#include "frusta/depth_complexity.h"
#include "occlude/culler/culler.h"
#include "scenes.h"

namespace preprocess_test {

using namespace occlude::culler;

std::vector<float> hidden_of(const Culler& culler) {
  const auto& hidden = occluders_of(culler).lists().stored().hidden;
  return {hidden.begin(), hidden.end()};
}

/// A pavement that looks large and hides nothing, a wall that hides a hundred polygons, and a wall behind it.
PolygonSoup pavement_and_walls() {
  PolygonSoup soup;
  for (int i = 0; i < 4; ++i) add(soup, {{i, -9, -1}, {i + 1, -9, -1}, {i + 1, 9, -1}, {i, 9, -1}});
  add_wall(soup, 8, -1, 1, -0.5, 1);
  add_wall(soup, 9, -1, 1, -0.5, 1);
  for (int i = 0; i < 99; ++i) add_wall(soup, 10 + i, -0.5, 0.5, -0.2, 0.5);
  return soup;
}

/// If what occluders hide has weight, they are chosen by it.
TEST(Preprocess, WhatOccludersHideChoosesThem) {
  const PolygonSoup soup = pavement_and_walls();
  const BuildConfig config{.hierarchy = {.leaf_size = 1}, .lists = {.threshold = 1e-6, .regions = 1}};
  const Culler fresh(soup, config);
  std::vector<float> hidden;
  for (const std::uint32_t i : occluders_of(fresh).lists().stored().occluders) {
    const std::uint32_t polygon = fresh.hierarchy().original(occluders_of(fresh).parts(i)[0]);
    hidden.push_back(polygon == 4 ? 100.0F : 0.0F);
  }
  Camera camera;
  camera.target = {1, 0, 0};
  camera.fov_y_deg = 120;
  const CullOptions options{.method = Method::frusta, .occluders = 1};
  EXPECT_EQ(fresh.cull(camera, options).stats.shadow_culled_polygons, 0U);
  const Culler prepared = with_hidden(fresh, hidden);
  const CullResult frame = prepared.cull(camera, options);
  ASSERT_EQ(frame.occluders.size(), 1U);
  EXPECT_EQ(original(prepared, frame.occluders[0]), 4U);
  EXPECT_EQ(frame.stats.shadow_culled_polygons, 100U);
}

/// A wall behind a wall hides nothing that the first does not.
TEST(DepthComplexity, CountsWhatOthersLeave) {
  const PolygonSoup soup = pavement_and_walls();
  const Culler culler(soup, {.hierarchy = {.leaf_size = 1}});
  std::vector<std::uint32_t> all(occluders_of(culler).size());
  std::iota(all.begin(), all.end(), 0U);
  const std::vector<HiddenBy> best = best_together(culler.hierarchy(), occluders_of(culler), all, {0, 0, 0});
  ASSERT_FALSE(best.empty());
  EXPECT_EQ(culler.hierarchy().original(occluders_of(culler).parts(best[0].occluder)[0]), 4U);
  EXPECT_EQ(best[0].polygons, 100U);
  EXPECT_EQ(best.size(), 1U);
  EXPECT_TRUE(best_together(culler.hierarchy(), occluders_of(culler), {}, {0, 0, 0}).empty());
}

/// Several threads sample regions in any order. What a region finds depends only on its number and the seed. The number of
/// threads is that of the machine; repeated runs show that their timing does not matter.
TEST(Preprocess, IsTheSameInEveryRun) {
  const PolygonSoup soup = random_town_of_houses(7, 800);
  for (const auto pattern : {SampleConfig::Pattern::even, SampleConfig::Pattern::random}) {
    const BuildConfig config =
        small_config(Bounds::aabb, pattern == SampleConfig::Pattern::even ? RegionKind::grid : RegionKind::tree);
    const SampleConfig samples{.pattern = pattern, .viewpoints = 2, .seed = 5};
    const std::vector<float> first = hidden_of(preprocess(soup, config, samples));
    EXPECT_EQ(first.size(), occluders_of(Culler(soup, config)).lists().stored().occluders.size());
    EXPECT_GT(std::ranges::count_if(first, [](float h) { return h > 0; }), 100);
    for (int run = 0; run < 5; ++run) ASSERT_EQ(hidden_of(preprocess(soup, config, samples)), first);
    EXPECT_NE(hidden_of(preprocess(soup, config, {.pattern = pattern, .viewpoints = 2, .seed = 6})), first);
  }
}

TEST(Preprocess, WithoutViewpointsNothingIsSampled) {
  const PolygonSoup soup = random_town_of_houses(7, 300);
  const Culler result = preprocess(soup, small_config(Bounds::aabb), {});
  EXPECT_FALSE(occluders_of(result).lists().stored().occluders.empty());
  EXPECT_TRUE(hidden_of(result).empty());
}

TEST(Preprocess, TellsHowFarItIsAndStopsWhenThatThrows) {
  const PolygonSoup soup = random_town_of_houses(7, 300);
  std::size_t calls = 0, last = 0, total = 0;
  const Culler result =
      preprocess(soup, small_config(Bounds::aabb), {.viewpoints = 1}, [&](std::size_t done, std::size_t all) {
        ++calls;
        EXPECT_EQ(done, last + 1);
        last = done;
        total = all;
      });
  EXPECT_EQ(last, total);
  EXPECT_EQ(calls, occluders_of(result).lists().partition().regions());
  const auto stop = [](std::size_t, std::size_t) { throw std::runtime_error("stopped"); };
  EXPECT_THROW(static_cast<void>(preprocess(soup, small_config(Bounds::aabb), {.viewpoints = 1}, stop)), std::runtime_error);
}

TEST(Preprocess, RefusesWhatCannotBeHidden) {
  const PolygonSoup soup = random_town_of_houses(9, 300);
  const Culler sound = preprocess(soup, small_config(Bounds::aabb), {.viewpoints = 1});
  EXPECT_NO_THROW(static_cast<void>(with_hidden(sound, hidden_of(sound))));
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  for (const float wrong : {nan, infinity, -1.0F}) {
    std::vector<float> hidden = hidden_of(sound);
    hidden[2] = wrong;
    EXPECT_THROW(static_cast<void>(with_hidden(sound, hidden)), std::invalid_argument) << wrong;
  }
  std::vector<float> hidden = hidden_of(sound);
  hidden.pop_back();
  EXPECT_THROW(static_cast<void>(with_hidden(sound, hidden)), std::invalid_argument);
}

TEST(OccluderLists, RefusesWhatCannotBe) {
  const PolygonSoup soup = random_town(9, 20);
  const double nan = std::nan(""), infinity = std::numeric_limits<double>::infinity();
  for (const double regions : {0.0, -8.0, 0.5, 1e30, nan, infinity}) {
    EXPECT_THROW(Culler(soup, {.lists = {.threshold = 0.03, .regions = regions}}), std::invalid_argument);
  }
  for (const double threshold : {0.0, -1.0, nan}) {
    EXPECT_THROW(Culler(soup, {.lists = {.threshold = threshold}}), std::invalid_argument);
  }
}

TEST(Preprocess, RefusesWhatIsNoModel) {
  PolygonSoup broken = random_town_of_houses(9, 300);
  broken.vertices[3].x = std::nan("");
  EXPECT_THROW(static_cast<void>(preprocess(broken, {}, {})), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(preprocess(PolygonSoup{}, {}, {})), std::invalid_argument);
}

/// Whatever the lists and the samples say, every cull is right.
TEST(Preprocess, HeuristicsOfAnyKindKeepThePicture) {
  const PolygonSoup soup = random_town_of_houses(10, 600);
  for (const BuildConfig& config : kSmallConfigs) {
    ForgedParts forged(preprocess(soup, config, {.viewpoints = 1}));
    std::mt19937 random(3);
    forged.edit<float>("hidden", [&](std::vector<float>& hidden) { std::ranges::shuffle(hidden, random); });
    const std::size_t all = occluders_of(Culler(soup, config)).size();
    const auto first = forged.get<std::uint64_t>("list first");
    forged.edit<std::uint32_t>("listed", [&](std::vector<std::uint32_t>& listed) {  // other occluders in the lists, too
      for (std::size_t r = 0; r + 1 < first.size(); ++r) {
        const auto list = std::span(listed).subspan(first[r], first[r + 1] - first[r]);
        for (std::uint32_t& i : list) i = static_cast<std::uint32_t>((i + 17) % all);
        std::ranges::sort(list);
      }
    });
    const Culler culler = forged.culler();
    for (int frame = 0; frame < 30; ++frame) {
      const CullResult result = culler.cull(random_camera(random), {.method = Method::frusta});
      for (const Culled& culled : result.culled) {
        if (culled.by != Culled::By::shadow) continue;
        const auto inside = [&](const auto& box) {
          return occlude::kernel::overlap_certified(result.occluders[culled.index].frustum, box,
                                                    occlude::kernel::NearBoundary::open)
                     .relation == occlude::kernel::Relation::inside;
        };
        ASSERT_TRUE(culler.hierarchy().ask(culled.node, inside));
      }
    }
  }
}

}  // namespace preprocess_test
