// SPDX-License-Identifier: MIT
// Scenes against brute force, against the exact predicate and against scenes built anew, and at the limits of what is
// promised.
#include "occlude/culler/scene.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cfenv>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <memory>
#include <random>
#include <set>
#include <span>
#include <stdexcept>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "cover/placed.h"
#include "executors.h"
#include "frames.h"
#include "model/bounds.h"
#include "model/outer_box.h"
#include "occlude/kernel/cover.h"
#include "occlude/kernel/half_space.h"
#include "sanitized.h"
#include "scene/scene_frame.h"
#include "scene/scene_number.h"
#include "scene/scene_things.h"
#include "scenes.h"

namespace scene_test {

using namespace occlude;
using namespace occlude::culler;
using kernel::Aabb;
using kernel::Obb;
using kernel::Vec3;

constexpr std::uint32_t kSeed = 20260;
constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// A box somewhere in the town of random_town(), oriented in half of all cases.
Box random_box(std::mt19937& random) {
  const Vec3 at{uniform(random, -50, 50), uniform(random, -50, 50), uniform(random, 0, 5)};
  const double size = random() % 8 == 0 ? 4 : 0.5;
  if (random() % 2 == 0) {
    return Obb{at,
               {random_vector(random, -size, size), random_vector(random, -size, size), random_vector(random, -size, size)}};
  }
  const Vec3 half = random_vector(random, 0, size);
  return Aabb{{at.x - half.x, at.y - half.y, at.z - half.z}, {at.x + half.x, at.y + half.y, at.z + half.z}};
}

/// The box of 6 m by 4 m by 5 m around the origin.
const PolygonSoup& house() {
  static const PolygonSoup soup = [] {
    PolygonSoup house;
    add_box(house, {-3, -2, 0}, {3, 2, 5}, true);
    return house;
  }();
  return soup;
}

Placement random_placement(std::mt19937& random) {
  const double angle = uniform(random, 0, 6.28), c = std::cos(angle), s = std::sin(angle);
  const double size = uniform(random, 0.3, 2), mirror = random() % 4 == 0 ? -1 : 1;
  return {{size * c, size * s, 0},
          {-size * mirror * s, size * mirror * c, 0},
          {0, 0, size},
          {uniform(random, -50, 50), uniform(random, -50, 50), uniform(random, -1, 1)}};
}

/// What a scene should be.
struct World {
  struct Object {
    Box box;
    ObjectOptions options;
    bool is_enabled = true;

    [[nodiscard]] std::uint32_t mask() const { return is_enabled ? options.mask : 0; }
  };
  struct Standing {
    const PolygonSoup* soup;
    std::shared_ptr<const OccluderMesh> mesh;
    Placement placement;
    OccluderOptions options;
    bool is_enabled = true;
  };
  std::map<std::uint32_t, std::pair<ObjectId, Object>> objects;  ///< by slots
  std::map<std::uint32_t, std::pair<OccluderId, Standing>> occluders;
};

class Worlds : public testing::TestWithParam<std::uint32_t> {
 protected:
  [[nodiscard]] std::uint32_t below(std::size_t n) { return static_cast<std::uint32_t>(random_() % n); }
  [[nodiscard]] bool chance(std::uint32_t one_in) { return random_() % one_in == 0; }

  template <class T>
  T& any(std::map<std::uint32_t, T>& of) {
    auto at = of.lower_bound(below(of.rbegin()->first + 1));
    return at->second;
  }

  ObjectOptions random_options() {
    return {.moves = chance(3), .is_always_drawn = chance(40), .mask = chance(6) ? 1U << below(3) : ~0U};
  }

  void add_objects(std::size_t count) {
    std::vector<Box> boxes;
    while (boxes.size() < count) boxes.push_back(random_box(random_));
    if (chance(4)) boxes[0] = Aabb{{-kInfinity, 0, 0}, {0, 1, 1e300}};
    const ObjectOptions options = random_options();
    std::vector<ObjectId> ids(count);
    if (count == 1) {
      ids[0] = scene_.add(boxes[0], options);
    } else {
      scene_.add(boxes, options, ids);
    }
    for (std::size_t i = 0; i < count; ++i) {
      ASSERT_TRUE(world_.objects.emplace(ids[i].slot(), std::pair{ids[i], World::Object{boxes[i], options}}).second);
    }
  }

  void add_occluder() {
    World::Standing standing{&house(), house_, random_placement(random_), {}};
    standing.options.moves = chance(4);
    standing.options.mask = chance(6) ? 1U << below(3) : ~0U;
    standing.options.is_one_sided = chance(3);
    if (chance(4) && !world_.objects.empty()) standing.options.object = any(world_.objects).first;
    if (chance(3)) standing.options.weld = 1 + below(2);
    const OccluderId id = scene_.add(standing.mesh, standing.placement, standing.options);
    ASSERT_TRUE(world_.occluders.emplace(id.slot(), std::pair{id, standing}).second);
  }

  /// Occluders near each other, added at once: houses, walls, or walls of so many panels that they are no subtree of few.
  void add_occluder_tile(std::size_t count) {
    const double x = uniform(random_, -45, 45), y = uniform(random_, -45, 45);
    const std::array<const PolygonSoup*, 3> soups{&house(), &wall_soup_, &panel_soup_};
    const std::array meshes{house_, wall_, panels_};
    const std::size_t mesh = below(3);
    World::Standing standing{soups[mesh], meshes[mesh], {}, {.moves = chance(8), .mask = chance(6) ? 1U << below(3) : ~0U}};
    if (count < 100 && mesh != 2 && chance(2)) standing.options.weld = 1 + below(2);  // larger welds take long
    std::vector<Placement> placements(count);
    for (Placement& placement : placements) {
      placement = random_placement(random_);
      placement.origin.x = x + placement.origin.x / 5;
      placement.origin.y = y + placement.origin.y / 5;
    }
    std::vector<OccluderId> ids(count);
    scene_.add(standing.mesh, placements, standing.options, ids);
    for (std::size_t i = 0; i < count; ++i) {
      standing.placement = placements[i];
      ASSERT_TRUE(world_.occluders.emplace(ids[i].slot(), std::pair{ids[i], standing}).second);
    }
  }

  void remove_occluders(std::size_t count) {
    std::vector<OccluderId> gone;
    for (auto at = world_.occluders.lower_bound(below(world_.occluders.rbegin()->first)); at != world_.occluders.end();) {
      gone.push_back(at->second.first);
      at = world_.occluders.erase(at);
      if (gone.size() == count) break;
    }
    scene_.remove(gone);
  }

  void change_object() {
    if (world_.objects.empty()) return;
    auto& [id, object] = any(world_.objects);
    switch (below(8)) {
      case 0:
        scene_.remove(id);
        EXPECT_FALSE(scene_.contains(id));
        world_.objects.erase(id.slot());
        break;
      case 1:
        scene_.set_enabled(id, object.is_enabled = !object.is_enabled);
        break;
      case 2:
        scene_.set_mask(id, object.options.mask = chance(2) ? 1U << below(3) : ~0U);
        break;
      default:
        object.box = chance(30) ? Box{Aabb{{0, 0, 0}, {1, 1, kInfinity}}} : random_box(random_);
        scene_.move(id, object.box);
    }
  }

  void change_occluder() {
    if (world_.occluders.empty()) return;
    auto& [id, standing] = any(world_.occluders);
    switch (below(8)) {
      case 0:
        scene_.remove(id);
        EXPECT_FALSE(scene_.contains(id));
        world_.occluders.erase(id.slot());
        break;
      case 1:
        scene_.set_enabled(id, standing.is_enabled = !standing.is_enabled);
        break;
      case 2:
        scene_.set_mask(id, standing.options.mask = chance(2) ? 1U << below(3) : ~0U);
        break;
      case 3:
        standing.soup = chance(2) ? &wall_soup_ : &house();
        standing.mesh = standing.soup == &house() ? house_ : wall_;
        scene_.replace(id, standing.mesh);
        break;
      default:
        standing.placement = random_placement(random_);
        scene_.move(id, standing.placement);
    }
  }

  void edit(int steps) {
    for (int i = 0; i < steps; ++i) {
      const std::uint32_t what = below(20);
      if (what == 0) add_objects(1 + below(300));
      if (what == 1) add_objects(1);
      if (what == 2) add_occluder();
      if (what > 2 && what < 16) change_object();
      if (what >= 16) change_occluder();
    }
    if (chance(10)) {  // a tile goes
      const std::uint32_t first = below(world_.objects.size() + 1);
      for (std::uint32_t slot = first; slot < first + 200; ++slot) {
        const auto found = world_.objects.find(slot);
        if (found == world_.objects.end()) continue;
        scene_.remove(found->second.first);
        world_.objects.erase(found);
      }
    }
  }

  /// The polygons that may hide in a frame.
  [[nodiscard]] std::vector<kernel::Cover::Polygon> hiding(std::uint32_t mask, const Camera& camera) const {
    std::vector<kernel::Cover::Polygon> polygons;
    const kernel::Viewpoint from = camera.viewpoint();
    for (const auto& [slot, entry] : world_.occluders) {
      const World::Standing& standing = entry.second;
      if (!standing.is_enabled || (standing.options.mask & mask) == 0) continue;
      if (const ObjectId object = standing.options.object; !object.is_none()) {
        const auto found = world_.objects.find(object.slot());
        if (found == world_.objects.end() || found->second.first != object) continue;
        if ((found->second.second.mask() & mask) == 0) continue;
      }
      for (std::size_t p = 0; p < standing.soup->size(); ++p) {
        kernel::Cover::Polygon polygon;
        for (const std::uint32_t v : standing.soup->loop(p)) {
          polygon.push_back(placed(standing.placement, to_kernel(standing.soup->vertices[v])));
        }
        if (!standing.options.is_one_sided || is_front(polygon, from, is_mirrored(standing.placement))) {
          polygons.push_back(polygon);
        }
      }
    }
    return polygons;
  }

  static bool is_front(const kernel::Cover::Polygon& polygon, const kernel::Viewpoint& from, bool is_mirrored) {
    const glm::dvec3 a = to_glm(polygon[0]), normal = glm::cross(to_glm(polygon[1]) - a, to_glm(polygon[2]) - a);
    const glm::dvec3 sight = from.is_eye() ? a - to_glm(from.value) : to_glm(from.value);
    return (glm::dot(normal, sight) < 0) != is_mirrored;
  }

