// SPDX-License-Identifier: MIT
// Scenes of moving objects against brute force over their boxes, and at the limits of what is promised.
#include "occlude/culler/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "frames.h"
#include "object_tree.h"
#include "occlude/culler/culler.h"
#include "occlude/kernel/half_space.h"
#include "occlude/kernel/overlap.h"
#include "outer_box.h"
#include "scenes.h"

namespace {

using namespace occlude;
using namespace occlude::culler;
using kernel::Aabb;
using kernel::Obb;
using kernel::Vec3;

using Ids = std::vector<std::uint32_t>;

constexpr std::uint32_t kSeed = 20260;

Vec3 random_vector(std::mt19937& random, double low, double high) {
  const double x = uniform(random, low, high), y = uniform(random, low, high);
  return {x, y, uniform(random, low, high)};
}

/// A box somewhere in the town of random_town(), oriented in half of all cases.
Box random_box(std::mt19937& random) {
  const Vec3 at{uniform(random, -50, 50), uniform(random, -50, 50), uniform(random, 0, 5)};
  const double size = random() % 8 == 0 ? 4 : 0.5;
  if (random() % 2 == 0)
    return Obb{at,
               {random_vector(random, -size, size), random_vector(random, -size, size), random_vector(random, -size, size)}};
  const Vec3 half = random_vector(random, 0, size);
  return Aabb{{at.x - half.x, at.y - half.y, at.z - half.z}, {at.x + half.x, at.y + half.y, at.z + half.z}};
}

std::vector<Box> random_boxes(std::mt19937& random, std::size_t count) {
  std::vector<Box> boxes;
  while (boxes.size() < count) boxes.push_back(random_box(random));
  return boxes;
}

/// What a frame must draw: every box is tested against every half-space and every shadow.
Ids brute_force(const CullResult& frame, std::span<const Box> boxes, const CullOptions& options) {
  Ids drawn;
  for (std::uint32_t id = 0; id < boxes.size(); ++id) {
    const bool is_drawn = std::visit(
        [&](const auto& box) {
          return std::ranges::none_of(frame.view,
                                      [&](const HalfSpace& h) {
                                        return kernel::relation({{h.normal.x, h.normal.y, h.normal.z}, h.offset}, box,
                                                                options.arithmetic) == kernel::Relation::outside;
                                      }) &&
                 std::ranges::none_of(frame.occluders, [&](const Occluder& o) {
                   return kernel::decide(o.frustum, box, options.arithmetic, options.test, kernel::NearBoundary::open)
                              .relation == kernel::Relation::inside;
                 });
        },
        boxes[id]);
    if (is_drawn) drawn.push_back(id);
  }
  return drawn;
}

Ids sorted(Ids ids) {
  std::ranges::sort(ids);
  return ids;
}

Ids in_ranges(const Scene& scene, std::span<const PolygonRange> ranges) {
  Ids ids;
  for (const auto& [first, count] : ranges) {
    for (std::uint32_t i = first; i < first + count; ++i) ids.push_back(scene.static_order()[i]);
  }
  return ids;
}

void expect_as_brute_force(const Scene& scene, const SceneView& view, std::span<const Box> statics,
                           std::span<const Box> dynamics, const CullOptions& options) {
  ASSERT_EQ(sorted(view.result().statics), brute_force(view.frame(), statics, options)) << "seed " << kSeed;
  ASSERT_EQ(sorted(view.result().dynamics), brute_force(view.frame(), dynamics, options)) << "seed " << kSeed;
  ASSERT_EQ(in_ranges(scene, view.result().static_ranges), view.result().statics);
  const CullStats& stats = view.frame().stats;
  ASSERT_EQ(stats.drawn_polygons, view.result().statics.size() + view.result().dynamics.size());
  ASSERT_EQ(stats.drawn_polygons + stats.view_culled_polygons + stats.shadow_culled_polygons,
            statics.size() + dynamics.size());
}

TEST(Scene, DrawsWhatBruteForceDraws) {
  std::mt19937 random(kSeed);
  const auto statics = random_boxes(random, 1500);
  auto dynamics = random_boxes(random, 500);
  Scene scene({.statics = statics, .dynamics = dynamics}, random_town(1, 1000));
  std::size_t hidden = 0;
  for (int i = 0; i < 200; ++i) {
    CullOptions options;
    options.near = i % 2 ? kernel::Near::surface : kernel::Near::farthest;
    options.test = i % 3 ? kernel::Test::conservative : kernel::Test::overlap;
    // A view of several frames, so that history and probes take part.
    SceneView view;
    Camera camera = random_camera(random);
    for (int frame = 0; frame < 3; ++frame) {
      for (std::uint32_t id = 0; id < dynamics.size(); ++id) {
        if (random() % 4 != 0) continue;
        dynamics[id] = random_box(random);
        scene.set_bounds(id, dynamics[id]);
      }
      scene.update();
      camera.eye.x += 0.5;
      camera.target.x += 0.5;
      ASSERT_EQ(&scene.cull(camera, options, view), &view.result());
      expect_as_brute_force(scene, view, statics, dynamics, options);
      hidden += view.frame().stats.shadow_culled_polygons;
    }
  }
  EXPECT_GT(hidden, 10000U);
}

/// The nodes of the static objects alone are regions; what moves has none.
TEST(Scene, RegionsMayBeNodesOfItsTree) {
  std::mt19937 random(kSeed);
  const std::vector<Box> statics = random_boxes(random, 400), dynamics = random_boxes(random, 100);
  const SceneConfig config{.lists = {.kind = Partition::Kind::tree, .regions = 64}};
  const Scene of_both({.statics = statics, .dynamics = dynamics}, random_town(1, 1000), config);
  const Scene of_statics({.statics = statics}, random_town(1, 1000), config);
  const Scene of_dynamics({.dynamics = dynamics}, random_town(1, 1000), config);
  EXPECT_EQ(of_both.occluders().lists().partition().regions(), 64U);
  EXPECT_EQ(of_dynamics.occluders().lists().partition().regions(), 1U);
  EXPECT_EQ(of_both.occluders().lists().stored().first, of_statics.occluders().lists().stored().first);
  SceneView view;
  of_both.cull(random_camera(random), {}, view);
  expect_as_brute_force(of_both, view, statics, dynamics, {});
}

TEST(Scene, VisibilityAgreesWithWhatIsDrawn) {
  std::mt19937 random(kSeed);
  const auto statics = random_boxes(random, 1000), dynamics = random_boxes(random, 300);
  const Scene scene({.statics = statics, .dynamics = dynamics}, random_town(2, 1000));
  std::array<std::size_t, 3> counts{};
  for (int i = 0; i < 50; ++i) {
    SceneView view;
    scene.cull(random_camera(random), {}, view);
    const auto expect = [&](std::span<const Box> boxes, const Ids& drawn) {
      for (std::uint32_t id = 0; id < boxes.size(); ++id) {
        const Visibility visibility = view.visibility(boxes[id]);
        ++counts[static_cast<std::size_t>(visibility)];
        ASSERT_EQ(visibility == Visibility::visible, std::ranges::find(drawn, id) != drawn.end()) << "seed " << kSeed;
      }
    };
    expect(statics, view.result().statics);
    expect(dynamics, view.result().dynamics);
  }
  EXPECT_GT(*std::ranges::min_element(counts), 1000U) << "all answers must occur";
}

TEST(Scene, PairsHideInQueriesAsInFrames) {
  // Two halves of a wall share an edge, but are too bent to be joined. What only both hide is tested against both.
  PolygonSoup walls;
  add(walls, {{4, -2, -2}, {3, 0, -2}, {3, 0, 2}, {4, -2, 2}});
  add(walls, {{3, 0, -2}, {4, 2, -2}, {4, 2, 2}, {3, 0, 2}});
  const std::vector<Box> statics{Aabb{{6, -0.5, -0.5}, {7, 0.5, 0.5}}};
  const Scene scene({.statics = statics}, walls);
  for (const bool unions : {false, true}) {
    SceneView view;
    EXPECT_EQ(scene.cull(Camera{}, {.unions = unions}, view).statics.empty(), unions);
    EXPECT_EQ(view.visibility(statics[0]), unions ? Visibility::occluded : Visibility::visible);
  }
}

TEST(Scene, QueriesAreOfTheViewsOwnFrame) {
  PolygonSoup walls;
  add_wall(walls, 2, -1, 1, -1, 1);
  const Culler culler(walls);
  const Box behind = Aabb{{4, -0.5, -0.5}, {5, 0.5, 0.5}}, touching = Aabb{{2, -0.5, -0.5}, {5, 0.5, 0.5}};
  const Box turned = Obb{{6, 0, 0}, {{{1, 1, 0}, {-1, 1, 0}, {0, 0, 1}}}};
  View view;
  EXPECT_EQ(view.visibility(behind), Visibility::visible) << "before the first frame";
  culler.cull(Camera{}, {}, view);
  EXPECT_EQ(view.visibility(behind), Visibility::occluded);
  EXPECT_EQ(view.visibility(turned), Visibility::occluded);
  EXPECT_EQ(view.visibility(touching), Visibility::visible);
  EXPECT_EQ(view.visibility(Aabb{{-5, -1, -1}, {-4, 1, 1}}), Visibility::out_of_view);
  culler.cull(Camera{}, {.occluders = 0}, view);
  EXPECT_EQ(view.visibility(behind), Visibility::visible);
}

TEST(Scene, ObjectsMoveInAndOutOfTheShadow) {
  PolygonSoup walls;
  add_wall(walls, 2, -1, 1, -1, 1);
  const auto box_at = [](double y) { return Aabb{{4, y - 0.5, -0.5}, {5, y + 0.5, 0.5}}; };
  const std::vector<Box> statics{box_at(0)}, dynamics{box_at(0), box_at(0)};
  Scene scene({.statics = statics, .dynamics = dynamics}, walls);
  SceneView view;
  EXPECT_EQ(scene.cull(Camera{}, {}, view).dynamics, Ids{}) << "nothing in view";
  scene.set_bounds(1, box_at(3));
  scene.update();
  EXPECT_EQ(scene.cull(Camera{}, {}, view).dynamics, Ids{1});
  scene.set_bounds(0, box_at(1.5));  // its border on that of the shadow, at x = 4: y = 2
  scene.set_bounds(1, box_at(0));
  EXPECT_EQ(scene.cull(Camera{}, {}, view).dynamics, Ids{1}) << "not before update()";
  scene.update();
  EXPECT_EQ(scene.cull(Camera{}, {}, view).dynamics, Ids{});
  scene.set_bounds(0, box_at(1.5 + 0x1p-51));  // the border beyond it, by an ulp
  scene.update();
  EXPECT_EQ(scene.cull(Camera{}, {}, view).dynamics, Ids{0});
  EXPECT_EQ(view.result().statics, Ids{});
}

TEST(Scene, ARefittedTreeCullsAsAFreshOne) {
  std::mt19937 random(kSeed);
  const auto statics = random_boxes(random, 300);
  auto dynamics = random_boxes(random, 300);
  const PolygonSoup town = random_town(3, 500);
  Scene moved({.statics = statics, .dynamics = dynamics}, town);
  for (int i = 0; i < 20; ++i) {
    // From a few moves to a move of nearly all.
    for (std::uint32_t id = 0; id < dynamics.size(); ++id) {
      if (random() % 20 >= static_cast<std::uint32_t>(i)) continue;
      dynamics[id] = random_box(random);
      moved.set_bounds(id, dynamics[id]);
    }
    moved.update();
    const Scene fresh({.statics = statics, .dynamics = dynamics}, town);
    for (int k = 0; k < 5; ++k) {
      const Camera camera = random_camera(random);
      SceneView a, b;
      EXPECT_EQ(sorted(moved.cull(camera, {}, a).dynamics), sorted(fresh.cull(camera, {}, b).dynamics)) << "seed " << kSeed;
      EXPECT_EQ(a.result().statics, b.result().statics) << "what stays is in the same tree";
    }
  }
}

/// What a descent of the tree costs, half the surfaces of its inner nodes.
double cost(const ObjectTree& tree) {
  double sum = 0;
  for (const HierarchyNode& node : tree.nodes()) {
    const double x = node.box.max.x - node.box.min.x, y = node.box.max.y - node.box.min.y;
    const double z = node.box.max.z - node.box.min.z;
    if (!node.is_leaf()) sum += x * y + y * z + z * x;
  }
  return sum;
}

Aabb scaled(const Aabb& box, double factor) {
  Aabb result = box;
  for (int axis = 0; axis < 3; ++axis) {
    result.min[axis] *= factor;
    result.max[axis] *= factor;
  }
  return result;
}

TEST(ObjectTree, IsBuiltAnewWhenItHasBecomeLoose) {
  std::mt19937 random(kSeed);
  // All objects begin at one place. Then they scatter, each time over a smaller space.
  const std::vector<Box> together(200, Aabb{{0, 0, 0}, {0x1p-20, 0x1p-20, 0x1p-20}});
  ObjectTree tree({}, together);
  for (int i = 0; i < 5; ++i) {
    auto scattered = random_boxes(random, together.size());
    for (Box& box : scattered) box = scaled(outer_box(box), std::pow(0.1, i));
    for (std::size_t id = 0; id < scattered.size(); ++id) tree.set_bounds(id, scattered[id]);
    tree.update();
    EXPECT_LE(cost(tree), 2 * cost(ObjectTree({}, scattered)));
    for (std::size_t id = 0; id < together.size(); ++id) tree.set_bounds(id, together[id]);
    tree.update();
  }
}

TEST(ObjectTree, KeepsItsShapeWhileItIsTight) {
  std::mt19937 random(kSeed);
  auto boxes = random_boxes(random, 200);
  ObjectTree tree({}, boxes);
  const Ids order(tree.order().begin(), tree.order().end());
  for (int i = 0; i < 10; ++i) {
    for (std::size_t id = 0; id < boxes.size(); ++id) {
      if (auto* box = std::get_if<Aabb>(&boxes[id])) box->max.x += 0.01;
      tree.set_bounds(id, boxes[id]);
    }
    tree.update();
    EXPECT_EQ(Ids(tree.order().begin(), tree.order().end()), order);
  }
}

/// Whether the axis-aligned box holds the oriented one, exactly: whether that is inside six half-spaces.
bool holds(const Aabb& outer, const Obb& box) {
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 up{}, down{};
    up[axis] = 1;
    down[axis] = -1;
    for (const kernel::HalfSpace& h : {kernel::HalfSpace{up, -outer.min[axis]}, {down, outer.max[axis]}}) {
      if (kernel::relation(h, box, kernel::Arithmetic::certified) != kernel::Relation::inside) return false;
    }
  }
  return true;
}

