// SPDX-License-Identifier: MIT
// The pipeline against brute force, and the situations in which other cullers fail.
#include "occlude/culler/culler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "descent/traversal.h"
#include "executors.h"
#include "frame/culler_access.h"
#include "frame/view_memory.h"
#include "frames.h"
#include "frusta/occluder_history.h"
#include "model/bounds.h"
#include "occlude/kernel/half_space.h"
#include "occlude/kernel/overlap.h"
#include "occlude/kernel/validity.h"
#include "scenes.h"

namespace culler_test {

using namespace occlude;
using namespace occlude::culler;

/// The polygons to draw if every leaf is tested against every half-space and shadow. The ancestors of a leaf cull no more,
/// because their axis-aligned boxes hold the leaf's.
std::vector<bool> brute_force(const Culler& culler, const CullResult& frame, kernel::Arithmetic arithmetic,
                              kernel::Test test) {
  std::vector<bool> drawn(culler.hierarchy().soup().size(), false);
  for (std::uint32_t n = 0; n < culler.hierarchy().nodes().size(); ++n) {
    const Hierarchy::Node& node = culler.hierarchy().nodes()[n];
    if (!node.is_leaf()) continue;
    const bool visible = culler.hierarchy().ask(n, [&](const auto& box) {
      for (const HalfSpace& h : frame.view) {
        if (kernel::relation(to_kernel(h), box, arithmetic) == kernel::Relation::outside) return false;
      }
      for (const Occluder& o : frame.occluders) {
        const auto decision = kernel::decide(o.frustum, box, arithmetic, test, kernel::NearBoundary::open);
        if (decision.relation == kernel::Relation::inside && !holds_part(culler, node, o)) return false;
      }
      return true;
    });
    for (std::uint32_t p = node.first; p < node.first + node.count; ++p) drawn[p] = visible;
  }
  return drawn;
}

TEST(Culler, DrawsWhatBruteForceDraws) {
  const Culler culler(random_town(1, 4000));
  constexpr std::uint32_t kSeed = 42;
  std::mt19937 random(kSeed);
  std::size_t culled = 0;
  for (int i = 0; i < 200; ++i) {
    const Camera camera = random_camera(random);
    CullOptions options{.method = Method::frusta};
    options.shadow_near = i % 2 ? kernel::Near::surface : kernel::Near::farthest;
    options.test = i % 3 ? kernel::Test::conservative : kernel::Test::overlap;
    const CullResult frame = culler.cull(camera, options);
    ASSERT_EQ(drawn_polygons(culler, frame), brute_force(culler, frame, options.arithmetic, options.test))
        << "seed " << kSeed;
    const CullStats& stats = frame.stats;
    ASSERT_EQ(stats.drawn_polygons + stats.view_culled_polygons + stats.shadow_culled_polygons,
              culler.hierarchy().soup().size());
    culled += stats.shadow_culled_polygons;
  }
  EXPECT_GT(culled, 10000U);
}

TEST(Culler, BothTestsCullTheSame) {
  // `overlap` only distinguishes outside from partial better than `conservative`: fewer tests, never another picture.
  const Culler culler(random_town(2, 3000));
  std::mt19937 random(9);
  for (int i = 0; i < 50; ++i) {
    const Camera camera = random_camera(random);
    CullOptions overlap{.method = Method::frusta};
    overlap.test = kernel::Test::overlap;
    EXPECT_EQ(culler.cull(camera, {.method = Method::frusta}).drawn, culler.cull(camera, overlap).drawn);
  }
}

TEST(Culler, EveryVertexOfAShadowedPolygonIsInTheShadow) {
  const Culler culler(random_town_of_houses(3, 3000));
  const SoupView soup = culler.hierarchy().soup();
  std::mt19937 random(77);
  for (int i = 0; i < 50; ++i) {
    const CullResult frame = culler.cull(random_camera(random), {});
    for (const auto [first, count] : frame.drawn) {
      for (std::uint32_t p = first; p < first + count; ++p) ASSERT_EQ(culler.cull_of(frame, p), nullptr);
    }
    for (const Culled& culled : frame.culled) {
      const Hierarchy::Node& node = culler.hierarchy().nodes()[culled.node];
      for (std::uint32_t p = node.first; p < node.first + node.count; ++p) ASSERT_EQ(culler.cull_of(frame, p), &culled);
      if (culled.by != Culled::By::shadow) continue;
      const Occluder& occluder = frame.occluders[culled.index];
      ASSERT_FALSE(holds_part(culler, node, occluder)) << "hides itself";
      for (std::uint32_t p = node.first; p < node.first + node.count; ++p) {
        for (const std::uint32_t index : soup.loop(p)) {
          const glm::dvec3& v = soup.vertices[index];
          const kernel::Vec3 point{v.x, v.y, v.z};
          ASSERT_EQ(kernel::overlap_certified(occluder.frustum, kernel::Aabb{point, point}).relation,
                    kernel::Relation::inside);
        }
      }
    }
  }
}

TEST(Culler, HidesWhatIsBehindAWallAndNothingElse) {
  PolygonSoup soup;
  add_wall(soup, 2, -1, 1, -1, 1);                            // 0, the wall
  add_wall(soup, 4, -2, 2, -2, 2);                            // 1, exactly in its shadow, border included
  add_wall(soup, 4.25, -2, std::nextafter(2.125, 3), -2, 2);  // 2, one ulp beyond its shadow
  add_wall(soup, 1, -0.1, 0.1, -0.1, 0.1);                    // 3, before it
  add_wall(soup, -4, -1, 1, -1, 1);                           // 4, behind the eye
  const Culler culler = one_polygon_leaves(soup);
  CullOptions only_the_wall{.method = Method::frusta};
  only_the_wall.occluders = 1;
  const CullResult frame = look(culler, only_the_wall);
  ASSERT_EQ(frame.occluders.size(), 1U);
  ASSERT_EQ(original(culler, frame.occluders[0]), 0U);
  EXPECT_TRUE(is_drawn(culler, frame, 0));
  EXPECT_FALSE(is_drawn(culler, frame, 1));
  EXPECT_TRUE(is_drawn(culler, frame, 2));
  EXPECT_TRUE(is_drawn(culler, frame, 3));
  EXPECT_FALSE(is_drawn(culler, frame, 4));
}

TEST(Culler, ParallelRaysHideWhatIsBehindAWallAndNotWhatIsBefore) {
  PolygonSoup soup;
  add_wall(soup, 4, -2, 2, -2, 2);
  add_wall(soup, 2, -1, 1, -1, 1);
  add_wall(soup, 6, -1, 1, -1, 1);
  const Culler culler = one_polygon_leaves(soup);
  Camera camera;
  camera.projection = Projection::orthographic;
  camera.height = 10;
  CullOptions only_the_wall{.method = Method::frusta};
  only_the_wall.occluders = 1;
  const CullResult frame = culler.cull(camera, only_the_wall);
  EXPECT_TRUE(is_drawn(culler, frame, 0));
  EXPECT_TRUE(is_drawn(culler, frame, 1));
  EXPECT_FALSE(is_drawn(culler, frame, 2));
}

/// The line of sight deviates from an axis by less than the smallest number of the kernel.
TEST(Culler, ParallelRaysHideThoughTheyAreTurnedByNextToNothing) {
  PolygonSoup soup;
  add_wall(soup, 4, -2, 2, -2, 2);
  add_wall(soup, 6, -1, 1, -1, 1);
  const Culler culler = one_polygon_leaves(soup);
  Camera camera;
  camera.projection = Projection::orthographic;
  camera.height = 10;
  for (const double turned : {1e-29, -1e-29, 1e-27, 1e-20, 1e-12, 0.0}) {
    camera.target = {1000, 0, turned};
    ASSERT_EQ(fault(camera), "");
    EXPECT_EQ(camera.viewpoint().value, to_kernel(camera.axes().forward));
    EXPECT_EQ(kernel::check(camera.viewpoint()), kernel::Refusal::none);
    EXPECT_FALSE(is_drawn(culler, culler.cull(camera, {.method = Method::frusta}), 1)) << turned;
  }
}

TEST(Culler, GapsOfOneUlpBetweenWallsStayOpen) {
  PolygonSoup soup;
  add_wall(soup, 2, -1, 0, -1, 1);
  add_wall(soup, 2, std::nextafter(0.0, 1.0) + 0x1p-60, 1, -1, 1);
  add_wall(soup, 4, -0.5, 0.5, -0.5, 0.5);  // behind both, and behind neither alone
  const Culler culler = one_polygon_leaves(soup);
  EXPECT_TRUE(is_drawn(culler, look(culler), 2));
}

TEST(Culler, CoplanarPolygonsAreDrawn) {
  PolygonSoup soup;
  add_wall(soup, 2, -1, 1, -1, 1);
  add_wall(soup, 2, -0.5, 0.5, -0.5, 0.5);
  const Culler culler = one_polygon_leaves(soup);
  EXPECT_TRUE(is_drawn(culler, look(culler), 1));
}

TEST(Culler, SceneFarFromTheOriginIsCulledAlike) {
  const double o = 4e9;
  PolygonSoup soup;
  add_wall(soup, o + 2, o - 1, o + 1, o - 1, o + 1);
  add_wall(soup, o + 4, o - 2, o + 2, o - 2, o + 2);
  add_wall(soup, o + 4.5, o - 2, o + 2.5, o - 2, o + 2);
  const Culler culler = one_polygon_leaves(soup);
  Camera camera;
  camera.eye = {o, o, o};
  camera.target = {o + 1, o, o};
  CullOptions options{.method = Method::frusta};
  options.occluders = 1;
  const CullResult frame = culler.cull(camera, options);
  EXPECT_TRUE(is_drawn(culler, frame, 0));
  EXPECT_FALSE(is_drawn(culler, frame, 1));
  EXPECT_TRUE(is_drawn(culler, frame, 2));
}

TEST(Culler, AnOccluderInAnothersShadowIsNotChosen) {
  PolygonSoup soup;
  add_wall(soup, 2, -1, 1, -1, 1);
  add_wall(soup, 3, -1, 1, -1, 1);
  add_wall(soup, 3, 2, 4, -1, 1);
  const Culler culler = one_polygon_leaves(soup);
  const CullResult frame = look(culler);
  ASSERT_EQ(frame.occluders.size(), 2U);
  EXPECT_EQ(original(culler, frame.occluders[0]), 0U);
  EXPECT_EQ(original(culler, frame.occluders[1]), 2U);
}

TEST(Culler, ZeroOccludersIsViewFrustumCulling) {
  const Culler culler(random_town(5, 1000));
  CullOptions options{.method = Method::frusta};
  options.occluders = 0;
  const CullResult frame = look(culler, options);
  EXPECT_EQ(frame.stats.shadow_tests, 0U);
  EXPECT_GT(frame.stats.view_culled_polygons, 0U);
}

std::vector<HalfSpace> view_frustum(const Camera& camera) {
  std::vector<HalfSpace> planes;
  append_view_frustum(camera, 1e6, planes);
  return planes;
}

TEST(ViewFrustum, HoldsAllThatTheCameraShows) {
  std::mt19937 random(6);
  for (int i = 0; i < 200; ++i) {
    const Camera camera = random_camera(random);
    const auto [right, up, forward] = camera.axes();
    for (const double depth : {camera.near_plane, std::isfinite(camera.far_plane) ? camera.far_plane : 1e6}) {
      const double half = camera.projection == Projection::perspective
                              ? std::tan(camera.fov_y_deg / 360 * 3.14159265358979323846) * depth
                              : camera.height / 2;
      for (const double x : {-1.0, 1.0}) {
        for (const double y : {-1.0, 1.0}) {
          const glm::dvec3 corner = camera.eye + depth * forward + half * (x * camera.aspect * right + y * up);
          for (const HalfSpace& h : view_frustum(camera)) EXPECT_GE(glm::dot(h.normal, corner) + h.offset, 0);
        }
      }
    }
  }
}

/// What is beside one border of the picture is beyond the plane of that border, and of no other.
TEST(ViewFrustum, IsClosedOnEverySideOfThePicture) {
  std::mt19937 random(6);
  for (int i = 0; i < 200; ++i) {
    const Camera camera = random_camera(random);
    const auto [right, up, forward] = camera.axes();
    const double away = 20, half = camera.projection == Projection::perspective
                                       ? std::tan(camera.fov_y_deg / 360 * 3.14159265358979323846) * away
                                       : camera.height / 2;
    const double across = camera.aspect * half, beside = 5;  // more than the margin of the planes, 2^-20 of the depth
    const glm::dvec3 middle = camera.eye + away * forward;
    std::vector<glm::dvec3> outside{middle - (across + beside) * right, middle + (across + beside) * right,
                                    middle - (half + beside) * up, middle + (half + beside) * up,
                                    camera.eye - beside * forward};
    if (std::isfinite(camera.far_plane)) outside.push_back(camera.eye + (camera.far_plane + beside) * forward);
    const std::vector<HalfSpace> planes = view_frustum(camera);
    ASSERT_EQ(planes.size(), outside.size());
    for (std::size_t k = 0; k < planes.size(); ++k) {
      for (std::size_t p = 0; p < planes.size(); ++p) {
        if (p != k && k == 4) continue;  // behind the eye one is beyond the sides as well
        EXPECT_EQ(glm::dot(planes[p].normal, outside[k]) + planes[p].offset < 0, p == k) << "point " << k << ", plane " << p;
      }
    }
  }
}

/// Points at the very edges of the picture of parallel rays, farther and farther away. The axes are (0.6, 0.8, 0) and (0.8,
/// -0.6, 0), which no doubles are; the points have whole coordinates.
TEST(ViewFrustum, HoldsWhatParallelRaysShowHoweverFarAway) {
  Camera camera;
  camera.projection = Projection::orthographic;
  camera.target = {3, 4, 0};
  camera.height = 10;
  camera.aspect = 1;
  for (const double away : {1.0, 0x1p20, 0x1p30, 0x1p40, 0x1p50}) {
    std::vector<HalfSpace> planes;
    append_view_frustum(camera, 8 * away, planes);
    for (const double side : {-1.0, 1.0}) {
      for (const double height : {-5.0, 5.0}) {
        const kernel::Vec3 shown{3 * away + side * 4, 4 * away - side * 3, height};
        for (const HalfSpace& h : planes) {
          EXPECT_EQ(kernel::relation(to_kernel(h), kernel::Aabb{shown, shown}, kernel::Arithmetic::certified),
                    kernel::Relation::inside)
              << away;
        }
      }
    }
  }
}

/// Points beside the view by no more than 2^-21 of the model's depth. A renderer in single precision may draw them, so they
/// must not be culled.
TEST(ViewFrustum, HoldsWhatSinglePrecisionMovesIntoThePicture) {
  constexpr double kDepth = 0x1p20;
  Camera camera;
  camera.fov_y_deg = 90;
  camera.aspect = 1;
  camera.height = 2;
  camera.far_plane = 3;
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    camera.projection = projection;
    std::vector<HalfSpace> planes;
    append_view_frustum(camera, kDepth, planes);
    for (const glm::dvec3& beside :
         {glm::dvec3{1, 1.5, 0}, {1, -1.5, 0}, {1, 0, 1.5}, {1, 0, -1.5}, {-0.4, 0, 0}, {3.5, 0, 0}}) {
      for (const HalfSpace& h : planes) EXPECT_GT(glm::dot(h.normal, beside) + h.offset, 0);
    }
  }
}