  /// Holds a frame against the world: each object is drawn or counted once, and what is not drawn is exactly out of view or
  /// hidden. Of the hidden ones, `proofs` are proved.
  void expect_right(const Camera& camera, const SceneOptions& options, const SceneView& view, std::size_t proofs) {
    const SceneResult& result = view.result();
    std::vector<ObjectId> drawn;
    for (const DrawnObject& object : result.drawn) drawn.push_back(object.id);
    std::ranges::sort(drawn, {}, &ObjectId::slot);
    ASSERT_EQ(std::ranges::adjacent_find(drawn), drawn.end()) << "drawn twice";
    std::size_t in_layers = 0, out_of_view = 0;
    std::vector<kernel::HalfSpace> planes;
    for (const HalfSpace& h : result.view) planes.push_back(culler::to_kernel(h));
    const glm::dvec3 forward = camera.axes().forward;
    const kernel::HalfSpace beyond_near{to_kernel(forward), -glm::dot(forward, camera.eye) - camera.near_plane};
    const auto cover = kernel::Cover::make(camera.viewpoint(), hiding(options.mask, camera), beyond_near);
    for (const auto& [slot, entry] : world_.objects) {
      const ObjectId id = entry.first;
      const World::Object& object = entry.second;
      const bool is_drawn = std::ranges::binary_search(drawn, slot, {}, &ObjectId::slot);
      if ((object.mask() & options.mask) == 0) {
        ASSERT_FALSE(is_drawn);
        continue;
      }
      ++in_layers;
      if (is_drawn) {
        ASSERT_TRUE(std::ranges::binary_search(drawn, id, [](ObjectId a, ObjectId b) { return a.slot() < b.slot(); }));
        continue;
      }
      ASSERT_FALSE(object.options.is_always_drawn);
      const bool is_out = std::ranges::any_of(planes, [&](const kernel::HalfSpace& h) {
        return std::visit([&](const auto& box) { return kernel::relation(h, box, kernel::Arithmetic::certified); },
                          object.box) == kernel::Relation::outside;
      });
      out_of_view += is_out;
      if (is_out || proofs == 0) continue;
      --proofs;
      ++proved_;
      ASSERT_TRUE(cover.cover);
      ASSERT_EQ(kernel::overlap_certified(*cover.cover, outer_box(object.box)).relation, kernel::Relation::inside)
          << "object " << slot << ", seed " << GetParam();
    }
    const SceneStats& stats = result.stats;
    ASSERT_EQ(stats.drawn, drawn.size());
    ASSERT_EQ(stats.drawn + stats.hidden + stats.out_of_view + stats.too_small, in_layers);
    ASSERT_LE(stats.out_of_view, out_of_view) << "what is hidden may be out of view, too";
    hidden_ += stats.hidden;
  }

  /// The slots that a scene with the same content, made at once, draws in a frame of the view.
  [[nodiscard]] std::vector<std::uint32_t> drawn_anew(const Camera& camera, const SceneOptions& options,
                                                      SceneView& view) const {
    Scene scene;
    std::map<std::uint32_t, std::uint32_t> slots;
    std::map<std::uint32_t, ObjectId> anew;
    for (const auto& [slot, entry] : world_.objects) {
      const World::Object& object = entry.second;
      const ObjectId id = scene.add(object.box, object.options);
      if (!object.is_enabled) scene.set_enabled(id, false);
      slots[id.slot()] = slot;
      anew[slot] = id;
    }
    for (const auto& [slot, entry] : world_.occluders) {
      const World::Standing& standing = entry.second;
      OccluderOptions its = standing.options;
      if (!its.object.is_none()) {
        const auto found = world_.objects.find(its.object.slot());
        if (found == world_.objects.end() || found->second.first != its.object) continue;
        its.object = anew[its.object.slot()];
      }
      const OccluderId id = scene.add(standing.mesh, standing.placement, its);
      if (!standing.is_enabled) scene.set_enabled(id, false);
    }
    scene.update();
    std::vector<std::uint32_t> drawn;
    for (const DrawnObject& object : scene.cull(camera, options, view).drawn) drawn.push_back(slots[object.id.slot()]);
    std::ranges::sort(drawn);
    return drawn;
  }

  std::mt19937 random_{GetParam()};
  std::shared_ptr<const OccluderMesh> house_ = std::make_shared<OccluderMesh>(house());
  PolygonSoup wall_soup_ = [] {
    PolygonSoup soup;
    add_wall(soup, 0, -4, 4, 0, 3);
    return soup;
  }();
  std::shared_ptr<const OccluderMesh> wall_ = std::make_shared<OccluderMesh>(wall_soup_);
  PolygonSoup panel_soup_ = [] {
    PolygonSoup soup;
    for (int i = 0; i < 600; ++i) add_wall(soup, 0, i / 20 * 0.5 - 7, i / 20 * 0.5 - 6.5, i % 20 * 0.2, i % 20 * 0.2 + 0.2);
    return soup;
  }();
  std::shared_ptr<const OccluderMesh> panels_ = std::make_shared<OccluderMesh>(panel_soup_);
  Scene scene_;
  World world_;
  std::size_t hidden_ = 0, proved_ = 0;
};

TEST_P(Worlds, AreCulledAsIfMadeAnew) {
  for (int i = 0; i < 60; ++i) add_occluder();
  add_objects(3000);
  SceneView view, anew;
  for (int frame = 0; frame < 40; ++frame) {
    edit(frame % 7 == 0 ? 300 : 20);
    scene_.update();
    ASSERT_EQ(scene_.objects(), world_.objects.size());
    ASSERT_EQ(scene_.occluders(), world_.occluders.size());
    const Camera camera = random_camera(random_);
    SceneOptions options;
    options.cover = {.width = 256, .height = 144};
    options.is_adaptive = false;
    if (chance(3)) options.mask = 1 + below(7);
    options.is_adaptive = false;
    const SceneResult& result = scene_.cull(camera, options, view);
    expect_right(camera, options, view, frame % 4 == 0 ? 20 : 0);
    std::vector<std::uint32_t> drawn;
    for (const DrawnObject& object : result.drawn) drawn.push_back(object.id.slot());
    std::ranges::sort(drawn);
    ASSERT_EQ(drawn, drawn_anew(camera, options, anew)) << "frame " << frame << ", seed " << GetParam();
  }
  EXPECT_GT(hidden_, 5000U);
  EXPECT_GT(proved_, 60U);
}

/// Whatever a view takes as idle, and however the scene and the camera have changed since.
TEST_P(Worlds, AreCulledRightlyByViewsThatSaveWork) {
  for (int i = 0; i < 200; ++i) add_occluder();
  add_objects(3000);
  SceneView view;
  memory_of(view).worth.cheap = 0;
  std::size_t idle = 0;
  Camera camera = random_camera(random_);
  for (int frame = 0; frame < 60; ++frame) {
    if (frame % 20 == 19) camera = random_camera(random_);
    camera.eye.x += 0.1;
    edit(frame % 7 == 0 ? 300 : 20);
    scene_.update();
    SceneOptions options;
    options.cover = {.width = 256, .height = 144};
    if (chance(4)) options.cover.work = 3000;
    scene_.cull(camera, options, view);
    expect_right(camera, options, view, frame % 4 == 0 ? 20 : 0);
    idle += memory_of(view).occluders.taken.size();
  }
  EXPECT_GT(hidden_, 2000U);
  EXPECT_GT(proved_, 60U);
  EXPECT_GT(idle, 100U);
}

/// Thousands of occluders are in many groups, and how they are depends on all that went before. Frames must not.
TEST_P(Worlds, AreCulledAsIfMadeAnewWhateverGroupsOccludersAreIn) {
  add_occluder_tile(1500);
  for (int i = 0; i < 20; ++i) add_occluder_tile(10 + below(100));
  add_objects(3000);
  SceneView view, anew;
  for (int frame = 0; frame < 30; ++frame) {
    if (chance(2)) add_occluder_tile(1 + below(frame % 8 == 0 ? 1200 : 60));
    if (chance(2)) remove_occluders(1 + below(frame % 8 == 4 ? 1200 : 60));
    for (std::uint32_t changes = below(50); changes > 0; --changes) change_occluder();
    scene_.update();
    for (int cameras = 0; cameras < 4; ++cameras) {
      const Camera camera = random_camera(random_);
      SceneOptions options;
      options.cover = {.width = 256, .height = 144};
      options.is_adaptive = false;  // a frame that looks less ends elsewhere in other trees
      if (chance(3)) options.mask = 1 + below(7);
      options.is_adaptive = false;
      const SceneResult& result = scene_.cull(camera, options, view);
      hidden_ += result.stats.hidden;
      std::vector<std::uint32_t> drawn;
      for (const DrawnObject& object : result.drawn) drawn.push_back(object.id.slot());
      std::ranges::sort(drawn);
      ASSERT_EQ(drawn, drawn_anew(camera, options, anew)) << "frame " << frame << ", seed " << GetParam();
      const SceneStats &stats = result.stats, &other = anew.result().stats;
      ASSERT_EQ(stats.occluders, other.occluders) << "in another order";
      ASSERT_EQ(stats.work.cover_triangles, other.work.cover_triangles) << "in another order";
    }
  }
  EXPECT_GT(hidden_, 5000U);
}

/// Layers change without anything that comes, goes or moves.
TEST_P(Worlds, LayersAloneMayChange) {
  for (int i = 0; i < 60; ++i) add_occluder();
  for (int i = 0; i < 10; ++i) add_objects(1 + below(200));
  scene_.update();
  SceneView view, anew;
  for (int frame = 0; frame < 40; ++frame) {
    auto& [object, its] = any(world_.objects);
    auto& [occluder, standing] = any(world_.occluders);
    if (chance(2)) {
      scene_.set_enabled(object, its.is_enabled = !its.is_enabled);
      scene_.set_enabled(occluder, standing.is_enabled = !standing.is_enabled);
    } else {
      scene_.set_mask(object, its.options.mask = 1U << below(3));
      scene_.set_mask(occluder, standing.options.mask = 1U << below(3));
    }
    scene_.update();
    const Camera camera = random_camera(random_);
    const SceneOptions options{.mask = chance(2) ? 1 + below(7) : ~0U};
    const SceneResult& result = scene_.cull(camera, options, view);
    expect_right(camera, options, view, 5);
    std::vector<std::uint32_t> drawn;
    for (const DrawnObject& one : result.drawn) drawn.push_back(one.id.slot());
    std::ranges::sort(drawn);
    ASSERT_EQ(drawn, drawn_anew(camera, options, anew)) << "frame " << frame << ", seed " << GetParam();
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, Worlds, testing::Range(1U, unless_sanitized(5U, 2U)));

Placement at(double x, double y, double z) { return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {x, y, z}}; }

/// The rectangle from (-1, -1) to (1, 1) straddled_planes the x axis, which looks clockwise from smaller x.
std::shared_ptr<const OccluderMesh> wall() {
  PolygonSoup soup;
  add_wall(soup, 0, -1, 1, -1, 1);
  return std::make_shared<OccluderMesh>(soup);
}

/// A scene with one wall straddled_planes the line of sight of Camera{}, and an object behind it.
struct WallScene : Scene {
  explicit WallScene(const OccluderOptions& options = {}) : occluder(add(wall(), at(2, 0, 0), options)) { update(); }

  std::size_t drawn(const SceneOptions& options = {}) {
    update();
    SceneView view;
    return cull(Camera{}, options, view).drawn.size();
  }