TEST(OuterBox, HoldsTheBoxExactlyAndIsLegal) {
  std::mt19937 random(kSeed);
  const auto number = [&] {
    const double magnitude = std::ldexp(uniform(random, 1, 2), static_cast<int>(random() % 190) - 95);
    return random() % 5 == 0 ? 0 : random() % 2 == 0 ? magnitude : -magnitude;
  };
  for (int i = 0; i < 20000; ++i) {
    Obb box{{number(), number(), number()}, {}};
    for (Vec3& edge : box.half_edges) edge = {number(), number(), number()};
    // Some numbers have similar magnitudes, so that they cancel.
    if (i % 2 == 0) box = {random_vector(random, -1, 1), {random_vector(random, -1, 1), random_vector(random, -1, 1), {}}};
    if (i % 4 == 0) box.center = {box.half_edges[0].x + box.half_edges[1].x, 0, box.half_edges[0].z};
    const Aabb outer = outer_box(box);
    ASSERT_EQ(kernel::check(outer), kernel::Refusal::none) << "seed " << kSeed;
    ASSERT_TRUE(holds(outer, box)) << "seed " << kSeed;
  }
}

TEST(OuterBox, IsTightAndRefusedWhereItIsNotLegal) {
  const Aabb outer = outer_box(Obb{{1, 2, 3}, {{{1, 1, 0}, {-1, 1, 0}, {0, 0, 1}}}});
  for (int axis = 0; axis < 3; ++axis) {
    const double half = axis == 2 ? 1 : 2, middle = axis + 1;
    EXPECT_NEAR(outer.min[axis], middle - half, 1e-14);
    EXPECT_NEAR(outer.max[axis], middle + half, 1e-14);
  }
  const double large = 0x1p100;
  EXPECT_EQ(refusal_of(Aabb{{0, 0, 0}, {large, large, large}}), kernel::Refusal::none);
  EXPECT_EQ(refusal_of(Obb{{large, 0, 0}, {}}), kernel::Refusal::out_of_range);
  EXPECT_EQ(refusal_of(Obb{{large / 2, 0, 0}, {}}), kernel::Refusal::none);
}