TEST(Culler, RefusesModelsAndCamerasThatCannotBeRight) {
  EXPECT_EQ(refusal([] { Culler(PolygonSoup{}); }), "the soup has no polygon");
  PolygonSoup soup = random_town(4, 100);
  EXPECT_EQ(refusal([&] { Culler(soup, {.lists = {.threshold = 0}}); }), "the threshold of the lists must be above 0");
  EXPECT_EQ(refusal([&] { Culler(soup, {.lists = {.regions = 0x1.8p30}}); }),
            "the number of regions must be from 1 to 2^30");
  const Culler culler(soup);
  soup.vertices[7].y = std::nan("");
  EXPECT_EQ(refusal([&] { Culler{soup}; }), "vertex 7: number is not finite");
  soup.vertices[7].y = 1e300;
  EXPECT_EQ(refusal([&] { Culler{soup}; }).substr(0, 29), "vertex 7: number out of range");

  const auto fault_with = [&](auto&& change) {
    Camera camera;
    change(camera);
    const std::string reason = fault(camera);
    EXPECT_EQ(refusal([&] { static_cast<void>(culler.cull(camera, {.method = Method::frusta})); }),
              reason.empty() ? "" : "camera: " + reason);
    return reason;
  };
  EXPECT_EQ(fault_with([](Camera&) {}), "");
  EXPECT_NE(fault_with([](Camera& c) { c.eye.x = std::nan(""); }), "");
  EXPECT_NE(fault_with([](Camera& c) { c.target = c.eye; }), "");
  EXPECT_NE(fault_with([](Camera& c) { c.up = c.target - c.eye; }), "");
  EXPECT_NE(fault_with([](Camera& c) { c.fov_y_deg = 180; }), "");
  EXPECT_NE(fault_with([](Camera& c) { c.fov_y_deg = 1e-9; }), "");
  EXPECT_NE(fault_with([](Camera& c) { c.near_plane = 0; }), "");
  EXPECT_NE(fault_with([](Camera& c) { c.far_plane = c.near_plane; }), "");
  EXPECT_NE(fault_with([](Camera& c) { c.height = 1e-200; }), "");
}