  OccluderId occluder;
  ObjectId object = add(Aabb{{4, -0.5, -0.5}, {5, 0.5, 0.5}});
};

TEST(Scene, ChangesShowAtTheNextUpdate) {
  WallScene scene;
  SceneView view;
  EXPECT_TRUE(scene.cull(Camera{}, {}, view).drawn.empty()) << "not added yet";
  EXPECT_EQ(scene.drawn(), 0U) << "hidden";
  scene.move(scene.occluder, at(2, 1, 0));
  EXPECT_TRUE(scene.cull(Camera{}, {}, view).drawn.empty()) << "not moved yet";
  EXPECT_EQ(scene.drawn(), 1U);
  scene.move(scene.object, Aabb{{4, 1, -0.5}, {5, 2, 0.5}});
  EXPECT_EQ(scene.drawn(), 0U);
  scene.set_enabled(scene.occluder, false);
  EXPECT_EQ(scene.drawn(), 1U);
  scene.set_enabled(scene.occluder, true);
  EXPECT_EQ(scene.drawn(), 0U);
  scene.remove(scene.occluder);
  EXPECT_EQ(scene.drawn(), 1U);
  scene.set_enabled(scene.object, false);
  EXPECT_EQ(scene.drawn(), 0U);
  scene.set_enabled(scene.object, true);
  EXPECT_EQ(scene.drawn(), 1U);
  scene.remove(scene.object);
  EXPECT_EQ(scene.drawn(), 0U);
  EXPECT_EQ(scene.objects() + scene.occluders(), 0U);
}

TEST(Scene, WhatWasAddedAndRemovedBetweenUpdatesWasNeverThere) {
  for (const bool moves : {false, true}) {
    WallScene scene;
    scene.remove(scene.occluder);
    const ObjectId first = scene.add(Aabb{{4, 0, 0}, {5, 1, 1}}, {.moves = moves});
    scene.remove(first);
    const ObjectId second = scene.add(Aabb{{4, 0, 0}, {5, 1, 1}}, {.moves = !moves});
    EXPECT_EQ(first.slot(), second.slot()) << "the place is used again";
    EXPECT_NE(first, second);
    scene.move(second, Aabb{{-5, 0, 0}, {-4, 1, 1}});
    EXPECT_EQ(scene.drawn(), 1U) << "the object of the scene";
    scene.remove(second);
    const OccluderId hiding = scene.add(wall(), at(2, 0, 0));
    scene.remove(hiding);
    EXPECT_EQ(scene.drawn(), 1U);
  }
}

/// Everything that takes an id refuses this one, and says this.
void expect_refused(Scene& scene, ObjectId id, const std::string& reason) {
  EXPECT_FALSE(scene.contains(id));
  EXPECT_EQ(scene.fault(id), reason);
  EXPECT_EQ(refusal([&] { scene.remove(id); }), reason);
  EXPECT_EQ(refusal([&] { scene.move(id, Aabb{}); }), reason);
  EXPECT_EQ(refusal([&] { scene.set_enabled(id, true); }), reason);
  EXPECT_EQ(refusal([&] { scene.set_mask(id, 1); }), reason);
  const ObjectId good = scene.add(Aabb{});
  const std::array ids{good, id};
  EXPECT_EQ(refusal([&] { scene.remove(ids); }), "object 1: " + reason);
  EXPECT_EQ(refusal([&] { scene.move(ids, std::array{Box{}, Box{}}); }), "object 1: " + reason);
  EXPECT_EQ(refusal([&] { static_cast<void>(scene.why(Camera{}, {}, SceneView(), ids)); }), "object 1: " + reason);
  if (!id.is_none()) {
    const std::string said = "the object that draws the occluder: " + reason;
    EXPECT_EQ(refusal([&] { scene.add(wall(), at(2, 0, 0), {.object = id}); }), said);
    OccluderId none;
    EXPECT_EQ(refusal([&] { scene.add(wall(), std::array{Placement{}}, {.object = id}, std::span(&none, 1)); }), said);
    EXPECT_TRUE(none.is_none());
  }
  EXPECT_TRUE(scene.contains(good));
  scene.remove(good);
}

void expect_refused(Scene& scene, OccluderId id, const std::string& reason) {
  EXPECT_FALSE(scene.contains(id));
  EXPECT_EQ(scene.fault(id), reason);
  EXPECT_EQ(refusal([&] { scene.remove(id); }), reason);
  EXPECT_EQ(refusal([&] { scene.move(id, Placement{}); }), reason);
  EXPECT_EQ(refusal([&] { scene.replace(id, wall()); }), reason);
  EXPECT_EQ(refusal([&] { scene.set_enabled(id, true); }), reason);
  EXPECT_EQ(refusal([&] { scene.set_mask(id, 1); }), reason);
  const OccluderId good = scene.add(wall());
  const std::array ids{good, id};
  EXPECT_EQ(refusal([&] { scene.remove(ids); }), "occluder 1: " + reason);
  EXPECT_EQ(refusal([&] { scene.move(ids, std::array{Placement{}, Placement{}}); }), "occluder 1: " + reason);
  EXPECT_TRUE(scene.contains(good));
  scene.remove(good);
}

TEST(Scene, RefusesIdsOfWhatIsNotThere) {
  WallScene scene;
  const ObjectId stale = scene.object;
  const OccluderId old = scene.occluder;
  scene.remove(stale);
  scene.remove(old);
  for (int i = 0; i < 2; ++i) {
    expect_refused(scene, ObjectId(), "the id is none");
    expect_refused(scene, stale, "the scene has no such object");
    expect_refused(scene, ObjectId(99, 0, stale.scene()), "the scene has no such object");
    expect_refused(scene, OccluderId(), "the id is none");
    expect_refused(scene, old, "the scene has no such occluder");
    expect_refused(scene, OccluderId(99, 0, old.scene()), "the scene has no such occluder");
    // Others take their places.
    EXPECT_EQ(scene.add(Aabb{{4, 0, 0}, {5, 1, 1}}).slot(), i == 0 ? stale.slot() : 1);
    EXPECT_EQ(scene.add(wall()).slot(), i == 0 ? old.slot() : 1);
  }
}

/// Two scenes in which all slots and generations are the same.
TEST(Scene, RefusesIdsOfAnotherSceneAndOfTheOtherKind) {
  WallScene scene, other;
  ASSERT_EQ(scene.object.slot(), other.object.slot());
  ASSERT_EQ(scene.object.slot(), scene.occluder.slot());
  expect_refused(scene, other.object, "the id is that of another scene");
  expect_refused(scene, other.occluder, "the id is that of another scene");
  // Types keep kinds apart; numbers, in other languages, do not.
  expect_refused(scene, ObjectId::from_number(scene.occluder.number()), "the id is that of an occluder, not of an object");
  expect_refused(scene, OccluderId::from_number(scene.object.number()), "the id is that of an object, not of an occluder");
  EXPECT_EQ(ObjectId::from_number(scene.object.number()), scene.object);
  EXPECT_EQ(scene.objects() + scene.occluders(), 2U);
  EXPECT_EQ(scene.drawn(), 0U);
  const ObjectId id = other.object;
  const Scene moved = std::move(other);
  EXPECT_TRUE(moved.contains(id)) << "ids stay with what they name";
}

/// Not even of scenes that were there one after another, nor of things that came and went a million times.
TEST(Scene, NeverGivesAnIdTwice) {
  std::set<std::uint64_t> seen;
  for (int i = 0; i < 1000; ++i) {
    Scene scene;
    for (int k = 0; k < 3; ++k) {
      const ObjectId id = scene.add(Aabb{});
      ASSERT_TRUE(seen.insert(id.number()).second);
      ASSERT_TRUE(seen.insert(scene.add(wall()).number()).second);
      if (i % 2 == 0) scene.remove(id);
    }
  }
  Scene scene;
  const ObjectId first = scene.add(Aabb{});
  ObjectId last = first;
  std::size_t used = 0;
  for (; last.slot() == first.slot(); ++used) {
    scene.remove(last);
    last = scene.add(Aabb{});
  }
  EXPECT_EQ(first.generation() + used, std::size_t{1} << ObjectId::kGenerationBits) << "the slot has used all of them";
  EXPECT_FALSE(scene.contains(first));
  EXPECT_TRUE(scene.contains(last));
  EXPECT_EQ(scene.objects(), 1U);
}

TEST(Scene, HasANumberOfItsOwnWhileItLives) {
  constexpr std::size_t kMost = (1U << ObjectId::kSceneBits) - 1;
  std::vector<Scene> scenes;
  std::set<std::uint32_t> numbers;
  const auto add = [&] { numbers.insert(scenes.emplace_back().add(Aabb{}).scene()); };
  EXPECT_THROW(
      {
        while (scenes.size() <= kMost) add();
      },
      std::runtime_error);
  EXPECT_EQ(numbers.size(), scenes.size());
  EXPECT_GT(scenes.size(), kMost - 100) << "others of this program";
  scenes.resize(scenes.size() / 2);
  add();
}

TEST(Placement, IsWhatTheMatrixSays) {
  const Placement expected{{1, 2, 3}, {5, 6, 7}, {9, 10, 11}, {13, 14, 15}};
  std::array<double, 16> columns{1, 2, 3, 0, 5, 6, 7, 0, 9, 10, 11, 0, 13, 14, 15, 1};
  const std::array<float, 16> rows{1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15, 0, 0, 0, 1};
  EXPECT_EQ(Placement::from_columns(columns.data()), expected);
  EXPECT_EQ(Placement::from_rows(rows.data()), expected);
  const std::string said = "the matrix of a placement is not affine: its last row must be (0, 0, 0, 1)";
  EXPECT_EQ(refusal([&] { static_cast<void>(Placement::from_columns(rows.data())); }), said);
  for (const int i : {3, 7, 11, 15}) {
    for (const double wrong : {0.5, std::numeric_limits<double>::quiet_NaN()}) {
      const double right = std::exchange(columns[static_cast<std::size_t>(i)], wrong);
      EXPECT_EQ(refusal([&] { static_cast<void>(Placement::from_columns(columns.data())); }), said);
      columns[static_cast<std::size_t>(i)] = right;
    }
  }
}

/// Solves edges * a = p - centre in long doubles.
std::array<long double, 3> coordinates_in(const Obb& box, const Vec3& p) {
  using Wide = std::array<long double, 3>;
  const auto wide = [](const Vec3& v) -> Wide { return {v.x, v.y, v.z}; };
  const auto determinant = [](const Wide& a, const Wide& b, const Wide& c) {
    return a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
  };
  const Wide e[3] = {wide(box.half_edges[0]), wide(box.half_edges[1]), wide(box.half_edges[2])};
  Wide to;
  for (int axis = 0; axis < 3; ++axis) {
    to[static_cast<std::size_t>(axis)] = static_cast<long double>(p[axis]) - static_cast<long double>(box.center[axis]);
  }
  const long double volume = determinant(e[0], e[1], e[2]);
  return {determinant(to, e[1], e[2]) / volume, determinant(e[0], to, e[2]) / volume, determinant(e[0], e[1], to) / volume};
}

/// Whether a corner of the box, where it is placed, is in the box that was made of both, and how near to its border.
long double reach_of_corners(const Aabb& local, const Placement& at, const Obb& made) {
  long double reach = 0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) p[axis] = (corner >> axis & 1U) != 0 ? local.max[axis] : local.min[axis];
    for (const long double a : coordinates_in(made, placed(at, p))) reach = std::max(reach, std::fabs(a));
  }
  return reach;
}