TEST(Scene, SeveralCamerasAtOnceAreCulledAsOneAfterAnother) {
  std::mt19937 random(kSeed);
  const auto statics = random_boxes(random, 800), dynamics = random_boxes(random, 200);
  const Scene scene({.statics = statics, .dynamics = dynamics}, random_town(4, 800));
  std::vector<std::vector<Camera>> paths(4);
  for (auto& path : paths) {
    for (int i = 0; i < 30; ++i) path.push_back(random_camera(random));
  }
  const Box anywhere = random_box(random);
  struct Frame {
    SceneResult result;
    Visibility visibility;
  };
  const auto walk = [&](const std::vector<Camera>& path, std::vector<Frame>& frames) {
    SceneView view;
    for (const Camera& camera : path) {
      const SceneResult& result = scene.cull(camera, {}, view);
      frames.push_back({result, view.visibility(anywhere)});
    }
  };
  std::vector<std::vector<Frame>> expected(paths.size()), actual(paths.size());
  for (std::size_t i = 0; i < paths.size(); ++i) walk(paths[i], expected[i]);
  {
    std::vector<std::jthread> threads;
    for (std::size_t i = 0; i < paths.size(); ++i) threads.emplace_back([&, i] { walk(paths[i], actual[i]); });
  }
  for (std::size_t i = 0; i < paths.size(); ++i) {
    for (std::size_t f = 0; f < paths[i].size(); ++f) {
      EXPECT_EQ(actual[i][f].result.statics, expected[i][f].result.statics);
      EXPECT_EQ(actual[i][f].result.dynamics, expected[i][f].result.dynamics);
      EXPECT_EQ(actual[i][f].visibility, expected[i][f].visibility);
    }
  }
}