/// A walk through a town, and what was found of each of its frames.
struct Walk {
  std::vector<std::size_t> found;
  std::size_t deferred = 0;  ///< subtrees
  std::size_t divided = 0;   ///< parts of lists
};
Walk walk_on(const Culler& culler, const Executor& executor, CullOptions options) {
  options.executor = &executor;
  View view;
  Walk walk;
  for (int frame = 0; frame < 60; ++frame) {
    Camera camera;
    camera.eye = {frame - 30, 3, 2};
    camera.target = {40, -10, 2};
    const CullResult& result = culler.cull(camera, options, view);
    for (const PolygonRange& range : result.drawn) walk.found.insert(walk.found.end(), {range.first, range.count});
    for (const Culled& c : result.culled) walk.found.insert(walk.found.end(), {c.node, c.index, c.second});
    for (const Occluder& o : result.occluders) walk.found.insert(walk.found.end(), {o.index, o.hidden});
    const CullStats& stats = result.stats;
    walk.found.insert(walk.found.end(), {stats.nodes_visited, stats.view_tests, stats.shadow_tests, stats.union_tests,
                                         stats.probe_tests, stats.exact_shadow_tests, stats.drawn_polygons,
                                         stats.view_culled_polygons, stats.shadow_culled_polygons});
    walk.found.insert(walk.found.end(), {stats.potential_occluders, stats.occluders_in_view, stats.sort_kept,
                                         stats.sort_moves, stats.sort_comparisons});
    walk.deferred += memory_of(view).frusta.parts.deferred.size;
    const auto has_groups = [](const ChoiceSlice& part) { return part.first < part.end; };
    walk.divided += static_cast<std::size_t>(std::ranges::count_if(memory_of(view).frusta.choice_slices, has_groups));
  }
  return walk;
}