TEST(Placement, EightBoxesAreWhereEachIsUpToRounding) {
  std::mt19937 random(kSeed);
  for (int i = 0; i < 500; ++i) {
    const Placement at{random_vector(random, -1, 1), random_vector(random, -1, 1), random_vector(random, -1, 1),
                       random_vector(random, -9, 9)};
    kernel::BoxBlock boxes;
    for (std::size_t k = 0; k < kernel::BoxBlock::kBoxes; ++k) {
      const Vec3 low = random_vector(random, -2, 2), size = random_vector(random, 0, 3);
      boxes.set(k, {low, {low.x + size.x, low.y + size.y, low.z + size.z}});
    }
    const kernel::BoxBlock nearly = nearly_placed(at, boxes);
    for (std::size_t k = 0; k < kernel::BoxBlock::kBoxes; ++k) {
      const Aabb one = placed(at, boxes.box(k)), of_eight = nearly.box(k);
      for (int axis = 0; axis < 3; ++axis) {
        ASSERT_NEAR(of_eight.min[axis], one.min[axis], 1e-12) << "seed " << kSeed << ", " << i;
        ASSERT_NEAR(of_eight.max[axis], one.max[axis], 1e-12) << "seed " << kSeed << ", " << i;
      }
    }
  }
}

TEST(Placement, BoxesOfObjectsHoldWhatIsPlaced) {
  std::mt19937 random(kSeed);
  std::size_t oriented = 0;
  for (int i = 0; i < 4000; ++i) {
    const double far = std::ldexp(1, static_cast<int>(random() % 20));
    const Placement at{random_vector(random, -1, 1), random_vector(random, -1, 1), random_vector(random, -1, 1),
                       random_vector(random, -far, far)};
    const Vec3 low = random_vector(random, -2, 2), size = random_vector(random, 0, 3);
    const Aabb local{low, {low.x + size.x, low.y + size.y, low.z + size.z}};
    const Box box = placed_box(local, at);
    EXPECT_TRUE(fault(box).empty());
    if (const Obb* made = std::get_if<Obb>(&box)) {
      ++oriented;
      const long double reach = reach_of_corners(local, at, *made);
      ASSERT_LE(reach, 1) << "seed " << kSeed << ", " << i;
      ASSERT_GE(reach, 0.998) << "and not much more";
    } else {
      EXPECT_EQ(std::get<Aabb>(box), placed(at, local));
    }
  }
  EXPECT_GT(oriented, 3500U);
}

TEST(Placement, BoxesOfObjectsAreAlignedWhereThatIsAsTight) {
  const Aabb local{{-1, -2, -3}, {4, 5, 6}}, flat{{-1, -2, 3}, {4, 5, 3}};
  const Placement quarter{{0, 2, 0}, {-1, 0, 0}, {0, 0, 3}, {7, 8, 9}}, turned{{1, 1, 0}, {-1, 1, 0}, {0, 0, 1}, {0, 0, 0}};
  const Placement lean{{1, 1, 0}, {1, 1.0001, 0}, {0, 0, 1}, {0, 0, 0}}, none{{0, 0, 0}, {0, 0, 0}, {1, 1, 0}, {0, 0, 0}};
  const auto is_aligned = [](const Box& box) { return std::holds_alternative<Aabb>(box); };
  EXPECT_TRUE(is_aligned(placed_box(local, {})));
  EXPECT_TRUE(is_aligned(placed_box(local, quarter)));
  EXPECT_FALSE(is_aligned(placed_box(local, turned)));
  EXPECT_TRUE(is_aligned(placed_box(flat, turned))) << "what sticks out of it would not be held";
  EXPECT_TRUE(is_aligned(placed_box(local, lean)));
  EXPECT_TRUE(is_aligned(placed_box(local, none)));
}

TEST(Scene, MovesAndRemovesManyAtOnce) {
  Scene scene;
  const std::array<Box, 3> boxes{Aabb{{4, 0, 0}, {5, 1, 1}}, Aabb{{6, 0, 0}, {7, 1, 1}}, Aabb{{-5, 0, 0}, {-4, 1, 1}}};
  std::array<ObjectId, 3> ids;
  scene.add(boxes, {}, ids);
  std::array<OccluderId, 2> walls;
  scene.add(wall(), std::array{at(2, 0, 0), at(-2, 0, 0)}, {}, walls);
  scene.update();
  SceneView view;
  EXPECT_EQ(scene.cull(Camera{}, {}, view).stats.hidden, 2U);
  scene.move(walls, std::array{at(-2, 0, 0), at(-3, 0, 0)});
  scene.move(ids, std::array{boxes[2], boxes[2], boxes[0]});
  scene.update();
  ASSERT_EQ(scene.cull(Camera{}, {}, view).drawn.size(), 1U);
  EXPECT_EQ(view.result().drawn[0].id, ids[2]);
  scene.remove(std::array{ids[0], ids[1], ids[0]});
  scene.remove(std::array{walls[1], walls[1]});
  EXPECT_EQ(scene.objects() + scene.occluders(), 2U);

  // All or none.
  const Placement nowhere = at(std::numeric_limits<double>::quiet_NaN(), 0, 0);
  const std::string said = "placement 1: an occluder's placement is not finite, or takes it beyond 2^100";
  EXPECT_EQ(refusal([&] { scene.add(wall(), std::array{at(2, 0, 0), nowhere}, {}, walls); }), said);
  scene.add(wall(), std::array{at(-2, 0, 0), at(-2, 0, 0)}, {}, walls);
  EXPECT_EQ(refusal([&] { scene.move(walls, std::array{at(2, 0, 0), nowhere}); }), said);
  std::array<ObjectId, 2> both;
  scene.add(std::array{boxes[2], boxes[2]}, {}, both);
  const Box upside_down = Aabb{{0, 0, 1}, {1, 1, 0}};
  EXPECT_EQ(refusal([&] { scene.move(both, std::array{boxes[0], upside_down}); }), "object 1: box has min > max");
  scene.update();
  EXPECT_EQ(scene.cull(Camera{}, {}, view).drawn.size(), 1U);
}

TEST(Scene, RefusesWhatCannotBeRightAndChangesNothing) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Box good = Aabb{{4, -0.5, -0.5}, {5, 0.5, 0.5}}, upside_down = Aabb{{0, 0, 1}, {1, 1, 0}};
  const Box bad = Obb{{0, nan, 0}, {}}, bad_edge = Obb{{0, 0, 0}, {{{nan, 0, 0}, {}, {}}}};
  WallScene scene;
  EXPECT_EQ(refusal([&] { scene.add(upside_down); }), "box has min > max");
  EXPECT_EQ(refusal([&] { scene.add(bad); }), "box has a number that is NaN");
  EXPECT_EQ(refusal([&] { scene.add(bad_edge, {.moves = true}); }), "box has a number that is NaN");
  std::array<ObjectId, 2> ids;
  EXPECT_EQ(refusal([&] { scene.add(std::array{good, bad}, {}, ids); }), "object 1: box has a number that is NaN");
  EXPECT_EQ(refusal([&] { scene.move(scene.object, bad); }), "box has a number that is NaN");
  EXPECT_EQ(scene.objects(), 1U);

  const std::string unplaceable = "an occluder's placement is not finite, or takes it beyond 2^100";
  EXPECT_EQ(refusal([&] { scene.add(nullptr); }), "an occluder without a mesh");
  EXPECT_EQ(refusal([&] { scene.replace(scene.occluder, nullptr); }), "an occluder without a mesh");
  for (const Placement& p :
       {at(nan, 0, 0), at(0, kInfinity, 0), at(0, 0, 0x1p100), Placement{{0x1p101, 0, 0}, {0, 0x1p101, 0}}}) {
    EXPECT_EQ(refusal([&] { scene.add(wall(), p); }), unplaceable);
    EXPECT_EQ(refusal([&] { scene.move(scene.occluder, p); }), unplaceable);
  }
  EXPECT_EQ(scene.occluders(), 1U);
  EXPECT_EQ(scene.drawn(), 0U) << "as before";

  SceneView view;
  scene.cull(Camera{}, {}, view);
  EXPECT_EQ(refusal([&] { static_cast<void>(view.visibility(bad)); }), "number is not finite");
  Camera blind;
  blind.target = blind.eye;
  EXPECT_NE(refusal([&] { scene.cull(blind, {}, view); }), "");
  EXPECT_EQ(view.result().stats.hidden, 1U) << "the last frame";
}

TEST(Scene, BoxesWithoutAPlaceAreAlwaysDrawn) {
  const double most = std::numeric_limits<float>::max();
  for (const bool moves : {false, true}) {
    WallScene scene;
    const Aabb behind{{-5, 0, 0}, {-4, 1, 1}};
    const ObjectId id = scene.add(behind, {.moves = moves});
    EXPECT_EQ(scene.drawn(), 0U);
    for (const Box& box :
         {Box{Aabb{{-most, -most, -most}, {most, most, most}}}, Box{Aabb{{-kInfinity, 0, 0}, {-4, 1, 1}}},
          Box{Obb{{0x1p100, 0, 0}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}}, Box{Obb{{kInfinity, 0, 0}, {}}}}) {
      scene.move(id, box);
      EXPECT_EQ(scene.drawn(), 1U);
      EXPECT_EQ(scene.drawn({.mask = 0}), 0U);
      scene.set_enabled(id, false);
      EXPECT_EQ(scene.drawn(), 0U);
      scene.set_enabled(id, true);
      EXPECT_EQ(scene.drawn(), 1U);
      scene.move(id, behind);
      EXPECT_EQ(scene.drawn(), 0U);
    }
    const ObjectId always = scene.add(behind, {.moves = moves, .is_always_drawn = true});
    EXPECT_EQ(scene.drawn(), 1U);
    scene.move(always, Aabb{{-6, 0, 0}, {-5, 1, 1}});
    EXPECT_EQ(scene.drawn(), 1U) << "wherever it is";
    scene.remove(always);
    EXPECT_EQ(scene.drawn(), 0U);
  }
}

/// What turns leave: numbers that the kernel refuses.
TEST(Scene, NumbersNearToZeroAreRoundedOutwards) {
  Scene scene;
  SceneView view;
  const ObjectId turned = scene.add(Obb{{4, 0, 0}, {{{3.7e-33, 1, 0}, {-1, 3.7e-33, 0}, {0, 0, 1}}}});
  const ObjectId flat = scene.add(Aabb{{3, 0x1p-200, -0x1p-200}, {3, 0x1p-150, 0}});
  // Its edge along the border of the view, by a number that is not legal, is inside.
  scene.update();
  EXPECT_EQ(scene.cull(Camera{}, {}, view).drawn.size(), 2U);
  scene.remove(turned);
  scene.remove(flat);
  PolygonSoup soup;
  add_wall(soup, 2, -1, 1, -1, 1);
  soup.vertices[0].x = 2;
  soup.vertices[0].z = -1;
  soup.vertices.push_back({3.7e-33, 0, 1e-300});
  EXPECT_NO_THROW(scene.add(std::make_shared<OccluderMesh>(soup)));
}