TEST(Scene, ThreadsAskOneViewWhileOthersSetBounds) {
  std::mt19937 random(kSeed);
  const auto boxes = random_boxes(random, 500);
  Scene scene({.statics = boxes, .dynamics = boxes}, random_town(5, 500));
  SceneView view;
  scene.cull(random_camera(random), {}, view);
  const auto ask = [&] {
    std::vector<Visibility> answers;
    for (const Box& box : boxes) answers.push_back(view.visibility(box));
    return answers;
  };
  const auto expected = ask();
  std::array<std::vector<Visibility>, 2> answers;
  {
    std::vector<std::jthread> threads;
    for (auto& mine : answers) threads.emplace_back([&] { mine = ask(); });
    threads.emplace_back([&] {
      for (std::uint32_t id = 0; id < boxes.size(); ++id) scene.set_bounds(id, boxes[0]);
    });
  }
  for (const auto& mine : answers) EXPECT_EQ(mine, expected);
}

TEST(Scene, WorksWithoutStaticsDynamicsOrOccluders) {
  std::mt19937 random(kSeed);
  const auto boxes = random_boxes(random, 200);
  for (int parts = 0; parts < 8; ++parts) {
    const std::vector<Box> statics = parts & 1 ? boxes : std::vector<Box>{};
    std::vector<Box> dynamics = parts & 2 ? boxes : std::vector<Box>{};
    Scene scene({.statics = statics, .dynamics = dynamics}, parts & 4 ? random_town(6, 300) : PolygonSoup{});
    EXPECT_EQ(scene.statics(), statics.size());
    EXPECT_EQ(scene.dynamics(), dynamics.size());
    EXPECT_EQ(scene.static_order().size(), statics.size());
    SceneView view;
    for (int i = 0; i < 10; ++i) {
      for (std::uint32_t id = 0; id < dynamics.size(); ++id) scene.set_bounds(id, dynamics[id] = random_box(random));
      scene.update();
      scene.cull(random_camera(random), {}, view);
      expect_as_brute_force(scene, view, statics, dynamics, {});
    }
  }
}