/// The choice of each frame depends on what was counted in those before.
TEST(Culler, AWalkDoesNotDependOnTheExecutor) {
  const Culler culler(random_town_of_houses(11, 4000), {.hierarchy = {.leaf_size = 4}, .lists = {.regions = 64}});
  for (const CullOptions& options :
       {CullOptions{.method = Method::frusta}, CullOptions{.method = Method::frusta, .occluders = 0},
        CullOptions{.method = Method::frusta, .occluders = 3, .probes = 0},
        CullOptions{.method = Method::frusta, .shadow_near = kernel::Near::farthest},
        CullOptions{.method = Method::frusta, .unions = true}}) {
    const Walk expected = walk_on(culler, Executor(), options);
    EXPECT_EQ(expected.deferred, 0U);
    for (const Executor& executor : some_executors()) {
      const Walk walk = walk_on(culler, executor, options);
      EXPECT_EQ(walk.found, expected.found) << executor.threads() << " threads";
      EXPECT_EQ(walk.deferred > 60, executor.threads() > 1) << executor.threads() << " threads";
    }
  }
}

/// All that looks large from somewhere is listed, and scored in parts.
TEST(Culler, AWalkWithALongListDoesNotDependOnTheExecutor) {
  const Culler culler(random_town_of_houses(11, 12000),
                      {.hierarchy = {.leaf_size = 4}, .lists = {.threshold = 1e-9, .regions = 1}});
  ASSERT_GT(occluders_of(culler).lists().longest(), 8192U);
  const Walk expected = walk_on(culler, Executor(), {.method = Method::frusta});
  EXPECT_EQ(expected.divided, 0U);
  for (const Executor& executor : some_executors()) {
    const Walk walk = walk_on(culler, executor, {.method = Method::frusta});
    EXPECT_EQ(walk.found, expected.found) << executor.threads() << " threads";
    EXPECT_EQ(walk.divided >= 60 * 8, executor.threads() > 1) << executor.threads() << " threads";
  }
}