TEST(Scene, WhatTouchesOrHoldsItsOccluderIsDrawn) {
  // A house whose wall is the occluder and whose box holds it, and pictures on the wall.
  const std::vector<Box> boxes{
      Aabb{{4, -1, -1}, {6, 1, 1}},                                    // the house
      Aabb{{4, -0.5, -0.5}, {4, 0.5, 0.5}},                            // on the wall
      Aabb{{4, -0.5, -0.5}, {5, 0.5, 0.5}},                            // touches it from behind
      Obb{{5, 0, 0}, {{{0.5, 0.5, 0}, {0.5, -0.5, 0}, {0, 0, 0.5}}}},  // an edge of it touches from behind
      Aabb{{4.001, -0.5, -0.5}, {5, 0.5, 0.5}}};                       // behind it
  for (const Projection projection : {Projection::perspective, Projection::orthographic}) {
    Scene scene;
    std::vector<ObjectId> ids(boxes.size());
    scene.add(boxes, {}, ids);
    scene.add(wall(), at(4, 0, 0));
    scene.update();
    Camera camera;
    camera.projection = projection;
    camera.height = 10;
    SceneView view;
    std::vector<std::uint32_t> drawn;
    for (const DrawnObject& object : scene.cull(camera, {}, view).drawn) drawn.push_back(object.id.slot());
    std::ranges::sort(drawn);
    EXPECT_EQ(drawn, (std::vector<std::uint32_t>{0, 1, 2, 3}));
  }
}

TEST(Scene, MasksAreLayers) {
  WallScene scene;
  scene.set_mask(scene.object, 2);
  EXPECT_EQ(scene.drawn(), 0U) << "hidden";
  scene.set_mask(scene.occluder, 1);
  EXPECT_EQ(scene.drawn({.mask = 3}), 0U);
  EXPECT_EQ(scene.drawn({.mask = 2}), 1U) << "without the occluder";
  EXPECT_EQ(scene.drawn({.mask = 1}), 0U) << "without the object";
  SceneView view;
  EXPECT_EQ(scene.cull(Camera{}, {.mask = 1}, view).stats.hidden, 0U);
  EXPECT_EQ(scene.cull(Camera{}, {.mask = 3}, view).stats.hidden, 1U);
}

TEST(Scene, AnOccluderHidesNothingWithoutItsObject) {
  for (const bool moves : {false, true}) {
    WallScene scene({.object = {}});
    const Aabb around{{1.9, -1, -1}, {2.1, 1, 1}};
    const ObjectId house = scene.add(around, {.moves = moves});
    scene.remove(scene.occluder);
    const OccluderId occluder = scene.add(wall(), at(2, 0, 0), {.object = house});
    EXPECT_EQ(scene.drawn(), 1U) << "the house";
    scene.set_enabled(house, false);
    EXPECT_EQ(scene.drawn(), 1U) << "what is behind it";
    scene.set_enabled(house, true);
    scene.set_mask(house, 2);
    EXPECT_EQ(scene.drawn({.mask = 1}), 1U) << "what is behind it";
    EXPECT_EQ(scene.drawn({.mask = 2}), 1U) << "the house";
    scene.set_mask(house, 3);
    scene.move(scene.object, Aabb{{4, -0.2, -0.2}, {4.1, 0.2, 0.2}});
    EXPECT_EQ(scene.drawn({.least_size = 100}), 0U);
    SceneView view;
    EXPECT_EQ(scene.cull(Camera{}, {.least_size = 100}, view).stats.too_small, 2U) << "neither hides the other";
    EXPECT_EQ(scene.cull(Camera{}, {.least_size = 0.5}, view).stats.hidden, 1U);
    scene.remove(house);
    EXPECT_EQ(scene.drawn(), 1U) << "what is behind it";
    const ObjectId other = scene.add(around, {.moves = moves});
    EXPECT_EQ(other.slot(), house.slot());
    EXPECT_EQ(scene.drawn(), 2U) << "it is not the same";
    scene.remove(occluder);
  }
}

TEST(Scene, OneSidedOccludersHideFromTheirFront) {
  Scene scene;
  scene.add(Aabb{{4, -0.5, -0.5}, {5, 0.5, 0.5}});
  const auto box = [] {
    PolygonSoup soup;
    soup.add_box({-1, -1, -1}, {1, 1, 1});
    return std::make_shared<OccluderMesh>(soup);
  }();
  const OccluderId occluder = scene.add(box, Placement{}, {.is_one_sided = true});
  SceneView view;
  Camera camera;
  const auto drawn = [&](const Placement& placement) {
    scene.move(occluder, placement);
    scene.update();
    return scene.cull(camera, {}, view).drawn.size();
  };
  EXPECT_EQ(drawn(at(0, 0, 0)), 1U) << "from within the box one sees out";
  EXPECT_EQ(drawn(at(2, 0, 0)), 0U);
  for (Placement mirrored : {at(2, 0, 0), at(0, 0, 0)}) {
    mirrored.y = {0, -1, 0};
    EXPECT_EQ(drawn(mirrored), mirrored.origin.x == 0 ? 1U : 0U) << "a mirror turns no face over";
  }
  scene.remove(occluder);
  const OccluderId both = scene.add(box, Placement{});
  scene.update();
  EXPECT_EQ(scene.cull(camera, {}, view).drawn.size(), 0U) << "its inside hides, too";
  scene.remove(both);
}

TEST(Scene, AnOccluderThatHidNothingIsLeftOutUntilItMoves) {
  Scene scene;
  for (int i = 0; i < 10; ++i) scene.add(Aabb{{8.0 + i, -0.5, -0.5}, {8.5 + i, 0.5, 0.5}});
  scene.add(Aabb{{30, 12, -0.2}, {31, 12.4, 0.2}});
  PolygonSoup soup;
  soup.add_box({-1, -1, -1}, {1, 1, 1});
  const auto box = std::make_shared<OccluderMesh>(soup);
  scene.add(box, at(4, 0, 0));
  const OccluderId other = scene.add(box, at(20, -9, 0));
  scene.update();
  SceneView view;
  memory_of(view).worth.cheap = 0;
  const auto expect = [&](std::size_t hidden, std::size_t occluders, const std::vector<OccluderId>& idle) {
    const SceneResult& result = scene.cull(Camera{}, {}, view);
    EXPECT_EQ(result.stats.hidden, hidden);
    EXPECT_EQ(result.stats.occluders, occluders);
    EXPECT_EQ(result.idle_occluders, idle);
  };
  expect(10, 2, {other});
  for (int frame = 1; frame < 6; ++frame) expect(10, 1, {other});
  expect(10, 2, {other});  // it looks again
  expect(10, 1, {other});
  scene.move(other, at(15, 6, 0));
  scene.update();
  expect(11, 2, {other});
  for (int frame = 3; frame < 6; ++frame) expect(11, 2, {other});
  expect(11, 2, {});
  EXPECT_TRUE(scene.cull(Camera{}, {.is_adaptive = false}, view).idle_occluders.empty());
}

TEST(Scene, KnowsHowLargeObjectsLookAndHowFarTheyAre) {
  Scene scene;
  const ObjectId near = scene.add(Aabb{{4, 1, 1}, {4, 2, 2}}), far = scene.add(Aabb{{40, 1, 1}, {40, 2, 2}});
  const ObjectId around = scene.add(Aabb{{-1, -1, -1}, {1, 1, 1}});
  const ObjectId sky = scene.add(Aabb{{-1, -1, -1}, {1, 1, 1}}, {.is_always_drawn = true});
  scene.update();
  SceneView view;
  Camera camera;
  camera.fov_y_deg = 90;
  const SceneResult& result = scene.cull(camera, {.is_front_to_back = true}, view);
  ASSERT_EQ(result.drawn.size(), 4U);
  EXPECT_EQ(result.drawn[0].id, sky);
  EXPECT_EQ(result.drawn[1].id, around);
  EXPECT_EQ(result.drawn[2].id, near);
  EXPECT_EQ(result.drawn[3].id, far);
  EXPECT_EQ(result.drawn[1].size, std::numeric_limits<float>::infinity());
  EXPECT_GE(result.drawn[2].size, 0.125F);  // 1 of 8
  EXPECT_LE(result.drawn[2].size, 0.1251F);
  EXPECT_GE(result.drawn[3].size, 0.0125F);
  EXPECT_LE(result.drawn[3].size, 0.0126F);
  scene.cull(camera, {.least_size = 0.1F}, view);
  EXPECT_EQ(view.result().drawn.size(), 3U);
  EXPECT_EQ(view.result().stats.too_small, 1U);
}

TEST(Scene, VisibilityAgreesWithWhatIsDrawn) {
  std::mt19937 random(kSeed);
  Scene scene;
  std::vector<Box> boxes;
  while (boxes.size() < 1500) boxes.push_back(random_box(random));
  std::vector<ObjectId> ids(boxes.size());
  scene.add(boxes, {}, ids);
  const auto town = std::make_shared<OccluderMesh>(random_town_of_houses(2, 1500));
  scene.add(town);
  scene.update();
  std::array<std::size_t, 3> counts{};
  std::vector<SceneBox> kept;
  for (const Box& box : boxes) kept.push_back(SceneBox::of(box));
  std::size_t larger = 0;
  for (int i = 0; i < 30; ++i) {
    SceneView view;
    std::vector<bool> is_drawn(boxes.size());
    const Camera camera = random_camera(random);
    for (const DrawnObject& object : scene.cull(camera, {}, view).drawn) is_drawn[object.id.slot()] = true;
    // Also of boxes that are beyond a plane of the view only when they are axis-aligned.
    std::vector<ObjectWitness> witnesses;
    scene.append_witnesses(camera, {}, view, witnesses);
    const SceneStats& stats = view.result().stats;
    ASSERT_EQ(witnesses.size(), stats.hidden + stats.out_of_view) << "seed " << kSeed;
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      const Visibility visibility = view.visibility(boxes[k]);
      ++counts[static_cast<std::size_t>(visibility)];
      const bool expected =
          view.visibility(kept[k].outer) == Visibility::visible &&
          (kept[k].edges.is_none() || view.visibility(kept[k].edges.box(kept[k].outer)) != Visibility::out_of_view);
      ASSERT_EQ(expected, is_drawn[ids[k].slot()]) << "seed " << kSeed;
      ASSERT_TRUE(expected || visibility != Visibility::visible) << "seed " << kSeed;
      larger += expected && visibility != Visibility::visible;
    }
  }
  EXPECT_GT(*std::ranges::min_element(counts), 500U) << "all answers must occur";
  EXPECT_LT(larger, 30 * boxes.size() / 1000) << "what a scene keeps is little larger than what it was given";
}