TEST(Scene, WhatTouchesOrHoldsItsOccluderIsDrawn) {
  // A house whose walls are the occluder and whose box holds them, and pictures on the wall.
  PolygonSoup walls;
  add_wall(walls, 4, -1, 1, -1, 1);
  const std::vector<Box> statics{
      Aabb{{4, -1, -1}, {6, 1, 1}},                                          // the house
      Aabb{{4, -0.5, -0.5}, {4, 0.5, 0.5}},                                  // on the wall
      Aabb{{4, -0.5, -0.5}, {5, 0.5, 0.5}},                                  // touches it from behind
      Aabb{{std::nextafter(4.0, 5.0), -0.5, -0.5}, {5, 0.5, 0.5}},           // behind it by an ulp
      Obb{{5, 0, 0}, {{{0.5, 0.5, 0}, {0.5, -0.5, 0}, {0, 0, 0.5}}}},        // an edge of it touches from behind
      Obb{{5.0625, 0, 0}, {{{0.5, 0.5, 0}, {0.5, -0.5, 0}, {0, 0, 0.5}}}}};  // and not
  const Scene scene({.statics = statics}, walls);
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    Camera camera;
    camera.projection = projection;
    SceneView view;
    EXPECT_EQ(sorted(scene.cull(camera, {}, view).statics), (Ids{0, 1, 2, 4}));
  }
}