TEST(Culler, AFrameWhoseListIsNotScoredDrawsEverything) {
  const Culler culler(random_town_of_houses(11, 12000), {.lists = {.threshold = 1e-9, .regions = 1}});
  std::size_t calls = 0;
  const Executor full(2, [&](std::size_t, const Executor::Part&) {
    ++calls;
    throw std::runtime_error("the queue is full");
  });
  View view;
  Camera camera;
  camera.eye = {-45, 0, 2};
  camera.target = {0, 0, 2};
  EXPECT_THROW(culler.cull(camera, {.method = Method::frusta, .executor = &full}, view), std::runtime_error);
  EXPECT_EQ(calls, 1U);
  EXPECT_TRUE(view.result().occluders.empty()) << "it was the list that threw";
  EXPECT_EQ(view.result().drawn, (std::vector<PolygonRange>{culler.hierarchy().soup().all()}));
  EXPECT_EQ(culler.cull(camera, {.method = Method::frusta}, view).drawn,
            culler.cull(camera, {.method = Method::frusta}).drawn)
      << "nothing is left of the frame before";
}

/// Where little is in view, most of it may be in one of the subtrees that are put off by size.
TEST(Culler, ASubtreeWithMuchOfTheWorkIsDividedInTheNextFrame) {
  const Culler culler(random_town_of_houses(11, 4000), {.hierarchy = {.leaf_size = 4}, .lists = {.regions = 64}});
  const Executor executor = Executor::own_threads(2);
  CullOptions options{.method = Method::frusta};
  options.executor = &executor;
  View view, alone;
  Camera camera;
  camera.eye = {40, 5, 2};
  camera.target = {41, 5, 2};
  camera.far_plane = 8;
  for (int frame = 0; frame < 3; ++frame) {
    const CullResult& found = culler.cull(camera, options, view);
    EXPECT_EQ(found.drawn, culler.cull(camera, {.method = Method::frusta}, alone).drawn);
    const DeferredSubtrees& deferred = memory_of(view).frusta.parts.deferred;
    std::size_t most = 0;
    for (const DeferredSubtree& subtree : std::span(deferred.subtrees).first(deferred.size)) {
      most = std::max(most, subtree.found.stats.nodes_visited);
    }
    EXPECT_EQ(most <= found.stats.nodes_visited / (kSharesOfThread * executor.threads()), frame > 0) << most;
  }
}

