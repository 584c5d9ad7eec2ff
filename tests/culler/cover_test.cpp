// SPDX-License-Identifier: MIT
// Frames by cover: what they cull is hidden by the polygons that are named, in exact arithmetic, and everything else is
// drawn.
#include "occlude/kernel/cover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>
#include <numbers>
#include <random>
#include <span>
#include <string>
#include <thread>
#include <vector>

#include "cover/cover_group.h"
#include "cover/cover_triangles.h"
#include "cover/cull_budget.h"
#include "cover/hiding_meshes.h"
#include "cover/worth_of_hiding.h"
#include "frame/view_memory.h"
#include "frames.h"
#include "model/bounds.h"
#include "model/hierarchy_blocks.h"
#include "model/outer_box.h"
#include "occlude/culler/culler.h"
#include "only_target.h"
#include "sanitized.h"
#include "scenes.h"

namespace cover_test {

using namespace occlude;
using namespace occlude::culler;

constexpr CullOptions kCover{.method = Method::cover, .cover = {.width = 256, .height = 144}};

std::vector<kernel::Vec3> polygon(SoupView soup, std::uint32_t p) {
  std::vector<kernel::Vec3> result;
  for (const std::uint32_t v : soup.loop(p)) result.push_back(to_kernel(soup.vertices[v]));
  return result;
}

/// The half-space beyond the camera's near plane.
kernel::HalfSpace drawn_of(const Camera& camera) {
  const glm::dvec3 forward = camera.axes().forward;
  return {to_kernel(forward), -glm::dot(forward, camera.eye) - camera.near_plane};
}

bool is_hidden(SoupView soup, std::span<const std::uint32_t> polygons, const Camera& camera, const Box& box) {
  std::vector<kernel::Cover::Polygon> cover;
  for (const std::uint32_t p : polygons) cover.push_back(polygon(soup, p));
  const auto made = kernel::Cover::make(camera.viewpoint(), cover, drawn_of(camera));
  return made.cover && std::visit([&](const auto& b) { return kernel::overlap_certified(*made.cover, b).relation; }, box) ==
                           kernel::Relation::inside;
}

Culler culler_of(const PolygonSoup& soup, std::uint32_t leaf = 4, Bounds bounds = Bounds::aabb) {
  BuildConfig config;
  config.hierarchy = {.leaf_size = leaf, .bounds = bounds};
  return Culler(soup, config);
}

/// Expects that the frame draws or culls each polygon once, in order, and that its statistics count them.
void expect_whole(const Culler& culler, const CullResult& frame) {
  std::vector<int> times(culler.hierarchy().soup().size());
  std::size_t in_view = 0, shadowed = 0;
  for (const auto [first, count] : frame.drawn) {
    for (std::uint32_t p = first; p < first + count; ++p) ++times[p];
    in_view += count;
  }
  for (const Culled& culled : frame.culled) {
    const HierarchyNode& node = culler.hierarchy().nodes()[culled.node];
    for (std::uint32_t p = node.first; p < node.first + node.count; ++p) ++times[p];
    if (culled.by == Culled::By::cover) shadowed += node.count;
  }
  EXPECT_EQ(std::ranges::count(times, 1), static_cast<std::ptrdiff_t>(times.size()));
  EXPECT_TRUE(std::ranges::is_sorted(frame.drawn, {}, &PolygonRange::first));
  EXPECT_TRUE(std::ranges::is_sorted(frame.culled, {}, &Culled::node));
  EXPECT_EQ(frame.stats.drawn_polygons, in_view);
  EXPECT_EQ(frame.stats.shadow_culled_polygons, shadowed);
}

class CoverFrames : public testing::TestWithParam<int> {};

TEST_P(CoverFrames, WhatIsCulledIsHiddenByWhatIsNamed) {
  const auto seed = static_cast<std::uint32_t>(GetParam());
  std::mt19937 random(seed);
  const PolygonSoup soup = seed % 2 == 0 ? random_town(seed, 1500) : random_town_of_houses(seed, 1500);
  const Culler culler = culler_of(soup, 1 + seed % 5, seed % 3 == 0 ? Bounds::obb : Bounds::aabb);
  const SoupView& ours = culler.hierarchy().soup();
  std::size_t culls = 0, polygons = 0;
  for (int i = 0; i < 12; ++i) {
    const Camera camera = random_camera(random);
    CullOptions options = kCover;
    if (random() % 3 == 0) options.margin = 1.0 / 256;
    const CullResult frame = culler.cull(camera, options);
    expect_whole(culler, frame);
    std::vector<CoverWitness> witnesses;
    constexpr std::size_t kMost = 60;  // so that some are split
    culler.append_covers(frame, camera, options, kMost, witnesses);
    std::vector<bool> is_proved(ours.size());
    for (const CoverWitness& witness : witnesses) {
      ASSERT_TRUE(is_hidden(ours, witness.polygons, camera, witness.box)) << "seed " << seed << ", camera " << i;
      for (std::uint32_t p = witness.range.first; p < witness.range.first + witness.range.count; ++p) {
        EXPECT_FALSE(is_proved[p]) << "proved twice";
        is_proved[p] = true;
        const kernel::Aabb own = ours.box(p);
        for (int axis = 0; axis < 3; ++axis) {
          EXPECT_TRUE(witness.box.min[axis] <= own.min[axis] && own.max[axis] <= witness.box.max[axis]);
        }
      }
    }
    for (const Culled& culled : frame.culled) {
      if (culled.by != Culled::By::cover) continue;
      ++culls;
      const HierarchyNode& node = culler.hierarchy().nodes()[culled.node];
      polygons += node.count;
      for (std::uint32_t p = node.first; p < node.first + node.count; ++p) EXPECT_TRUE(is_proved[p]);
    }
  }
  EXPECT_GT(culls, 100U);
  EXPECT_GT(polygons, 1000U);
}

// At least a town of each kind.
INSTANTIATE_TEST_SUITE_P(Seeds, CoverFrames, testing::Range(unless_sanitized(1, 2), unless_sanitized(7, 4)));

/// A folded wall of panels, none of which hides much alone, and small walls behind it.
PolygonSoup panels(std::size_t across, int walls = 200) {
  PolygonSoup soup;
  const double step = 10.0 / static_cast<double>(across);
  const auto corner = [&](std::size_t i, std::size_t k) {
    const auto at = [&](std::size_t n) { return -5 + step * static_cast<double>(n); };
    return glm::dvec3{i % 2 == 0 ? 10 : 10.1, at(i), at(k)};
  };
  for (std::size_t i = 0; i < across; ++i) {
    for (std::size_t k = 0; k < across; ++k) {
      add(soup, {corner(i, k), corner(i + 1, k), corner(i + 1, k + 1), corner(i, k + 1)});
    }
  }
  for (int i = 0; i < walls; ++i) add_wall(soup, 20 + i * 0.01, -1, 1, -1, 1);
  return soup;
}

TEST(CoverFrame, PanelsHideTogetherWhatNoneHidesAlone) {
  const PolygonSoup soup = panels(40);
  const Culler culler = culler_of(soup);
  EXPECT_LT(look(culler, {.method = Method::frusta, .occluders = 64}).stats.shadow_culled_polygons, 200U);
  EXPECT_EQ(look(culler, kCover).stats.shadow_culled_polygons, 200U);
}

/// What is seen of a leaf closes pixels for the leaves behind it, however many polygons it has.
TEST(CoverFrame, LeavesOfManyPolygonsHide) {
  PolygonSoup soup = panels(40);
  for (int i = 0; i < 100; ++i) add_wall(soup, 22 + i * 0.01, -1, 1, -1, 1);
  const Culler culler(soup, {.hierarchy = {.leaf_size = 400}});
  for (const HierarchyNode& node : culler.hierarchy().nodes()) EXPECT_TRUE(!node.is_leaf() || node.count > kFewItems);
  EXPECT_EQ(look(culler, kCover).stats.shadow_culled_polygons, 300U);
}

/// A globe of triangles like a planet's, from low over one of its vertices. What lies below is large and near the eye, and
/// much of the rest reaches beyond the picture. All but a few triangles are behind the horizon.
TEST(CoverFrame, AGlobeHidesMostOfItsFarSide) {
  constexpr double kRadius = 6378137;
  constexpr int kAround = 80, kUp = 40;
  PolygonSoup soup;
  const auto at = [](int i, int k) {
    const double turn = 2 * std::numbers::pi * i / kAround, tilt = std::numbers::pi * k / kUp;
    return kRadius * glm::dvec3{std::sin(tilt) * std::cos(turn), std::sin(tilt) * std::sin(turn), std::cos(tilt)};
  };
  for (int k = 0; k < kUp; ++k) {
    for (int i = 0; i < kAround; ++i) {
      if (k > 0) add(soup, {at(i, k), at(i + 1, k + 1), at(i + 1, k)});
      if (k < kUp - 1) add(soup, {at(i, k), at(i, k + 1), at(i + 1, k + 1)});
    }
  }
  Camera camera;
  camera.eye = {0, 0, kRadius + 2000};
  camera.target = camera.eye + glm::dvec3{1000, 0, -20};
  camera.aspect = 16.0 / 9;
  camera.near_plane = 1;
  const Culler culler = culler_of(soup);
  CullOptions options{.method = Method::cover};
  options.margin = 1.0 / 256;
  const CullStats stats = culler.cull(camera, options).stats;
  EXPECT_GT(stats.shadow_culled_polygons, stats.drawn_polygons);
}

/// What was drawn before is drawn again where it touches something, but not all of it that meets at one corner.
TEST(CoverFrame, ACornerOfManyPolygonsTakesLinearTime) {
  constexpr int kCount = 20000;
  PolygonSoup soup;
  const auto rim = [](int i) {
    const double angle = 2 * std::numbers::pi * i / kCount;
    return glm::dvec3{10, 50 * std::cos(angle), 50 * std::sin(angle)};  // far out, or they are too small to be drawn
  };
  for (int i = 0; i < kCount; ++i) add(soup, {{9, 0, 0}, rim(i), rim((i + 1) % kCount)});
  const CullStats stats = look(culler_of(soup), kCover).stats;
  EXPECT_GT(stats.cover_triangles, 1000U);
  EXPECT_LE(stats.cover_triangles, 9U * kCount);
}

/// With parallel rays a pixel is a unit here, and pixels end at whole numbers.
TEST(CoverFrame, WhatIsSeenThroughFewerThanEightPixelsIsNotDrawn) {
  Camera camera;
  camera.target = {10, 0, 0};
  camera.projection = Projection::orthographic;
  camera.aspect = 208.0 / 96;
  camera.height = 96;
  const auto drawn = [&](double across, double up) {
    PolygonSoup soup;
    add_wall(soup, 10, 0.1, across - 0.1, 0.1, up - 0.1);
    return culler_of(soup).cull(camera, kCover).stats.cover_triangles;
  };
  EXPECT_EQ(drawn(7, 1), 0U);
  EXPECT_EQ(drawn(8, 1), 2U);
  EXPECT_EQ(drawn(4, 2), 2U);
}

/// Splinters from corner to corner of their box, which is seen through far more pixels than they cover.
TEST(CoverFrame, WhatCoversFewPixelsIsNotDrawn) {
  const auto drawn = [](double width, const Camera& camera) {
    PolygonSoup soup;
    for (int i = 0; i < 4; ++i) add(soup, {{10, -2, -2}, {10, 2, 2 - width * i}, {10, 2, 2 - width * (i + 1)}});
    return culler_of(soup).cull(camera, kCover).stats.cover_triangles;
  };
  Camera camera;
  camera.target = {10, 0, 0};
  camera.aspect = 208.0 / 96;  // that of the picture without its border, so that pixels are square
  // The height of 96 pixels is 2 * 10 * tan(30 degrees) units: 8.3 pixels are one unit, and the four cover 553 width
  // pixels.
  EXPECT_EQ(drawn(4.0 / 600, camera), 0U);
  EXPECT_EQ(drawn(4.0 / 500, camera), 4U);
  // What begins before the near plane is as large as it may be. From here the formula alone would give 1.4 pixels.
  PolygonSoup passing;
  for (int i = 0; i < 4; ++i) add(passing, {{-1000, 5, -2}, {10, 5, 2 - 0.002 * i}, {10, 5, 2 - 0.002 * (i + 1)}});
  EXPECT_EQ(culler_of(passing).cull(camera, kCover).stats.cover_triangles, 4U);
  camera.eye = {9.5, 0, -2};
  camera.target = {9.5, 2, 0};
  camera.near_plane = 1;
  EXPECT_EQ(drawn(4.0 / 600, camera), 4U);
  Camera parallel;
  parallel.target = {10, 0, 0};
  parallel.projection = Projection::orthographic;
  parallel.aspect = 208.0 / 96;
  parallel.height = 96;  // so that a pixel is a unit, and the four cover 8 width
  EXPECT_EQ(drawn(0.45, parallel), 0U);
  EXPECT_EQ(drawn(0.55, parallel), 4U);
}

/// So many sides meet at its first corner that they are put in order apart from the others.
TEST(CoverFrame, APolygonOfManySidesIsOneSheet) {
  PolygonSoup soup;
  constexpr std::uint32_t kSides = 10000;
  std::vector<std::uint32_t> disc;
  for (std::uint32_t i = 0; i < kSides; ++i) {
    const double angle = 2 * std::numbers::pi * i / kSides;
    disc.push_back(soup.add_vertex({5, 3 * std::cos(angle), 3 * std::sin(angle)}));
  }
  soup.add_polygon(disc);
  add_wall(soup, 8, -1, 1, -1, 1);
  const Culler culler = culler_of(soup, 1);
  Camera camera;
  camera.target = {1, 0, 0};
  EXPECT_EQ(culler.cull(camera, kCover).stats.shadow_culled_polygons, 1U);
}

/// The first frame is as good as any, and so is the one after a jump: nothing is kept from frame to frame.
TEST(CoverFrame, HasNoPast) {
  std::mt19937 random(7);
  const Culler culler = culler_of(random_town_of_houses(7, 1500));
  View view;
  for (int i = 0; i < 20; ++i) {
    const Camera camera = random_camera(random);
    if (i % 3 == 0) culler.cull(camera, {}, view);  // the other method between
    const CullResult& frame = culler.cull(camera, kCover, view);
    const CullResult alone = culler.cull(camera, kCover);
    EXPECT_EQ(frame.drawn, alone.drawn);
    EXPECT_EQ(frame.culled.size(), alone.culled.size());
    EXPECT_TRUE(frame.occluders.empty());
  }
}

/// Fewer triangles hide less. What they hide is still proved, whether triangles or time have run out.
/// How many polygons the witnesses of a frame are about.
std::size_t proved(const Culler& culler, const CullResult& frame, const Camera& camera, const CullOptions& options) {
  std::vector<CoverWitness> witnesses;
  culler.append_covers(frame, camera, options, 1024, witnesses);
  std::size_t proved = 0;
  for (const CoverWitness& witness : witnesses) proved += witness.range.count;
  return proved;
}

std::size_t culled(const CullResult& frame) { return frame.stats.shadow_culled_polygons; }
std::size_t total(const CoverWork& work) { return work.drawing + work.asking; }

TEST(CoverFrame, ABudgetIsKept) {
  const Culler culler = culler_of(panels(40));
  Camera camera;
  camera.target = {1, 0, 0};
  const CullResult whole = culler.cull(camera, kCover);
  EXPECT_EQ(whole.stats.unasked_polygons, 0U);
  EXPECT_GE(whole.stats.cover_work.drawing,
            CoverOptions::kWorkOfTriangle * whole.stats.cover_triangles + whole.stats.cover_tests / 2);
  EXPECT_EQ(whole.stats.cover_work.asking, 0U);
  const std::size_t all = whole.stats.cover_work.drawing;
  std::size_t last = 0;
  for (const std::size_t work : {std::size_t{0}, std::size_t{100}, all / 16, all / 8, all / 4, all / 2, 4 * all}) {
    SCOPED_TRACE(work);
    CullOptions options = kCover;
    options.cover.work = work;
    const CullResult frame = culler.cull(camera, options);
    expect_whole(culler, frame);
    // What is drawn again with a group is counted after it, and the leaves that are asked at the end are not many here.
    EXPECT_LE(total(frame.stats.cover_work), work + 9 * 512 * CoverOptions::kWorkOfTriangle);
    EXPECT_GE(culled(frame), last);
    last = culled(frame);
    EXPECT_EQ(proved(culler, frame, camera, options), culled(frame));
    EXPECT_EQ(proved(culler, frame, camera, kCover), culled(frame)) << "whatever it was that limited it";
    const MissedReasons reasons(culler, camera, options, frame);
    for (std::uint32_t p = 0; p < culler.hierarchy().soup().size(); ++p) {
      if (!culler.cull_of(whole, p) || culler.cull_of(frame, p)) continue;
      EXPECT_GT(frame.stats.unasked_polygons + frame.stats.cover_groups_left, 0U);
      EXPECT_EQ(reasons.answer(p).reason, Missed::left_out);
    }
  }
  EXPECT_EQ(last, culled(whole)) << "with more than enough, nothing is lost";
  EXPECT_GT(last, 0U);
}

CoverOptions options_of(double ms) {
  CoverOptions options;
  options.ms = ms;
  return options;
}

/// A budget of so many milliseconds, of which so many have passed, and more pass while it is asked.
CullBudget budget_of(double ms, double passed) {
  const CoverOptions options = options_of(ms);
  const std::chrono::duration<double, std::milli> before(passed);
  return {options, options.width * options.height,
          CullBudget::Clock::now() - std::chrono::duration_cast<CullBudget::Clock::duration>(before)};
}

/// Minutes lie between the times that are asked for and those at which the answers change.
TEST(Budget, LeavesTimeForAskingAndForTheEndOfTheFrame) {
  constexpr double kHour = 3.6e6;
  for (const double passed : {0.0, 0.6, 0.7}) EXPECT_TRUE(budget_of(kHour, passed * kHour).spend(1)) << passed;
  for (const double passed : {0.8, 0.9}) {
    CullBudget budget = budget_of(kHour, passed * kHour);
    EXPECT_FALSE(budget.spend(1)) << passed;
    budget.begin_asking();
    EXPECT_TRUE(budget.spend(1)) << passed;
    EXPECT_EQ(budget.work(), (CoverWork{0, 1, triangles_of(options_of(kHour))}));
  }
  // What is left is needed to end the frame.
  constexpr double kEnd = 0.07;
  for (const double ms : {kEnd, kHour}) {
    CullBudget budget = budget_of(ms, ms - kEnd);
    EXPECT_FALSE(budget.spend(1)) << ms;
    budget.begin_asking();
    EXPECT_FALSE(budget.spend(1)) << ms;
    EXPECT_TRUE(budget.is_spent());
  }
}

/// As wide as it is high to within a tile, and never larger than asked for or than with a larger budget.
TEST(CoverFrame, ATightBudgetHasASmallerPicture) {
  const Culler culler = culler_of(panels(40));
  CullOptions whole = kCover;
  whole.cover.width = whole.cover.height = 512;
  CullOptions options = whole;
  int last = 0;
  for (const std::size_t triangles : std::initializer_list<std::size_t>{0, 100, 500, 2500, 10000, 100000}) {
    SCOPED_TRACE(triangles);
    options.cover.work = triangles * CoverOptions::kWorkOfTriangle;
    View view;
    const CullResult& frame = culler.cull(Camera{}, options, view);
    const auto size = [&] { return memory_of(view).cover.buffer.picture().width(); };
    const int width = size();
    EXPECT_EQ(memory_of(view).cover.buffer.picture().height(), width);
    EXPECT_GE(width, last);
    EXPECT_LE(width, 512);
    if (triangles == 0) {
      EXPECT_EQ(width, kLeastCoverSide);
    }
    if (triangles == 500) {
      EXPECT_LT(width, 256);
    }
    last = width;
    const CullResult kept = frame;
    culler.cull(Camera{}, repeated(kept, whole), view);
    EXPECT_EQ(size(), width) << "repeated";
  }
  EXPECT_EQ(last, 512);
}

TEST(CoverFrame, WithoutABudgetNothingIsAskedOrDrawn) {
  const Culler culler = culler_of(panels(40));
  const Camera camera;
  const CullResult by_view = culler.cull(camera, {.method = Method::frusta, .occluders = 0});
  CullOptions options = kCover;
  options.cover.work = 0;
  for (const double ms :
       {std::numeric_limits<double>::infinity(), 0.0, -1.0, 1e-9, std::numeric_limits<double>::quiet_NaN()}) {
    options.cover.ms = ms;
    const CullResult frame = culler.cull(camera, options);
    expect_whole(culler, frame);
    EXPECT_EQ(culled(frame), 0U);
    EXPECT_EQ(frame.stats.cover_tests, 0U);
    EXPECT_EQ(frame.stats.unasked_polygons, frame.stats.drawn_polygons);
    EXPECT_EQ(polygons_of(frame.drawn, 1800), polygons_of(by_view.drawn, 1800));
    options.cover.work = std::numeric_limits<std::size_t>::max();  // from here on there is no time
  }
}

TEST(CoverFrame, IsRepeatedWhateverTimeItHad) {
  const Culler culler = culler_of(panels(40));
  const Camera camera;
  CullOptions options = kCover;
  std::size_t cut = 0;
  for (const double ms : {0.02, 0.05, 0.1, 0.2, 0.4, 0.8, 1e6}) {
    SCOPED_TRACE(ms);
    options.cover.ms = ms;
    const CullResult frame = culler.cull(camera, options);
    EXPECT_EQ(proved(culler, frame, camera, options), culled(frame));
    const CullResult again = culler.cull(camera, repeated(frame, options));
    EXPECT_EQ(again.stats.cover_work, frame.stats.cover_work);
    EXPECT_EQ(again.stats.cover_triangles, frame.stats.cover_triangles);
    EXPECT_EQ(again.stats.unasked_polygons, frame.stats.unasked_polygons);
    EXPECT_TRUE(std::ranges::equal(again.culled, frame.culled, {}, &Culled::node, &Culled::node));
    cut += frame.stats.unasked_polygons > 0 ? 1 : 0;
  }
  EXPECT_GT(cut, 0U);
}

/// Triangles without area are counted with those of their leaf, and then not drawn.
TEST(CoverFrame, IsRepeatedWhereTrianglesHaveNoArea) {
  PolygonSoup soup = panels(40);
  const auto panels = static_cast<std::uint32_t>(soup.size());
  for (std::uint32_t p = 0; p < panels; ++p) {
    const std::uint32_t a = soup.loop(p)[0], b = soup.loop(p)[1];
    for (int i = 0; i < 3; ++i) soup.add_polygon(std::array{a, b, a, b});
  }
  const Culler culler = culler_of(soup, 16);
  Camera camera;
  camera.target = {1, 0, 0};
  const std::size_t all = culler.cull(camera, kCover).stats.cover_work.drawing;
  for (std::size_t k = 1; k < 40; ++k) {
    CullOptions options = kCover;
    options.cover.work = all * k / 40;
    const CullResult frame = culler.cull(camera, options);
    EXPECT_LE(frame.stats.cover_work.drawing, all);
    EXPECT_EQ(proved(culler, frame, camera, options), culled(frame)) << k;
    const CullStats again = culler.cull(camera, repeated(frame, options)).stats;
    EXPECT_EQ(again.cover_work, frame.stats.cover_work) << k;
    EXPECT_EQ(again.cover_triangles, frame.stats.cover_triangles) << k;
  }
}

/// A third of what is in view is hidden from the front, and nothing from behind.
Camera from_behind() {
  Camera camera;
  camera.eye = {200, 0, 0};
  camera.target = {0, 0, 0};
  return camera;
}

TEST(Automatic, RestsWhereLittleIsHiddenAndTriesAgain) {
  const Culler culler = culler_of(panels(100, 5000));
  const Camera hides, shows = from_behind();
  const CullOptions options;
  ASSERT_EQ(options.method, Method::automatic);
  const CullResult whole = culler.cull(hides, {.method = Method::cover});
  const std::size_t hidden = culled(whole);
  ASSERT_GT(3 * hidden, whole.stats.drawn_polygons);
  View view;
  for (int i = 0; i < 40; ++i) EXPECT_EQ(culled(culler.cull(hides, options, view)), hidden);
  ASSERT_LT(4 * culled(culler.cull(shows, {.method = Method::cover})),
            culler.cull(shows, {.method = Method::frusta, .occluders = 0}).stats.drawn_polygons);
  std::size_t rests = 0;
  for (int i = 0; i < 60; ++i) rests += total(culler.cull(shows, options, view).stats.cover_work) == 0 ? 1 : 0;
  EXPECT_GT(rests, 36U);
  EXPECT_EQ(culled(culler.cull(hides, options, view)), hidden) << "it has turned";
  EXPECT_EQ(culler.cull(hides, options).stats.cover_work, whole.stats.cover_work) << "a frame without a view has no past";
}

/// A square across the x axis, or beside it.
void add_square(PolygonSoup& soup, double x, double y, double half_edge) {
  const std::uint32_t a = soup.add_vertex({x, y - half_edge, -half_edge}),
                      b = soup.add_vertex({x, y + half_edge, -half_edge}),
                      c = soup.add_vertex({x, y + half_edge, half_edge}), d = soup.add_vertex({x, y - half_edge, half_edge});
  soup.add_polygon(std::array{a, b, c, d});
}

/// A wall hides many things. Beside it stand others that hide nothing, and of which none is hidden.
PolygonSoup wall_and_bystanders() {
  PolygonSoup soup;
  add_square(soup, 10, 0, 3);
  for (int i = 0; i < 200; ++i) add_square(soup, 40 + 0.01 * i, 0.03 * i - 3, 0.5);   // behind it
  for (int i = 0; i < 100; ++i) add_square(soup, 20, 6 + 0.02 * i, 0.1 + 0.001 * i);  // beside it
  return soup;
}

TEST(Automatic, SavesTheWorkOnWhatIsIdle) {
  const Culler culler = culler_of(wall_and_bystanders());
  Camera camera;
  const CullOptions options;
  View view;
  culler.cull(camera, options, view);
  memory_of(view).worth.cheap = 0;
  const CullResult look = culler.cull(camera, options, view);
  EXPECT_TRUE(look.idle.empty());
  ASSERT_EQ(culled(look), 200U);
  for (int frame = 1; frame < 20; ++frame) {
    SCOPED_TRACE(frame);
    camera.eye.y = 0.01 * frame;
    const CullResult result = culler.cull(camera, options, view);
    expect_whole(culler, result);
    const CullStats whole = culler.cull(camera, {.method = Method::cover}).stats;
    const bool looks = (frame + 1) % 6 == 0;
    EXPECT_EQ(result.idle.empty(), looks);
    EXPECT_EQ(result.stats.cover_triangles, looks ? whole.cover_triangles : 2U) << "the wall alone";
    EXPECT_EQ(result.stats.nodes_visited == whole.nodes_visited, looks);
    EXPECT_EQ(result.stats.shadow_culled_polygons, 200U) << "the wall hides as ever";
    EXPECT_EQ(proved(culler, result, camera, options), 200U);
  }
}

/// What a frame took as idle is in its result, so that it can be done again.
TEST(Automatic, IsRepeated) {
  std::mt19937 random(88);
  const Culler culler = culler_of(random_town_of_houses(8, 1500));
  View view;
  Camera camera = random_camera(random);
  std::size_t idle = 0;
  for (int frame = 0; frame < 60; ++frame) {
    SCOPED_TRACE(frame);
    camera.eye.x += 0.05;
    CullOptions options;
    if (frame % 4 == 3) options.cover.work = 4000;
    const CullResult result = culler.cull(camera, options, view);
    memory_of(view).worth.cheap = 0;
    expect_whole(culler, result);
    idle += result.idle.size();
    EXPECT_EQ(proved(culler, result, camera, options), culled(result));
    const CullResult again = culler.cull(camera, repeated(result, options));
    EXPECT_EQ(again.drawn, result.drawn);
    EXPECT_EQ(again.idle, result.idle);
    EXPECT_EQ(again.stats.cover_work, result.stats.cover_work);
    const MissedReasons reasons(culler, camera, options, result);
    const CullResult whole = culler.cull(camera, {.method = Method::cover});
    for (std::uint32_t p = 0; p < culler.hierarchy().soup().size(); ++p) {
      if (!culler.cull_of(whole, p) || culler.cull_of(result, p)) continue;
      const Missed reason = reasons.answer(p).reason;
      EXPECT_TRUE(reason == Missed::left_out || reason == Missed::out_of_view) << to_string(reason);
    }
  }
  EXPECT_GT(idle, 0U);
}

/// The kinds of the next frames, in each of which so much is hidden.
std::string kinds(WorthOfHiding& worth, std::size_t frames, std::size_t hidden, std::size_t drawn,
                  std::size_t work = 100'000) {
  std::string kinds;
  for (std::size_t i = 0; i < frames; ++i) {
    worth.begin_next(FrameView{Camera{}, 100});
    kinds += "WLSTR"[static_cast<std::size_t>(worth.frame())];
    worth.learn(hidden, drawn, {work, 0, 0});
  }
  return kinds;
}

/// Otherwise views would rest with the larger of two budgets, and hide less with it.
TEST(WorthOfHiding, LessWorkNeedHideLess) {
  const auto rests = [](std::size_t hidden, std::size_t work) {
    WorthOfHiding worth;
    return kinds(worth, 200, hidden, 100 - hidden, work).find('R') != std::string::npos;
  };
  EXPECT_FALSE(rests(13, 49'000));
  EXPECT_TRUE(rests(12, 49'500));
  EXPECT_TRUE(rests(13, 60'000));
  EXPECT_FALSE(rests(6, 20'000));
  EXPECT_TRUE(rests(4, 20'000));
  EXPECT_TRUE(rests(24, 1'000'000)) << "a quarter is enough for any";
  EXPECT_FALSE(rests(26, 1'000'000));
}

TEST(WorthOfHiding, PaysFromAQuarterOn) {
  WorthOfHiding worth;
  EXPECT_EQ(kinds(worth, 13, 26, 74), "LSSSSSLSSSSSL");
  EXPECT_EQ(kinds(worth, 2000, 26, 74).find('R'), std::string::npos);
  EXPECT_EQ(kinds(worth, 4, 0, 20).find('R'), std::string::npos) << "so little is in view that it hardly counts";
  EXPECT_EQ(kinds(worth, 40, 0, 0).find('R'), std::string::npos) << "nothing is in view";
  const std::string pays = kinds(worth, 200, 24, 76);
  EXPECT_NE(pays.find('R'), std::string::npos);
  EXPECT_EQ(pays.find('S', pays.find("RRRRRR")), std::string::npos);
  WorthOfHiding small;
  EXPECT_EQ(kinds(small, 20, 0, 100, 10'000), 'L' + std::string(19, 'W'));
  // Tries come later and later, and one look that finds a quarter is enough.
  worth = {};
  const std::string rests = kinds(worth, 200, 0, 100);
  EXPECT_EQ(rests.substr(0, 4), "LTRR") << "a try ends the hopes of a view that begins";
  std::vector<std::size_t> tries;
  for (std::size_t i = 2; i < rests.size(); ++i) {
    if (rests[i] != 'R') tries.push_back(rests[i] == 'T' ? i : 0);
  }
  EXPECT_EQ(tries, (std::vector<std::size_t>{13, 37, 85, 133, 181}));
  Camera turned;
  turned.target = {-1, 0, 0};
  WorthOfHiding elsewhere = worth;
  elsewhere.begin_next(FrameView{turned, 100});
  EXPECT_EQ(elsewhere.frame(), WorthOfHiding::Frame::looks);
  WorthOfHiding changed = worth;
  changed.begin_next(FrameView{Camera{}, 100}, true);
  EXPECT_EQ(changed.frame(), WorthOfHiding::Frame::tries) << "though it rested";
  const std::string again = kinds(worth, 60, 25, 75);
  const std::size_t first_try = again.find('T');
  EXPECT_EQ(again.substr(first_try, 8), "TLSSSSSL");
}

/// As one that comes out from behind a wall: what it sees then, no look has found idle.
TEST(WorthOfHiding, FramesThatTakeTwiceTheWorkOfALookLookNext) {
  WorthOfHiding worth;
  EXPECT_EQ(kinds(worth, 2, 50, 50, 20'000), "LS");
  EXPECT_EQ(kinds(worth, 1, 50, 50, 40'000), "S");
  EXPECT_EQ(kinds(worth, 1, 50, 50, 40'001), "S");
  EXPECT_EQ(kinds(worth, 7, 50, 50, 40'001), "LSSSSSL");
  EXPECT_EQ(kinds(worth, 7, 50, 50, 100), "SSSSSLW");
  EXPECT_EQ(kinds(worth, 4, 50, 50, 20'000), "WLSS");
}

TEST(WorthOfHiding, ViewsThatTryTakeLittleWork) {
  CoverOptions options;
  WorthOfHiding worth;
  kinds(worth, 1, 0, 100);
  EXPECT_EQ(worth.limited(options).work, options.work) << "the first frame looks at all";
  kinds(worth, 1, 0, 100);
  ASSERT_EQ(worth.frame(), WorthOfHiding::Frame::tries);
  EXPECT_EQ(worth.limited(options).work, 196'608U);
  options.work = 1000;
  EXPECT_EQ(worth.limited(options).work, 1000U) << "a budget is not exceeded";
}

/// A try that hides a tenth of what is in view leads to a look, one that hides less does not. With a budget below that of a
/// try, less is enough.
TEST(WorthOfHiding, ATryTellsWhetherToLook) {
  const auto first = [](std::size_t hidden, std::size_t work) {
    WorthOfHiding worth;
    return kinds(worth, 3, hidden, 100 - hidden, work);
  };
  EXPECT_EQ(first(10, 300'000), "LTL");
  EXPECT_EQ(first(9, 300'000), "LTR");
  EXPECT_EQ(first(5, 98'304), "LTL");
  EXPECT_EQ(first(4, 98'304), "LTR");
  EXPECT_EQ(first(25, 300'000), "LSS") << "what pays is not tried";
}

/// A picture in which a square hides, and one beside it does not.
TEST(HidingMeshes, AreThoseInWhosePixelsSomethingIsHidden) {
  const FrameView view(Camera{}, 100);
  CoverBuffer buffer;
  buffer.begin(view, 128, 128, 0);
  buffer.keep_closings();
  const auto draw = [&](double x, double y, double half_edge, std::uint32_t id) {
    PolygonSoup soup;
    add_square(soup, x, y, half_edge);
    const CoverTriangles triangles = CoverTriangles::find(soup);
    CoverGroup group;
    group.add(triangles, 0, {});
    buffer.add(group.mesh(triangles, {}), id);
  };
  draw(20, 0, 3, 1);  // behind the next one
  draw(10, 0, 2, 2);
  draw(10, 5, 1, 3);  // beside it
  const kernel::Aabb hidden{{30, -1, -1}, {31, 1, 1}};
  ASSERT_TRUE(buffer.hides(hidden));
  HidingMeshes hiding;
  hiding.begin(buffer);
  hiding.hide(buffer.footprint(hidden).pixels);
  hiding.find(buffer.closings());
  EXPECT_FALSE(hiding.has_hidden(1)) << "another one is nearer";
  EXPECT_TRUE(hiding.has_hidden(2));
  EXPECT_FALSE(hiding.has_hidden(3));
  const PixelRectangle at = buffer.footprint(hidden).pixels;
  EXPECT_TRUE(hiding.has_hidden(2, at));
  EXPECT_TRUE(hiding.has_hidden(2, {at.x1 - 1, at.y1 - 1, 128, 128}));
  EXPECT_FALSE(hiding.has_hidden(2, {at.x1, at.y0, 128, at.y1})) << "nothing is hidden there";
  EXPECT_FALSE(hiding.has_hidden(2, {0, 0, at.x0, 128}));
}

TEST(CoverFrame, IsTheSameForEveryInstructionSet) {
  std::mt19937 random(8);
  const Culler culler = culler_of(random_town_of_houses(8, 1500));
  for (int i = 0; i < 20; ++i) {
    const Camera camera = random_camera(random);
    const CullResult expected = culler.cull(camera, kCover);
    for (const std::int64_t target : hwy::SupportedAndGeneratedTargets()) {
      const OnlyTarget only(target);
      EXPECT_EQ(culler.cull(camera, kCover).drawn, expected.drawn) << hwy::TargetName(target);
    }
  }
}

TEST(CoverFrame, IsTheSameFromSeveralThreads) {
  std::mt19937 random(8);
  const Culler culler = culler_of(random_town_of_houses(8, 1500));
  const Camera camera = random_camera(random);
  const CullResult alone = culler.cull(camera, kCover);
  std::vector<CullResult> others(4);
  std::vector<std::thread> threads;
  for (CullResult& other : others) threads.emplace_back([&] { other = culler.cull(camera, kCover); });
  for (std::thread& thread : threads) thread.join();
  for (const CullResult& other : others) EXPECT_EQ(other.drawn, alone.drawn);
}

TEST(CoverFrame, APictureOfAnySizeIsTaken) {
  const Culler culler = culler_of(panels(20));
  for (const auto& [width, height] : {std::pair{0, 0}, {-5, 100000}, {65, 71}, {333, 100}}) {
    CullOptions options = kCover;
    options.cover.width = width;
    options.cover.height = height;
    expect_whole(culler, look(culler, options));
  }
}

/// A view answers from the picture of its last frame.
TEST(CoverFrame, ViewsAnswerByIt) {
  const Culler culler = culler_of(panels(40));
  View view;
  culler.cull(Camera{}, kCover, view);
  const auto ask = [&](double x, double y, double half) {
    return view.visibility(kernel::Aabb{{x - half, y - half, -half}, {x + half, y + half, half}});
  };
  EXPECT_EQ(ask(15, 0, 1), Visibility::occluded);
  EXPECT_EQ(ask(15, 9, 0.5), Visibility::visible);
  EXPECT_EQ(ask(9, 0, 0.5), Visibility::visible);
  EXPECT_EQ(ask(-9, 0, 0.5), Visibility::out_of_view);
  EXPECT_EQ(ask(1e9, 0, 1), Visibility::visible) << "farther than the culler knows by how much places are out";
  culler.cull(Camera{}, {.method = Method::frusta, .occluders = 0}, view);
  EXPECT_EQ(ask(15, 0, 1), Visibility::visible) << "another frame, by the other method";
}

}  // namespace cover_test
