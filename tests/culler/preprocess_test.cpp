// SPDX-License-Identifier: MIT
#include "occlude/culler/preprocess.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <random>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include "depth_complexity.h"
#include "frames.h"
#include "occlude/culler/culler.h"
#include "scenes.h"

namespace {

using namespace occlude::culler;

using Kind = Partition::Kind;

BuildConfig small_config(Bounds bounds, Kind kind = Kind::grid) {
  return {.hierarchy = {.leaf_size = 4, .bounds = bounds}, .lists = {.kind = kind, .threshold = 0.05, .regions = 48}};
}

/// Both bounds, each with another kind of regions.
const std::array kConfigs{small_config(Bounds::aabb, Kind::tree), small_config(Bounds::obb, Kind::grid)};

bool are_same(const CullResult& a, const CullResult& b) {
  const auto same_cull = [](const Culled& x, const Culled& y) {
    return x.node == y.node && x.by == y.by && x.index == y.index && x.second == y.second;
  };
  const auto same_occluder = [](const Occluder& x, const Occluder& y) { return x.index == y.index && x.hidden == y.hidden; };
  return a.drawn == b.drawn && std::ranges::equal(a.culled, b.culled, same_cull) &&
         std::ranges::equal(a.occluders, b.occluders, same_occluder);
}

/// If the samples have no weight, a prepared model is culled frame by frame like one that was not prepared.
TEST(Preprocess, APreparedModelIsTheSame) {
  const PolygonSoup soup = random_town_of_houses(6, 1000);
  for (const BuildConfig& config : kConfigs) {
    const Culler fresh(soup, config), prepared(soup, preprocess(soup, config, {.viewpoints = 1}));
    EXPECT_EQ(prepared.hierarchy().oriented(), fresh.hierarchy().oriented());
    EXPECT_EQ(prepared.hierarchy().oriented() > 0, config.hierarchy.bounds == Bounds::obb);
    for (std::size_t p = 0; p < soup.size(); ++p) {
      ASSERT_EQ(prepared.hierarchy().original(p), fresh.hierarchy().original(p));
    }
    CullOptions options;
    options.objective.depth_complexity = 0;
    constexpr std::uint32_t kSeed = 12;
    std::mt19937 random(kSeed);
    View of_fresh, of_prepared;
    std::size_t culled = 0;
    for (int frame = 0; frame < 100; ++frame) {
      const Camera camera = random_camera(random);
      ASSERT_TRUE(are_same(prepared.cull(camera, options), fresh.cull(camera, options))) << "seed " << kSeed;
      const CullResult& next = prepared.cull(camera, options, of_prepared);
      ASSERT_TRUE(are_same(next, fresh.cull(camera, options, of_fresh))) << "seed " << kSeed << ", frame " << frame;
      culled += next.stats.shadow_culled_polygons;
    }
    EXPECT_GT(culled, 10000U);
  }
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
  Preprocess known = preprocess(soup, config, {});
  const Culler fresh(soup, config);
  for (const std::uint32_t i : known.lists.occluders) {
    const std::uint32_t polygon = fresh.hierarchy().original(fresh.occluders().parts(i)[0]);
    known.lists.hidden.push_back(polygon == 4 ? 100.0F : 0.0F);
  }
  Camera camera;
  camera.target = {1, 0, 0};
  camera.fov_y_deg = 120;
  const CullOptions options{.occluders = 1};
  EXPECT_EQ(fresh.cull(camera, options).stats.shadow_culled_polygons, 0U);
  const Culler prepared(soup, known);
  const CullResult frame = prepared.cull(camera, options);
  ASSERT_EQ(frame.occluders.size(), 1U);
  EXPECT_EQ(original(prepared, frame.occluders[0]), 4U);
  EXPECT_EQ(frame.stats.shadow_culled_polygons, 100U);
}

/// A wall behind a wall hides nothing that the first does not.
TEST(DepthComplexity, CountsWhatOthersLeave) {
  const PolygonSoup soup = pavement_and_walls();
  const Culler culler(soup, {.hierarchy = {.leaf_size = 1}});
  std::vector<std::uint32_t> all(culler.occluders().size());
  std::iota(all.begin(), all.end(), 0U);
  const std::vector<HiddenBy> best = best_together(culler.hierarchy(), culler.occluders(), all, {0, 0, 0});
  ASSERT_FALSE(best.empty());
  EXPECT_EQ(culler.hierarchy().original(culler.occluders().parts(best[0].occluder)[0]), 4U);
  EXPECT_EQ(best[0].polygons, 100U);
  EXPECT_EQ(best.size(), 1U);
  EXPECT_TRUE(best_together(culler.hierarchy(), culler.occluders(), {}, {0, 0, 0}).empty());
}

/// Several threads sample regions in any order. What a region finds depends only on its number and the seed. The number of
/// threads is that of the machine; repeated runs show that their timing does not matter.
TEST(Preprocess, IsTheSameInEveryRun) {
  const PolygonSoup soup = random_town_of_houses(7, 800);
  for (const auto pattern : {SampleConfig::Pattern::even, SampleConfig::Pattern::random}) {
    const BuildConfig config = small_config(Bounds::aabb, pattern == SampleConfig::Pattern::even ? Kind::grid : Kind::tree);
    const SampleConfig samples{.pattern = pattern, .viewpoints = 2, .seed = 5};
    const Preprocess first = preprocess(soup, config, samples);
    EXPECT_EQ(first.lists.hidden.size(), first.lists.occluders.size());
    EXPECT_GT(std::ranges::count_if(first.lists.hidden, [](float h) { return h > 0; }), 100);
    for (int run = 0; run < 5; ++run) {
      const Preprocess other = preprocess(soup, config, samples);
      ASSERT_EQ(other.lists.hidden, first.lists.hidden);
      ASSERT_EQ(other.lists.occluders, first.lists.occluders);
      ASSERT_EQ(other.layout.order, first.layout.order);
      ASSERT_EQ(other.layout.left, first.layout.left);
    }
    EXPECT_NE(preprocess(soup, config, {.pattern = pattern, .viewpoints = 2, .seed = 6}).lists.hidden, first.lists.hidden);
  }
}

TEST(Preprocess, WithoutViewpointsNothingIsSampled) {
  const PolygonSoup soup = random_town_of_houses(7, 300);
  const Preprocess result = preprocess(soup, small_config(Bounds::aabb), {});
  EXPECT_FALSE(result.lists.occluders.empty());
  EXPECT_TRUE(result.lists.hidden.empty());
  EXPECT_NO_THROW(Culler(soup, result));
}

TEST(Preprocess, TellsHowFarItIsAndStopsWhenThatThrows) {
  const PolygonSoup soup = random_town_of_houses(7, 300);
  std::size_t calls = 0, last = 0, total = 0;
  const Preprocess result =
      preprocess(soup, small_config(Bounds::aabb), {.viewpoints = 1}, [&](std::size_t done, std::size_t all) {
        ++calls;
        EXPECT_EQ(done, last + 1);
        last = done;
        total = all;
      });
  EXPECT_EQ(last, total);
  EXPECT_EQ(calls, result.lists.first.size() - 1);
  const auto stop = [](std::size_t, std::size_t) { throw std::runtime_error("stopped"); };
  EXPECT_THROW(static_cast<void>(preprocess(soup, small_config(Bounds::aabb), {.viewpoints = 1}, stop)), std::runtime_error);
}

/// Numbers that do not fit this model would lead out of its arrays.
TEST(Preprocess, RefusesWhatCannotBeOfThisModel) {
  const PolygonSoup soup = random_town_of_houses(9, 300);
  const BuildConfig config = small_config(Bounds::aabb);
  const Preprocess sound = preprocess(soup, config, {.viewpoints = 1});
  const auto refusal = [&](const std::function<void(Preprocess&)>& change) -> std::string {
    Preprocess changed = sound;
    change(changed);
    try {
      Culler(soup, changed);
    } catch (const std::invalid_argument& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(refusal([](Preprocess&) {}), "");

  const std::string order = "the order is not one of this model", lists = "the lists of occluders are not of this model";
  EXPECT_EQ(refusal([](Preprocess& p) { p.layout.order[3] = p.layout.order[7]; }), order) << "a polygon twice";
  EXPECT_EQ(refusal([](Preprocess& p) { p.layout.order[0] = static_cast<std::uint32_t>(p.layout.order.size()); }), order);
  EXPECT_EQ(refusal([](Preprocess& p) { p.layout.order.pop_back(); }), order);
  EXPECT_EQ(refusal([](Preprocess& p) { p.layout.order.push_back(0); }), order);

  EXPECT_EQ(refusal([](Preprocess& p) { p.layout.left.clear(); }), "the tree ends too early");
  EXPECT_EQ(refusal([](Preprocess& p) { p.layout.left.pop_back(); }), "the tree ends too early");
  EXPECT_EQ(refusal([](Preprocess& p) { p.layout.left.push_back(0); }), "the tree has more nodes than it holds together");
  EXPECT_EQ(refusal([](Preprocess& p) { p.layout.left[0] = 0; }), "the tree has more nodes than it holds together");
  EXPECT_EQ(refusal([&](Preprocess& p) { p.layout.left[0] = static_cast<std::uint32_t>(soup.size()); }),
            "a node of the tree has no polygon");
  EXPECT_EQ(refusal([&](Preprocess& p) {
              p.layout.left = {static_cast<std::uint32_t>(soup.size()), 0, 0};
            }),
            "a node of the tree has no polygon");
  EXPECT_EQ(refusal([](Preprocess& p) { p.layout.left.back() = 1000000; }), "a node of the tree has no polygon");

  const auto chain = [](Preprocess& p) {  // a file may describe a tree that is deeper than a stack
    const std::size_t polygons = p.layout.order.size();
    p.layout.left.clear();
    for (std::size_t i = 0; i + 1 < polygons; ++i) p.layout.left.insert(p.layout.left.end(), {1, 0});
    p.layout.left.push_back(0);
  };
  EXPECT_EQ(refusal(chain), "") << "some hundred levels are none too many";

  const auto many = static_cast<std::uint32_t>(Culler(soup, config).occluders().size());
  const float nan = std::numeric_limits<float>::quiet_NaN(), infinity = std::numeric_limits<float>::infinity();
  EXPECT_EQ(refusal([&](Preprocess& p) { p.lists.occluders.back() = many - 1; }), "");
  EXPECT_EQ(refusal([&](Preprocess& p) { p.lists.occluders.back() = many; }), lists);
  EXPECT_EQ(refusal([&](Preprocess& p) { p.lists.hidden[2] = nan; }), lists);
  EXPECT_EQ(refusal([&](Preprocess& p) { p.lists.hidden[2] = infinity; }), lists);
  EXPECT_EQ(refusal([&](Preprocess& p) { p.lists.hidden[2] = -1; }), lists);
  EXPECT_EQ(refusal([](Preprocess& p) { p.lists.hidden.pop_back(); }), lists);
  EXPECT_EQ(refusal([](Preprocess& p) { p.lists.hidden.clear(); }), "") << "not sampled";
  EXPECT_EQ(refusal([](Preprocess& p) { p.lists.occluders.pop_back(); }), lists);
  EXPECT_EQ(refusal([](Preprocess& p) { p.lists.first.pop_back(); }), lists);
  EXPECT_EQ(refusal([](Preprocess& p) { p.lists.first[0] = 1; }), lists);
  EXPECT_EQ(refusal([](Preprocess& p) { p.lists.first.back() += 1; }), lists);
  EXPECT_EQ(refusal([](Preprocess& p) { p.lists.first[1] = p.lists.first.back() + 1; }), lists) << "not ascending";
  EXPECT_EQ(refusal([](Preprocess& p) { p.config.lists.regions *= 8; }), lists) << "of another partition";
  const auto long_list = [](Preprocess& p) {
    std::size_t r = 0;
    while (p.lists.first[r + 1] < p.lists.first[r] + 2) ++r;
    return p.lists.occluders.begin() + static_cast<std::ptrdiff_t>(p.lists.first[r]);
  };
  EXPECT_EQ(refusal([&](Preprocess& p) { std::iter_swap(long_list(p), long_list(p) + 1); }), lists);
  EXPECT_EQ(refusal([&](Preprocess& p) { *(long_list(p) + 1) = *long_list(p); }), lists) << "an occluder twice";
}

TEST(Preprocess, RefusesTreesDeeperThanAStack) {
  PolygonSoup soup;
  for (int i = 0; i < 20000; ++i) add(soup, {{i, 0, 0}, {i, 1, 0}, {i, 0, 1}});
  Hierarchy::Layout chain;
  chain.order.resize(soup.size());
  std::iota(chain.order.begin(), chain.order.end(), 0U);
  for (std::size_t i = 0; i + 1 < soup.size(); ++i) chain.left.insert(chain.left.end(), {1, 0});
  chain.left.push_back(0);
  EXPECT_THROW(static_cast<void>(Hierarchy::restore(soup, {}, chain)), std::invalid_argument);
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

TEST(Preprocess, RefusesAnotherModel) {
  const PolygonSoup soup = random_town_of_houses(9, 300);
  const Preprocess of_soup = preprocess(soup, small_config(Bounds::aabb), {.viewpoints = 1});
  EXPECT_THROW(Culler(random_town_of_houses(9, 320), of_soup), std::invalid_argument);
  PolygonSoup stretched = soup;
  for (glm::dvec3& v : stretched.vertices) v.z *= 3;
  EXPECT_THROW(Culler(stretched, of_soup), std::invalid_argument) << "it has other regions";
  PolygonSoup broken = soup;
  broken.vertices[3].x = std::nan("");
  EXPECT_THROW(Culler(broken, of_soup), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(preprocess(broken, {}, {})), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(preprocess(PolygonSoup{}, {}, {})), std::invalid_argument);
}

/// Whatever the lists and the samples say, every cull is right.
TEST(Preprocess, HeuristicsOfAnyKindKeepThePicture) {
  const PolygonSoup soup = random_town_of_houses(10, 600);
  for (const BuildConfig& config : kConfigs) {
    Preprocess prepared = preprocess(soup, config, {.viewpoints = 1});
    std::mt19937 random(3);
    std::ranges::shuffle(prepared.lists.hidden, random);
    const std::size_t all = Culler(soup, config).occluders().size();
    for (std::size_t r = 0; r + 1 < prepared.lists.first.size(); ++r) {  // other occluders in the lists, too
      const auto begin = prepared.lists.occluders.begin() + static_cast<std::ptrdiff_t>(prepared.lists.first[r]);
      const auto end = prepared.lists.occluders.begin() + static_cast<std::ptrdiff_t>(prepared.lists.first[r + 1]);
      std::for_each(begin, end, [&](std::uint32_t& i) { i = static_cast<std::uint32_t>((i + 17) % all); });
      std::sort(begin, end);
    }
    const Culler culler(soup, prepared);
    for (int frame = 0; frame < 30; ++frame) {
      const CullResult result = culler.cull(random_camera(random));
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

}  // namespace