/// Its parts of the choice, its probes and its subtrees are left to the calling thread.
TEST(Culler, AThreadThatRoundsOtherwiseDecidesNothing) {
  const Culler culler(random_town_of_houses(11, 4000), {.hierarchy = {.leaf_size = 4}, .lists = {.regions = 64}});
  View view;
  std::size_t calls = 0, done = 0;
  const Executor upwards(2, [&](std::size_t count, const Executor::Part& part) {
    rounding_upwards(2).run(count, part);
    for (const WorkRunner::WorkItem& turn : memory_of(view).frusta.runner.items()) done += turn.is_done ? 1 : 0;
    ++calls;
  });
  CullOptions options{.method = Method::frusta};
  options.executor = &upwards;
  Camera camera;
  camera.eye = {-30, 3, 2};
  camera.target = {40, -10, 2};
  const CullResult& found = culler.cull(camera, options, view);
  EXPECT_EQ(calls, 3U) << "the choice, the probes, the subtrees";
  EXPECT_EQ(done, 0U);
  EXPECT_EQ(found.drawn, culler.cull(camera, {.method = Method::frusta}).drawn);
}

/// In the choice, while the shadows of probes are made, and in the traversal.
TEST(Culler, AFrameWhoseExecutorThrowsDrawsEverything) {
  const Culler culler(random_town_of_houses(11, 4000), {.hierarchy = {.leaf_size = 4}, .lists = {.regions = 64}});
  Camera camera;
  camera.eye = {-30, 3, 2};
  camera.target = {40, -10, 2};
  const auto all = static_cast<std::uint32_t>(culler.hierarchy().soup().size());
  for (std::size_t throwing = 1; throwing <= 3; ++throwing) {
    std::size_t calls = 0;
    const Executor full(2, [&](std::size_t count, const Executor::Part& part) {
      if (++calls != throwing) return Executor().run(count, part);
      throw std::runtime_error("the queue is full");
    });
    View view;
    EXPECT_THROW(culler.cull(camera, {.method = Method::frusta, .executor = &full}, view), std::runtime_error);
    EXPECT_EQ(view.result().drawn, (std::vector<PolygonRange>{{0, all}}));
    EXPECT_TRUE(view.result().culled.empty());
    EXPECT_EQ(view.result().stats.drawn_polygons, all);
    EXPECT_EQ(culler.cull(camera, {.method = Method::frusta}, view).drawn,
              culler.cull(camera, {.method = Method::frusta}).drawn)
        << "nothing is left of the frame before";
  }
}

TEST(Culler, VisitsEveryShadowTest) {
  const Culler culler(random_town(8, 2000));
  Camera camera;
  camera.eye = {-45, 0, 2};
  camera.target = {0, 0, 2};
  const CullResult frame = culler.cull(camera, {.method = Method::frusta});
  const Executor executor(2, [](std::size_t, const Executor::Part&) { FAIL() << "the order is that of the traversal"; });
  CullOptions options{.method = Method::frusta};
  options.executor = &executor;
  kernel::Operations operations;
  visit_shadow_tests(culler, frame, camera, options, [&](const Occluder& occluder, const Box& box) {
    operations += kernel::count_operations(occluder.frustum, std::get<kernel::Aabb>(box), options.arithmetic, options.test);
  });
  EXPECT_EQ(operations.tests, frame.stats.shadow_tests);
  EXPECT_GE(operations.dot, 2 * operations.tests);
  EXPECT_EQ(operations.cross, 0U);
}

/// The far side of a shell lies in the shadow of its near side, but is drawn, because it is a part of the occluder.
TEST(Culler, AShellDoesNotHideItself) {
  PolygonSoup soup;
  soup.add_box({2, -1, -1}, {4, 1, 1});
  add_wall(soup, 5, -1, 1, -1, 1);
  for (const auto near : {kernel::Near::surface, kernel::Near::farthest}) {
    const Culler culler = one_polygon_leaves(soup);
    const CullResult frame = look(culler, {.method = Method::frusta, .occluders = 1, .shadow_near = near});
    ASSERT_TRUE(occluders_of(culler).is_shell(frame.occluders.at(0).index));
    for (std::uint32_t face = 0; face < 6; ++face) EXPECT_TRUE(is_drawn(culler, frame, face));
    EXPECT_FALSE(is_drawn(culler, frame, 6));
  }
}

/// The same for a shell that is tested together with another occluder: a wall across half of its front, which begins at an
/// edge of the shell. The wall looks smaller than the shell once and larger once, so that each is the second of the pair
/// once. The far side lies in the union and straddles the shadow of the wall. The wall has one more vertex on the edge,
/// because an edge that three polygons share belongs to no shell.
TEST(Culler, AShellInAPairDoesNotHideItself) {
  for (const auto& [y, height] : {std::pair{1.0, 1.0}, {0.1, 20.0}}) {
    PolygonSoup soup;
    soup.add_box({2, -y, -1}, {4, y, 1});
    add(soup, {{2, y, -1}, {1.95, 0, -height}, {1.95, 0, height}, {2, y, 1}, {2, y, 0}});
    const Culler culler = one_polygon_leaves(soup);
    const CullResult frame = look(culler, {.method = Method::frusta, .occluders = 2, .unions = true});
    ASSERT_EQ(frame.pairs.size(), 1U);
    EXPECT_EQ(occluders_of(culler).is_shell(frame.occluders.at(frame.pairs[0].second).index), y < 1);
    EXPECT_GT(frame.stats.union_tests, 0U);
    EXPECT_TRUE(is_drawn(culler, frame, 1)) << "the far side";
  }
}