TEST(Scene, ASolidHidesWhatIsBehindIt) {
  PolygonSoup solid;
  std::vector<std::uint32_t> c;
  for (const double x : {4.0, 5.0}) {
    for (const double y : {-1.0, 1.0}) {
      for (const double z : {-1.0, 1.0}) c.push_back(solid.add_vertex({x, y, z}));
    }
  }
  using Face = std::array<std::size_t, 4>;
  for (const Face& f : {Face{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {2, 3, 7, 6}, {0, 2, 6, 4}, {1, 5, 7, 3}}) {
    solid.add_polygon(std::array{c[f[0]], c[f[1]], c[f[2]], c[f[3]]});
  }
  const std::vector<Box> statics{Aabb{{4, -1, -1}, {5, 1, 1}}, Aabb{{5, -1, -1}, {6, 1, 1}}};
  const Scene scene({.statics = statics}, solid);
  SceneView view;
  EXPECT_EQ(scene.cull(Camera{}, {}, view).statics, Ids{0});
  ASSERT_EQ(view.frame().occluders.size(), 1U);
  EXPECT_TRUE(scene.occluders().is_shell(view.frame().occluders[0].index));
}

TEST(Scene, RefusesWhatCannotBeRightAndChangesNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Box good = Aabb{{4, -0.5, -0.5}, {5, 0.5, 0.5}}, upside_down = Aabb{{0, 0, 1}, {1, 1, 0}};
  const Box bad = Obb{{0, nan, 0}, {}}, far = Obb{{0x1p100, 0, 0}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
  const std::vector<Box> boxes{good, good};
  const auto build = [&](const std::vector<Box>& statics, const std::vector<Box>& dynamics, const PolygonSoup& soup) {
    return refusal([&] { const Scene scene({.statics = statics, .dynamics = dynamics}, soup); });
  };
  PolygonSoup walls;
  add_wall(walls, 2, -1, 1, -1, 1);
  EXPECT_EQ(build(boxes, boxes, walls), "");
  EXPECT_EQ(build({good, upside_down}, {}, walls), "static object 1: box has min > max");
  EXPECT_EQ(build({}, {bad}, walls), "dynamic object 0: number is not finite");
  EXPECT_EQ(build({far}, {}, walls).substr(0, 36), "static object 0: number out of range");
  PolygonSoup broken = walls;
  broken.vertices[2].z = nan;
  EXPECT_EQ(build({}, {}, broken), "vertex 2: number is not finite");

  Scene scene({.statics = boxes, .dynamics = boxes}, walls);
  EXPECT_EQ(refusal([&] { scene.set_bounds(1, upside_down); }), "dynamic object 1: box has min > max");
  EXPECT_EQ(refusal([&] { scene.set_bounds(2, good); }), "there is no dynamic object 2");
  scene.update();
  SceneView view;
  scene.cull(Camera{}, {.occluders = 0}, view);
  EXPECT_EQ(sorted(view.result().dynamics), (Ids{0, 1})) << "where they were";
  EXPECT_EQ(view.result().static_ranges, (std::vector<PolygonRange>{{0, 2}})) << "and no dynamic ones";
  EXPECT_EQ(refusal([&] { static_cast<void>(view.visibility(bad)); }), "number is not finite");
  Camera blind;
  blind.target = blind.eye;
  EXPECT_NE(refusal([&] { scene.cull(blind, {}, view); }), "");
  EXPECT_EQ(sorted(view.result().statics), (Ids{0, 1})) << "the last frame";
  EXPECT_EQ(view.frame().stats.drawn_polygons, 4U);
}

TEST(Scene, CanBeMoved) {
  PolygonSoup walls;
  add_wall(walls, 2, -1, 1, -1, 1);
  const std::vector<Box> boxes{Aabb{{4, -0.5, -0.5}, {5, 0.5, 0.5}}};
  Scene scene({.dynamics = boxes}, walls);
  Scene other = std::move(scene);
  SceneView view;
  EXPECT_EQ(other.cull(Camera{}, {}, view).dynamics, Ids{});
  SceneView moved = std::move(view);
  EXPECT_EQ(moved.visibility(boxes[0]), Visibility::occluded);
}

}  // namespace