TEST(Scene, SaysWhatBecameOfEachObjectAndWhy) {
  using Reason = ObjectFate::Reason;
  std::mt19937 random(kSeed);
  Scene scene;
  std::vector<ObjectId> ids;
  for (int i = 0; i < 1000; ++i)
    ids.push_back(scene.add(random_box(random), {.moves = i % 3 == 0, .mask = i % 50 ? 1U : 2U}));
  ids.push_back(scene.add(Aabb{}, {.is_always_drawn = true}));
  const PolygonSoup town = random_town_of_houses(4, 1000);
  const auto mesh = std::make_shared<OccluderMesh>(town);
  scene.add(mesh);
  const Placement wide{{5, 0, 0}, {0, 8, 0}, {0, 0, 1}, {1, 0, 0}};
  const OccluderId house = scene.add(std::make_shared<OccluderMesh>(scene_test::house()), wide);
  scene.update();
  const ObjectId late = scene.add(Aabb{});
  ids.push_back(late);
  std::map<Reason, std::size_t> counts;
  std::size_t by_house = 0;
  for (int i = 0; i < 8; ++i) {
    SceneView view;
    const Camera camera = random_camera(random);
    SceneOptions options{.mask = 1, .least_size = 0.03F};
    if (i % 4 == 0) options.cover.work = 8000;
    std::vector<std::uint32_t> drawn;
    for (const DrawnObject& object : scene.cull(camera, options, view).drawn) drawn.push_back(object.id.slot());
    const std::vector<ObjectFate> fates = scene.why(camera, options, view, ids);
    ASSERT_EQ(fates.size(), ids.size());
    const glm::dvec3 forward = camera.axes().forward;
    const kernel::HalfSpace beyond_near{to_kernel(forward), -glm::dot(forward, camera.eye) - camera.near_plane};
    for (std::size_t k = 0; k < ids.size(); ++k) {
      const ObjectFate& fate = fates[k];
      ++counts[fate.reason];
      const bool is_drawn = std::ranges::count(drawn, ids[k].slot()) != 0;
      ASSERT_EQ(is_drawn, fate.reason == Reason::drawn || fate.reason == Reason::always_drawn);
      ASSERT_EQ(fate.by.empty(), fate.reason != Reason::hidden);
      for (const ObjectFate::Hiding& hiding : fate.by) by_house += hiding.occluder == house;
      if (fate.reason != Reason::hidden || counts[fate.reason] % 20 != 0) continue;
      std::vector<kernel::Cover::Polygon> polygons;
      for (const auto& [occluder, polygon, corners] : fate.by) {
        polygons.push_back(corners);
        const PolygonSoup& soup = occluder == house ? scene_test::house() : town;
        const Vec3 corner = to_kernel(soup.vertices[soup.loop(polygon)[0]]);
        ASSERT_EQ(corners[0], placed(occluder == house ? wide : Placement{}, corner));
      }
      const auto cover = kernel::Cover::make(camera.viewpoint(), polygons, beyond_near);
      ASSERT_TRUE(cover.cover);
      std::mt19937 again(kSeed);
      Box box;
      for (std::size_t j = 0; j <= k; ++j) box = random_box(again);
      ASSERT_EQ(kernel::overlap_certified(*cover.cover, outer_box(box)).relation, kernel::Relation::inside);
    }
  }
  for (const Reason reason : {Reason::drawn, Reason::always_drawn, Reason::out_of_view, Reason::hidden, Reason::too_small,
                              Reason::in_no_layer, Reason::not_in_scene}) {
    EXPECT_GT(counts[reason], 0U) << static_cast<int>(reason);
  }
  EXPECT_GT(counts[Reason::hidden], 500U);
  EXPECT_GT(by_house, 0U);
}

TEST(Scene, AViewMayBeUsedWithAnyScene) {
  std::mt19937 random(kSeed);
  const auto town = std::make_shared<OccluderMesh>(random_town_of_houses(2, 1500));
  Scene large, empty;
  WallScene small;
  large.add(town);
  for (int i = 0; i < 800; ++i) large.add(random_box(random), {.moves = i % 3 == 0});
  large.update();
  SceneView view;
  EXPECT_TRUE(view.result().drawn.empty());
  EXPECT_EQ(view.visibility(Aabb{{4, -0.5, -0.5}, {5, 0.5, 0.5}}), Visibility::visible) << "before the first frame";
  small.update();
  for (int i = 0; i < 3; ++i) {
    large.cull(random_camera(random), {}, view);
    EXPECT_EQ(small.cull(Camera{}, {}, view).drawn.size(), 0U);
    EXPECT_EQ(view.visibility(Aabb{{4, -0.5, -0.5}, {5, 0.5, 0.5}}), Visibility::occluded);
    EXPECT_EQ(view.visibility(Aabb{{-5, -0.5, -0.5}, {-4, 0.5, 0.5}}), Visibility::out_of_view);
    EXPECT_EQ(empty.cull(Camera{}, {}, view).drawn.size(), 0U);
    Scene moved = std::move(small);
    small = WallScene();
    small.update();
    SceneView other = std::move(view);
    EXPECT_EQ(moved.cull(Camera{}, {}, other).stats.hidden, 1U);
    view = std::move(other);
  }
}

TEST(Scene, IsCulledOnSeveralThreadsWhileItIsChanged) {
  std::mt19937 random(kSeed);
  Scene scene;
  std::vector<Box> boxes;
  while (boxes.size() < 600) boxes.push_back(random_box(random));
  std::vector<ObjectId> standing(300), moving(300);
  scene.add(std::span(boxes).first(300), {}, standing);
  scene.add(std::span(boxes).last(300), {.moves = true}, moving);
  scene.add(std::make_shared<OccluderMesh>(random_town_of_houses(5, 500)));
  const OccluderId wall_id = scene.add(wall(), at(0, 0, 0), {.moves = true});
  for (int round = 0; round < 10; ++round) {
    scene.update();
    const Camera camera = random_camera(random);
    SceneView alone;
    const auto slots = [](const SceneResult& result) {
      std::vector<std::uint32_t> drawn;
      for (const DrawnObject& object : result.drawn) drawn.push_back(object.id.slot());
      return drawn;
    };
    const auto expected = slots(scene.cull(camera, {}, alone));
    std::array<std::vector<std::uint32_t>, 2> found;
    std::vector<std::jthread> threads;
    for (auto& mine : found) {
      threads.emplace_back([&] {
        SceneView view;
        for (int i = 0; i < 5; ++i) mine = slots(scene.cull(camera, {}, view));
      });
    }
    for (std::size_t half = 0; half < 2; ++half) {
      threads.emplace_back([&, half] {
        for (std::size_t i = half; i < moving.size(); i += 2) scene.move(moving[i], boxes[i]);
      });
    }
    threads.emplace_back([&] {
      for (ObjectId& id : standing) {
        scene.remove(id);
        id = scene.add(boxes[id.slot() % boxes.size()]);
      }
      scene.move(wall_id, at(round, 0, 0));
      const OccluderId other = scene.add(wall(), at(-round, 0, 0));
      if (round % 2 == 0) scene.remove(other);
    });
    threads.clear();
    for (const auto& mine : found) EXPECT_EQ(mine, expected);
  }
}

/// How walls are made.
struct Panels {
  const char* name;
  bool is_one_mesh, shares_corners;
  double overlap;  ///< metres; negative: a seam
  double turn;     ///< radians, about the vertical
  double least_share;
  std::uint32_t weld = 0;  ///< of meshes
};

/// The share of 2,000 boxes, each in the shadow of a wall of ten panels, that is hidden. Boxes whose middle shows exactly
/// through a seam must not be hidden; they are not counted.
double share_hidden(const Panels& how) {
  constexpr int kPanels = 10;
  constexpr double kWidth = 2;
  const double c = std::cos(how.turn), s = std::sin(how.turn);
  Scene scene;
  PolygonSoup all;
  std::vector<std::uint32_t> corners;
  for (int i = 0; i < kPanels; ++i) {
    const double low = kWidth * i - kWidth * kPanels / 2 - how.overlap / 2, high = low + kWidth + how.overlap;
    const auto corner = [&](double y, double z) { return glm::dvec3{12 - s * y, c * y, z}; };
    if (how.shares_corners) {
      if (i == 0) corners = {all.add_vertex(corner(low, -3)), all.add_vertex(corner(low, 3))};
      const std::uint32_t below = all.add_vertex(corner(high, -3)), above = all.add_vertex(corner(high, 3));
      all.add_polygon(std::array{corners[0], below, above, corners[1]});
      corners = {below, above};
    } else {
      PolygonSoup panel;
      PolygonSoup& soup = how.is_one_mesh ? all : panel;
      add(soup, {corner(low, -3), corner(high, -3), corner(high, 3), corner(low, 3)});
      if (!how.is_one_mesh) scene.add(std::make_shared<OccluderMesh>(panel), {}, {.weld = how.weld});
    }
  }
  if (!all.empty()) scene.add(std::make_shared<OccluderMesh>(all));
  std::mt19937 random(kSeed);
  std::vector<ObjectId> ids;
  while (ids.size() < 2000) {
    // Seen through the wall, well inside of its border.
    const double straddled_planes = uniform(random, -8, 8), up = uniform(random, -2, 2), farther = uniform(random, 1.3, 4);
    const glm::dvec3 at = farther * glm::dvec3{12 - s * straddled_planes, c * straddled_planes, up};
    ids.push_back(scene.add(Aabb{{at.x - 0.2, at.y - 0.2, at.z - 0.2}, {at.x + 0.2, at.y + 0.2, at.z + 0.2}}));
  }
  std::vector<ObjectId> behind_seams;
  for (int i = 1; how.overlap < 0 && i < kPanels; ++i) {
    const double seam = kWidth * i - kWidth * kPanels / 2;
    const glm::dvec3 at = 2.0 * glm::dvec3{12 - s * seam, c * seam, 0};
    behind_seams.push_back(scene.add(Aabb{{at.x, at.y - 0.01, at.z - 0.01}, {at.x, at.y + 0.01, at.z + 0.01}}));
  }
  scene.update();
  SceneView view;
  Camera camera;
  const SceneResult& result = scene.cull(camera, {}, view);
  EXPECT_EQ(result.stats.out_of_view, 0U) << how.name;
  std::vector<std::uint32_t> drawn;
  for (const DrawnObject& object : result.drawn) drawn.push_back(object.id.slot());
  for (const ObjectId id : behind_seams) EXPECT_EQ(std::ranges::count(drawn, id.slot()), 1) << how.name;
  return static_cast<double>(result.stats.hidden) / static_cast<double>(ids.size());
}