/// Two walls that meet at an angle, and a hundred small walls that only both together hide.
PolygonSoup corner() {
  PolygonSoup soup;
  add(soup, {{4, -4, -4}, {2, 0, -4}, {2, 0, 4}, {4, -4, 4}});
  add(soup, {{2, 0, -4}, {4, 4, -4}, {4, 4, 4}, {2, 0, 4}});
  for (int i = 0; i < 100; ++i) add_wall(soup, 8 + i, -1, 1, -1, 1);
  return soup;
}

TEST(Culler, TwoHideTogetherWhereAsked) {
  const Culler culler(corner(), {.hierarchy = {.leaf_size = 1}, .lists = {.threshold = 1e-6, .regions = 1}});
  Camera camera;
  camera.target = {1, 0, 0};
  camera.fov_y_deg = 120;
  CullOptions options{.method = Method::frusta, .occluders = 2};
  const CullResult alone = culler.cull(camera, options);
  EXPECT_EQ(alone.stats.shadow_culled_polygons + alone.stats.union_tests + alone.pairs.size(), 0U);
  options.unions = true;
  View view;
  for (int i = 0; i < 20; ++i) {
    const CullResult& frame = culler.cull(camera, options, view);
    ASSERT_EQ(frame.stats.shadow_culled_polygons, 100U) << "frame " << i;
    ASSERT_EQ(frame.pairs.size(), 1U);
    for (const Occluder& occluder : frame.occluders) ASSERT_EQ(occluder.hidden, 100U) << "both are remembered";
    std::size_t visited = 0;
    visit_shadow_tests(culler, frame, camera, options, [&](const Occluder&, const Box&) { ++visited; });
    ASSERT_EQ(visited, frame.stats.shadow_tests);
  }
  options.unions = false;
  EXPECT_TRUE(culler.cull(camera, options, view).pairs.empty()) << "the pairs are those of the frame";
}

/// Of several eyes, and of a matrix whose eye is rounded, two hide no more together, and are not asked.
TEST(Culler, NoPairsWhereTheEyeIsNotExact) {
  const Culler culler(corner(), {.hierarchy = {.leaf_size = 1}, .lists = {.threshold = 1e-6, .regions = 1}});
  const CullOptions options{.method = Method::frusta, .occluders = 2, .unions = true};
  Camera camera;
  camera.eye = {0.1, 0.2, 0.3};
  camera.target = {1, 0, 0};
  camera.fov_y_deg = 120;
  ASSERT_EQ(culler.cull(camera, options).pairs.size(), 1U);
  EXPECT_TRUE(culler.cull(MatrixCamera::from_camera(camera, ClipDepth::zero_to_w, Nearer::less), options).pairs.empty());
  camera.eyes = EyeRegion::ball(0.001);
  EXPECT_TRUE(culler.cull(camera, options).pairs.empty());
}

/// Triangles that share one edge, like the pages of a book: each makes a pair with every other.
PolygonSoup book(std::size_t pages) {
  PolygonSoup soup;
  for (std::size_t i = 0; i < pages; ++i) {
    const double turn = 0.1 + 6.28 * static_cast<double>(i) / static_cast<double>(pages);
    add(soup, {{6, 0, -1}, {6, 0, 1}, {6 + 3 * std::cos(turn), 3 * std::sin(turn), 0}});
  }
  return soup;
}

TEST(Culler, PairsOfAnEdgeOfManyAreBounded) {
  const Culler culler = one_polygon_leaves(book(500));
  std::size_t occluders = 0;
  for (const std::size_t most : {8U, 64U}) {
    const CullResult frame = look(culler, {.method = Method::frusta, .occluders = most, .unions = true});
    occluders = frame.occluders.size();
    ASSERT_EQ(occluders, most);
    EXPECT_EQ(frame.pairs.size(), std::min(most * (most - 1) / 2, ShadowPair::kMostOfEach * most));
    for (std::size_t i = 1; i < frame.pairs.size(); ++i) {
      EXPECT_LE(frame.pairs[i - 1].second, frame.pairs[i].second) << "the best together first";
    }
  }
}

/// However many nodes straddle the shadows.
TEST(Culler, TheWorkOfPairsIsBounded) {
  constexpr std::size_t kPlanesOfATriangle = 4;
  constexpr std::size_t kMost = kPairWorkOfEach * 8 / (kPlanesOfATriangle * kPlanesOfATriangle);
  for (const Bounds bounds : {Bounds::aabb, Bounds::obb}) {
    const Culler culler(book(4000), {.hierarchy = {.leaf_size = 1, .bounds = bounds}, .lists = {.regions = 1}});
    EXPECT_EQ(look(culler, {.method = Method::frusta, .unions = true}).stats.union_tests, kMost);
  }
}

/// A wall of two triangles beside the line of sight, the first with a corner at x = `nearest`, and a thing behind the
/// second.
PolygonSoup wall_of_two(double nearest) {
  PolygonSoup soup;
  add(soup, {{nearest, 2, -1}, {6, 2, -4}, {6, 2, 4}});
  add(soup, {{6, 2, -4}, {8, 2, 0}, {6, 2, 4}});
  add(soup, {{13, 4, -0.1}, {13.5, 4, -0.1}, {13.5, 4, 0.1}});
  return soup;
}

TEST(Culler, PartsHideWhereTheirWholeCannot) {
  Camera camera;
  camera.target = {1, 0, 0};
  camera.fov_y_deg = 120;
  camera.near_plane = 1;
  for (const double nearest : {5.0, 0.5}) {
    const Culler culler(wall_of_two(nearest), {.hierarchy = {.leaf_size = 1}, .lists = {.threshold = 1e-6, .regions = 1}});
    ASSERT_EQ(occluders_of(culler).size(), 4U);
    const CullResult frame = culler.cull(camera, {.method = Method::frusta});
    EXPECT_FALSE(is_drawn(culler, frame, 2)) << "nearest " << nearest;
    ASSERT_EQ(frame.occluders.size(), 1U) << "and nothing that adds nothing";
    EXPECT_EQ(occluders_of(culler).parts(frame.occluders[0].index).size(), nearest < camera.near_plane ? 1U : 2U);
  }
}

/// A pavement that looks large and hides nothing, and a wall that looks small and hides a hundred polygons.
TEST(Culler, HistoryFindsWhatHides) {
  PolygonSoup soup;
  for (int i = 0; i < 4; ++i) add(soup, {{i, -9, -1}, {i + 1, -9, -1}, {i + 1, 9, -1}, {i, 9, -1}});
  add_wall(soup, 8, -1, 1, -0.5, 1);
  for (int i = 0; i < 100; ++i) add_wall(soup, 10 + i, -0.5, 0.5, -0.2, 0.5);
  const Culler culler(soup, {.hierarchy = {.leaf_size = 1}, .lists = {.threshold = 1e-6, .regions = 1}});
  Camera camera;
  camera.target = {1, 0, 0};
  camera.fov_y_deg = 120;
  const CullOptions options{.method = Method::frusta, .occluders = 3};
  EXPECT_EQ(culler.cull(camera, options).stats.shadow_culled_polygons, 0U) << "the pavement looks larger";
  View view;
  std::size_t culled = 0;
  for (int frame = 0; frame < 3; ++frame) culled = culler.cull(camera, options, view).stats.shadow_culled_polygons;
  EXPECT_EQ(culled, 100U);
  // And it stays found.
  for (int frame = 0; frame < 50; ++frame) {
    const CullResult& result = culler.cull(camera, options, view);
    ASSERT_EQ(result.stats.shadow_culled_polygons, 100U) << "frame " << frame;
    ASSERT_EQ(original(culler, result.occluders[0]), 4U);
    ASSERT_EQ(result.occluders[0].hidden, 100U);
  }
}

/// Probing a wall, its two triangles and its house would test the same thing.
TEST(Culler, NoProbeIsPartOfAnOccluderInUseOrOfAnotherProbe) {
  const Culler culler(random_town_of_houses(14, 2000));
  std::mt19937 random(2);
  View view;
  std::size_t probes = 0;
  for (int i = 0; i < 50; ++i) {
    culler.cull(random_camera(random), {.method = Method::frusta}, view);
    std::vector<std::uint32_t> used;
    for (const Occluder& o : view.result().occluders) used.push_back(o.index);
    for (const Occluder& o : memory_of(view).frusta.probes) used.push_back(o.index);
    for (const Occluder& probe : memory_of(view).frusta.probes) {
      ++probes;
      for (std::uint32_t p = probe.index; occluders_of(culler).container(p) != p;) {
        p = occluders_of(culler).container(p);
        EXPECT_EQ(std::ranges::count(used, p), 0) << "occluder " << probe.index << " is part of " << p;
      }
    }
    EXPECT_LE(memory_of(view).frusta.probes.size(), CullOptions{.method = Method::frusta}.probes);
  }
  EXPECT_GT(probes, 200U);
}

TEST(OccluderHistory, RemembersForAWhile) {
  OccluderHistory history;
  EXPECT_EQ(history.hidden(7), std::nullopt);
  const std::vector<Occluder> used{{.index = 7, .frustum = {}, .hidden = 42}};
  history.record(10, used, {});
  EXPECT_EQ(history.hidden(7), 42U);
  EXPECT_EQ(history.hidden(6), std::nullopt);
  for (int frame = 0; frame < 16; ++frame) {
    EXPECT_EQ(history.hidden(7), 42U);
    history.record(frame % 2 == 0 ? 0 : 10, {}, {});  // frames without occluders among them
  }
  EXPECT_EQ(history.hidden(7), std::nullopt);
}

}  // namespace culler_test