/// The table in docs/measured.md.
TEST(Scene, WallsOfPanelsHide) {
  for (const Panels& how :
       {Panels{"one mesh, shared edges", true, true, 0, 0, 0.99},
        {"one mesh, equal corners", true, false, 0, 0, 0.99},
        {"one mesh, overlap of 0.1 m", true, false, 0.1, 0, 0.9},
        {"one mesh, seams of 2e-6 m", true, false, -2e-6, 0, 0.5},
        {"a mesh for each panel, touching", false, false, 0, 0, 0.5},
        {"a mesh for each panel, overlap of 0.1 m", false, false, 0.1, 0, 0.9},
        {"a mesh for each panel, seams of 2e-6 m", false, false, -2e-6, 0, 0.5},
        {"one mesh, shared edges, turned by 30 degrees", true, true, 0, 0.5236, 0.99},
        {"a mesh for each panel, overlap of 0.1 m, turned by 30 degrees", false, false, 0.1, 0.5236, 0.9},
        {"a mesh for each panel, welded", false, false, 0, 0, 0.99, 7},
        {"a mesh for each panel, welded, turned by 30 degrees", false, false, 0, 0.5236, 0.99, 7},
        {"a mesh for each panel, welded, seams of 2e-6 m", false, false, -2e-6, 0, 0.5, 7}}) {
    const double share = share_hidden(how);
    std::printf("%-64s %5.1f %%\n", how.name, 100 * share);
    EXPECT_GE(share, how.least_share) << how.name;
  }
}

/// Two halves of a wall, left and right of y = 0, and what is behind the seam between them.
class Halves {
 public:
  /// The halves are placed so that their corners are at the same places to the bit.
  Halves(const OccluderOptions& left, const OccluderOptions& right) {
    left_ = scene_.add(half_, {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, -1, 0}}, left);
    // Mirrored: its polygons look the other way around and are counter-clockwise all the same.
    right_ = scene_.add(half_, {{1, 0, 0}, {0, -1, 0}, {0, 0, 1}, {2, 1, 0}}, right);
  }

  /// Whether what is behind the seam is hidden.
  bool hides(const SceneOptions& options = {}) {
    scene_.update();
    return scene_.cull(Camera{}, options, view_).stats.hidden == 1;
  }

  Scene scene_;
  SceneView view_;
  std::shared_ptr<const OccluderMesh> half_ = [] {
    PolygonSoup soup;
    add(soup, {{0.5, 0, 0}, {0.5, 1, 0}, {0.5, 0, 1}});
    soup.see_through = {1};  // it hides nothing, but has a number
    add(soup, {{0, 0, -1}, {0, 0, 1}, {0, 1, 1}, {0, 1, -1}});
    return std::make_shared<OccluderMesh>(soup);
  }();
  OccluderId left_, right_;
  ObjectId behind_ = scene_.add(Aabb{{4, -0.1, -0.1}, {5, 0.1, 0.1}});
};

TEST(SceneWelds, HideWithoutASeam) {
  struct Case {
    const char* name;
    OccluderOptions left, right;
    bool is_hidden;
  };
  for (const Case& c :
       std::vector<Case>{{"none", {}, {}, false},
                         {"the same", {.weld = 3}, {.weld = 3}, true},
                         {"others", {.weld = 3}, {.weld = 4}, false},
                         {"one of them", {.weld = 3}, {}, false},
                         {"both move", {.moves = true, .weld = 3}, {.moves = true, .weld = 3}, true},
                         {"one moves", {.moves = true, .weld = 3}, {.weld = 3}, false},
                         {"layers", {.mask = 1, .weld = 3}, {.mask = 3, .weld = 3}, false},
                         {"one side", {.is_one_sided = true, .weld = 3}, {.is_one_sided = true, .weld = 3}, true},
                         {"a side of one", {.is_one_sided = true, .weld = 3}, {.weld = 3}, false}}) {
    EXPECT_EQ(Halves(c.left, c.right).hides(), c.is_hidden) << c.name;
  }
}

TEST(SceneWelds, ChangeWithTheirOccluders) {
  for (const bool moves : {false, true}) {
    const OccluderOptions options{.moves = moves, .weld = 3};
    Halves halves(options, options);
    Scene& scene = halves.scene_;
    EXPECT_TRUE(halves.hides());
    EXPECT_EQ(scene.occluders(), 2U);
    EXPECT_EQ(halves.view_.result().stats.occluders, 1U) << "a weld counts as one";
    EXPECT_FALSE(halves.hides({.margin = -1}));
    const Placement left{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, -1, 0}};
    scene.move(halves.left_, {left.x, left.y, left.z, {2, -1 - 0x1p-40, 0}});
    EXPECT_FALSE(halves.hides()) << "a seam";
    scene.move(halves.left_, left);
    EXPECT_TRUE(halves.hides());
    for (const OccluderId id : {halves.left_, halves.right_}) {
      scene.set_enabled(id, false);
      EXPECT_FALSE(halves.hides());
      scene.set_enabled(id, true);
      EXPECT_TRUE(halves.hides());
      scene.set_mask(id, 1);
      EXPECT_FALSE(halves.hides({.mask = 1})) << "other layers are another weld";
      EXPECT_FALSE(halves.hides({.mask = 2}));
      scene.set_mask(id, ~0U);
      EXPECT_TRUE(halves.hides());
      scene.replace(id, std::make_shared<OccluderMesh>(PolygonSoup()));
      EXPECT_FALSE(halves.hides());
      scene.replace(id, halves.half_);
      EXPECT_TRUE(halves.hides());
    }
    for (const OccluderId id : {halves.left_, halves.right_}) scene.set_mask(id, 1);
    EXPECT_TRUE(halves.hides({.mask = 1}));
    EXPECT_FALSE(halves.hides({.mask = 2}));
    for (const OccluderId id : {halves.left_, halves.right_}) scene.set_enabled(id, false);
    EXPECT_FALSE(halves.hides());
    for (const OccluderId id : {halves.left_, halves.right_}) scene.set_enabled(id, true);
    EXPECT_TRUE(halves.hides());
    scene.remove(halves.left_);
    EXPECT_FALSE(halves.hides());
    EXPECT_FALSE(scene.contains(halves.left_));
    scene.add(halves.half_, left, {.moves = moves, .mask = 1, .weld = 3});
    EXPECT_TRUE(halves.hides());
    scene.remove(halves.right_);
    EXPECT_FALSE(halves.hides());
  }
}

TEST(SceneWelds, AreNamedByTheirOccluders) {
  for (const bool is_one_sided : {false, true}) {
    const OccluderOptions options{.is_one_sided = is_one_sided, .weld = 3};
    Halves halves(options, options);
    ASSERT_TRUE(halves.hides());
    std::vector<ObjectWitness> witnesses;
    halves.scene_.append_witnesses(Camera{}, {}, halves.view_, witnesses);
    ASSERT_EQ(witnesses.size(), 1U);
    std::map<std::uint32_t, ObjectFate::Hiding> by;
    for (const ObjectFate::Hiding& hiding : witnesses[0].fate.by) by[hiding.occluder.slot()] = hiding;
    ASSERT_EQ(by.size(), 2U);
    for (const auto& [id, y] : {std::pair{halves.left_, -1.0}, std::pair{halves.right_, 1.0}}) {
      const ObjectFate::Hiding& hiding = by[id.slot()];
      EXPECT_EQ(hiding.occluder, id);
      EXPECT_EQ(hiding.polygon, 1U);
      ASSERT_EQ(hiding.corners.size(), 4U);
      // In the order of the mesh.
      const std::array<Vec3, 4> expected = y < 0 ? std::array<Vec3, 4>{{{2, -1, -1}, {2, -1, 1}, {2, 0, 1}, {2, 0, -1}}}
                                                 : std::array<Vec3, 4>{{{2, 1, -1}, {2, 1, 1}, {2, 0, 1}, {2, 0, -1}}};
      for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_EQ(hiding.corners[i].y, expected[i].y) << i;
        EXPECT_EQ(hiding.corners[i].z, expected[i].z) << i;
      }
    }
  }
}

TEST(SceneWelds, AnUpdateThatThrowsChangesNothing) {
  Halves halves({.weld = 3}, {.weld = 3});
  Scene& scene = halves.scene_;
  ASSERT_TRUE(halves.hides());
  scene.set_enabled(halves.left_, false);
  scene.remove(halves.behind_);
  std::fesetround(FE_UPWARD);
  EXPECT_THROW(scene.update(), std::runtime_error);
  std::fesetround(FE_TONEAREST);
  EXPECT_EQ(scene.cull(Camera{}, {}, halves.view_).stats.hidden, 1U) << "as before";
  const ObjectId behind = scene.add(Aabb{{4, -0.1, -0.1}, {5, 0.1, 0.1}});
  EXPECT_FALSE(halves.hides());
  EXPECT_EQ(halves.view_.result().drawn.size(), 1U);
  EXPECT_EQ(halves.view_.result().drawn[0].id, behind);
}

/// A weld is drawn by one object, in frames with that object.
TEST(SceneWelds, HideNothingWithoutTheirObject) {
  Halves halves({}, {});
  Scene& scene = halves.scene_;
  scene.remove(std::array{halves.left_, halves.right_});
  const ObjectId house = scene.add(Aabb{{1.5, -2, -2}, {2.5, 2, 2}}), other = scene.add(Aabb{{1.5, -2, -2}, {2.5, 2, 2}});
  const Placement left{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, -1, 0}}, right{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {2, 0, 0}};
  scene.add(halves.half_, left, {.object = house, .weld = 1});
  const OccluderId second = scene.add(halves.half_, right, {.object = house, .weld = 1});
  EXPECT_TRUE(halves.hides());
  scene.set_enabled(house, false);
  EXPECT_FALSE(halves.hides());
  scene.set_enabled(house, true);
  EXPECT_TRUE(halves.hides());
  scene.remove(second);
  scene.add(halves.half_, right, {.object = other, .weld = 1});
  EXPECT_FALSE(halves.hides()) << "two objects, two welds";
}

TEST(Scene, ResultsDoNotDependOnTheExecutor) {
  const auto town = std::make_shared<OccluderMesh>(random_town_of_houses(7, 1500));
  std::vector<std::vector<std::uint32_t>> drawn;
  std::vector<std::array<std::size_t, 5>> counts;
  for (const Executor& executor : some_executors()) {
    std::mt19937 random(kSeed);
    Scene scene;
    std::vector<Box> boxes;
    while (boxes.size() < 20000) boxes.push_back(random_box(random));
    std::vector<ObjectId> ids(boxes.size());
    scene.add(boxes, {}, ids);
    scene.add(town);
    scene.update(executor);
    for (std::size_t i = 0; i < ids.size(); i += 3) scene.remove(ids[i]);  // which leaves empty places in the groups
    scene.update(executor);
    SceneView view;
    drawn.emplace_back();
    counts.emplace_back();
    for (int i = 0; i < 5; ++i) {
      const SceneResult& result = scene.cull(random_camera(random), {.executor = &executor}, view);
      for (const DrawnObject& object : result.drawn) drawn.back().push_back(object.id.slot());
      const SceneStats& stats = result.stats;
      const std::array now{stats.drawn, stats.hidden, stats.out_of_view, stats.work.nodes_visited, stats.work.cover_tests};
      for (std::size_t k = 0; k < now.size(); ++k) counts.back()[k] += now[k];
    }
  }
  for (std::size_t i = 1; i < drawn.size(); ++i) {
    EXPECT_EQ(drawn[i], drawn[0]) << "executor " << i;
    EXPECT_EQ(counts[i], counts[0]) << "executor " << i;
  }
  EXPECT_GT(counts[0][0], 500U);
  EXPECT_GT(counts[0][1], 500U);
}

/// Twenty thousand boxes behind and between houses; every tenth in another layer.
struct TownScene {
  Scene scene;
  std::size_t in_layer = 0;

  TownScene() {
    std::mt19937 random(kSeed);
    for (int i = 0; i < 20000; ++i) {
      scene.add(random_box(random), {.moves = i % 3 == 0, .is_always_drawn = i % 100 == 1, .mask = i % 10 ? 1U : 2U});
      if (i % 10 != 0) ++in_layer;
    }
    scene.add(std::make_shared<OccluderMesh>(random_town_of_houses(7, 1500)));
    scene.update();
  }
};

TEST(Scene, AThreadThatRoundsOtherwiseDecidesNothing) {
  const TownScene town;
  SceneView view;
  std::size_t asked = 0, listed = 0;
  const Executor upwards(2, [&](std::size_t count, const Executor::Part& part) {
    rounding_upwards(2).run(count, part);
    asked += count;
    for (const WorkRunner::WorkItem& turn : memory_of(view).runner.items()) listed += turn.is_done ? 1 : 0;
  });
  const Camera camera;
  const SceneStats found = town.scene.cull(camera, {.executor = &upwards}, view).stats;
  EXPECT_GT(asked, 1U);
  EXPECT_EQ(listed, 0U);
  const SceneStats& expected = town.scene.cull(camera, {}, view).stats;
  EXPECT_EQ(found.drawn, expected.drawn);
  EXPECT_EQ(found.hidden, expected.hidden);
}

TEST(Scene, AFrameWhoseExecutorThrowsDrawsEverything) {
  const TownScene town;
  for (const bool is_first_run : {true, false}) {
    const Executor full(2, [&](std::size_t, const Executor::Part& part) {
      if (is_first_run) part(0);
      throw std::runtime_error("the queue is full");
    });
    SceneView view;
    EXPECT_THROW(town.scene.cull(Camera{}, {.mask = 1, .executor = &full}, view), std::runtime_error);
    std::set<std::uint32_t> drawn;
    for (const DrawnObject& object : view.result().drawn) drawn.insert(object.id.slot());
    EXPECT_EQ(drawn.size(), town.in_layer);
    EXPECT_EQ(view.result().drawn.size(), town.in_layer);
    EXPECT_EQ(view.result().stats.drawn, town.in_layer);
    EXPECT_EQ(view.result().stats.hidden + view.result().stats.out_of_view + view.result().stats.too_small, 0U);
    EXPECT_LT(town.scene.cull(Camera{}, {.mask = 1}, view).drawn.size(), town.in_layer);
  }
}

/// The farther a view reaches, the farther out its half-spaces are.
TEST(Scene, AViewReachesAsFarAsWhatIsThere) {
  const std::vector<Box> tile{Aabb{{4, 4, 4}, {5, 5, 5}}, Aabb{{6, 4, 4}, {7, 5, 5}}, Aabb{{4e6, 4, 4}, {5e6, 5, 5}}};
  const auto offsets = [](const Scene& scene) {
    SceneView view;
    std::vector<double> of;
    for (const HalfSpace& h : scene.cull(Camera{}, {}, view).view) of.push_back(h.offset);
    return of;
  };
  Scene near;
  near.add(tile[0]);
  near.add(tile[1]);
  near.update();
  Scene scene;
  std::vector<ObjectId> ids(tile.size());
  scene.add(tile, {}, ids);
  scene.update();
  EXPECT_NE(offsets(scene), offsets(near));
  scene.remove(ids[2]);
  scene.update();
  EXPECT_EQ(offsets(scene), offsets(near));
}

/// Groups that are joined, or built anew without their empty places, leave theirs to groups that come. Each does so once,
/// however often it is noted as small or as loose: two groups in one place would be one.
TEST(Scene, NoTwoGroupsTakeThePlaceOfOne) {
  std::mt19937 random(kSeed);
  Scene scene;
  std::set<std::uint32_t> there;  // slots
  const auto add_tile = [&](std::size_t count) {
    std::vector<Box> boxes;
    while (boxes.size() < count) boxes.push_back(random_box(random));
    std::vector<ObjectId> ids(count);
    scene.add(boxes, {}, ids);
    for (const ObjectId id : ids) there.insert(id.slot());
    scene.update();
    return ids;
  };
  SceneView view;
  const auto expect_all_drawn = [&] {
    const Camera from_above{
        .eye = {0, 0, 99}, .target = {0, 0, 0}, .up = {0, 1, 0}, .projection = Projection::orthographic, .height = 200};
    std::set<std::uint32_t> drawn;
    for (const DrawnObject& object : scene.cull(from_above, {}, view).drawn) drawn.insert(object.id.slot());
    ASSERT_EQ(drawn, there);
  };
  std::vector<std::vector<ObjectId>> small;
  for (int i = 0; i < 12; ++i) small.push_back(add_tile(40));
  // All become loose, more than an update builds anew. Those that it does are noted as small a second time; so many are
  // then that all are joined, while the others still wait.
  for (const std::vector<ObjectId>& tile : small) {
    for (std::size_t i = 0; i < 30; ++i) {
      scene.remove(tile[i]);
      there.erase(tile[i].slot());
    }
  }
  scene.update();
  expect_all_drawn();
  for (int i = 0; i < 16; ++i) {
    add_tile(70);
    expect_all_drawn();
  }
}

/// A large group may take the place of a small one that is still to be joined with others. It is not joined.
TEST(SceneObjects, GroupsStaySmallEnoughToBeBuiltAnew) {
  std::mt19937 random(kSeed);
  SceneNumber number;
  SceneObjects objects(number);
  const auto add = [&](std::size_t count) {
    std::vector<ObjectId> ids;
    while (ids.size() < count) ids.push_back(objects.add(SceneBox::of(random_box(random)), {}));
    objects.update({});
    return ids;
  };
  std::vector<std::vector<ObjectId>> small;
  for (int i = 0; i < 12; ++i) small.push_back(add(40));
  for (const std::vector<ObjectId>& tile : small) {
    for (const ObjectId id : tile) objects.remove(id);
  }
  objects.update({});
  add(20000);
  for (int i = 0; i < 4; ++i) add(10);
  EXPECT_EQ(objects.seen_size(), 20040U);
  for (std::uint32_t i = 0; i < objects.groups().size(); ++i) EXPECT_LE(objects.group(i).size(), 1024U);
}

/// Scene::object_bytes() says how many.
TEST(Scene, ObjectsTakeFewBytes) {
  struct Way {
    bool is_oriented, moves, is_at_once;
  };
  constexpr std::array<Way, 5> kWays{
      {{true, false, true}, {true, false, false}, {true, true, false}, {false, false, true}, {false, true, true}}};
  constexpr std::array<std::size_t, 5> kCounts{100, 3000, 20000, 33000, 50000};
  const auto oriented = [](std::mt19937& random) -> Box {
    const double angle = uniform(random, 0, 6.28), c = std::cos(angle), s = std::sin(angle);
    return Obb{random_vector(random, -500, 500), {{{c, s, 0}, {-2 * s, 2 * c, 0}, {0, 0, 1}}}};
  };
  for (const Way& way : kWays) {
    for (const std::size_t count : std::span(kCounts).first(unless_sanitized(kCounts.size(), std::size_t{3}))) {
      std::mt19937 random(kSeed);
      std::vector<Box> boxes;
      while (boxes.size() < count) boxes.push_back(oriented(random));
      if (!way.is_oriented) {
        for (Box& box : boxes) box = outer_box(box);
      }
      Scene scene;
      std::vector<ObjectId> ids(count);
      const ObjectOptions options{.moves = way.moves};
      if (way.is_at_once) scene.add(boxes, options, ids);
      for (std::size_t i = 0; i < count && !way.is_at_once; ++i) {
        ids[i] = scene.add(boxes[i], options);
        if (i % 1000 == 0) scene.update();
      }
      scene.update();
      const std::size_t each = way.moves ? 240 : way.is_oriented ? 122 : 110;
      const std::size_t most = each * count + 180000;
      EXPECT_LE(scene.object_bytes(), most) << count << (way.is_oriented ? " oriented" : "") << (way.moves ? " moving" : "");
      for (int i = 0; i < 3; ++i) {
        scene.move(ids, boxes);
        scene.update();
      }
      EXPECT_LE(scene.object_bytes(), way.is_at_once ? most : most * 3 / 2) << count << ", moved";
    }
  }
}

TEST(Scene, MemoryDoesNotGrowWithWhatHasGone) {
  std::mt19937 random(kSeed);
  Scene scene;
  std::vector<std::vector<ObjectId>> tiles;
  std::size_t settled = 0;
  for (int i = 0; i < 400; ++i) {
    std::vector<Box> boxes;
    for (std::uint32_t k = 0; k < 1 + random() % 40; ++k) boxes.push_back(random_box(random));
    tiles.emplace_back(boxes.size());
    scene.add(boxes, {}, tiles.back());
    if (tiles.size() > 50) {
      const std::size_t gone = random() % tiles.size();
      for (const ObjectId id : tiles[gone]) scene.remove(id);
      tiles.erase(tiles.begin() + static_cast<std::ptrdiff_t>(gone));
    }
    scene.update();
    if (i == 200) settled = scene.object_bytes();
  }
  EXPECT_LE(scene.object_bytes(), settled * 3 / 2);
}

/// What became of objects is asked of a frame. A later update, or another scene, would answer for no frame at all.
TEST(Scene, TellsWhyOfItsOwnFrameAlone) {
  Scene scene, other;
  const std::array ids{scene.add(Box(kernel::Aabb{{5, -1, -1}, {6, 1, 1}}))};
  scene.update();
  other.update();
  SceneView view;
  const auto why = [&] { return refusal([&] { static_cast<void>(scene.why(Camera{}, {}, view, ids)); }); };
  const auto prove = [&] {
    std::vector<ObjectWitness> witnesses;
    return refusal([&] { scene.append_witnesses(Camera{}, {}, view, witnesses); });
  };
  const std::string stale = "the view's last frame is not of this scene as the last update() left it";
  EXPECT_EQ(why(), stale) << "no frame";
  scene.cull(Camera{}, {}, view);
  EXPECT_EQ(why(), "");
  EXPECT_EQ(prove(), "");
  scene.move(ids[0], Box(kernel::Aabb{{-6, -1, -1}, {-5, 1, 1}}));
  EXPECT_EQ(why(), "") << "views do not see it yet";
  scene.update();
  EXPECT_EQ(why(), stale);
  EXPECT_EQ(prove(), stale);
  scene.cull(Camera{}, {}, view);
  EXPECT_EQ(why(), "");
  other.cull(Camera{}, {}, view);
  EXPECT_EQ(why(), stale);
  EXPECT_EQ(prove(), stale);
}

}  // namespace scene_test
