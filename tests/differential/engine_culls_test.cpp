// SPDX-License-Identifier: MIT
// What an engine culls, by its matrix and in its scene, is proved by the oracle from what the culler names.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <memory>
#include <random>
#include <set>
#include <vector>

#include "cases/to_oracle.h"
#include "culler/frames.h"
#include "culler/scenes.h"
#include "differential/cull_judge.h"
#include "frame/culler_access.h"
#include "occlude/culler/culler.h"
#include "occlude/culler/scene.h"
#include "occlude/oracle/cover.h"
#include "occlude/oracle/questions.h"
#include "proof/camera_picture.h"
#include "sanitized.h"
#include "seed.h"

namespace engine_culls_test {

using namespace occlude;
using namespace occlude::culler;
using cases::to_oracle;
using glm::dvec3;

constexpr int kFrames = unless_sanitized(8, 2);

CullOptions options_of(Method method) { return {.method = method, .cover = {.width = 256, .height = 144}}; }

std::size_t hidden_by(const CullResult& frame) { return frame.stats.shadow_culled_polygons; }

TEST(CullsByMatrix, AreProvedByTheOracle) {
  std::mt19937 random(seed_of(1));
  std::array<std::size_t, 3> hidden{};
  for (int i = 0; i < kFrames; ++i) {
    const Culler culler = small_leaves(random_town_of_houses(static_cast<std::uint32_t>(random()), 300));
    MatrixCamera matrix = matrix_of(random_camera(random));
    ASSERT_EQ(fault(matrix), "");
    const auto judge = [&](const CullOptions& options, std::size_t way) {
      const CullResult frame = culler.cull(matrix, options);
      hidden[way] += hidden_by(frame);
      EXPECT_EQ(fuzz::fault_of(culler, matrix, options, frame), "") << "seed " << seed_of(1) << ", frame " << i;
    };
    judge(options_of(Method::frusta), 0);
    judge(options_of(Method::cover), 1);
    matrix.eyes.radius = 0.1;
    judge(options_of(Method::cover), 2);
  }
  EXPECT_GT(*std::ranges::min_element(hidden), 50U);
  EXPECT_LT(hidden[2], hidden[1]) << "several eyes hide less";
}

/// What is claimed of one eye is not proved of another, nor what is claimed of one eye of several.
TEST(CullsByMatrix, AreNotProvedOfAnotherMatrix) {
  const Culler culler = small_leaves(random_town_of_houses(3, 300));
  std::mt19937 random(3);
  std::size_t refused = 0, refused_of_several = 0;
  for (int i = 0; i < kFrames; ++i) {
    Camera camera = random_camera(random);
    camera.projection = Projection::perspective;
    for (const Method method : {Method::frusta, Method::cover}) {
      const CullOptions options = options_of(method);
      const CullResult frame = culler.cull(matrix_of(camera), options);
      Camera aside = camera;
      aside.eye += dvec3(0, 0, 2);
      aside.target += dvec3(0, 0, 2);
      refused += fuzz::fault_of(culler, matrix_of(aside), options, frame).empty() ? 0 : 1;
      MatrixCamera several = matrix_of(camera);
      several.eyes.radius = 1;
      if (method == Method::cover) refused_of_several += fuzz::fault_of(culler, several, options, frame).empty() ? 0 : 1;
    }
  }
  EXPECT_EQ(refused, 2 * kFrames);
  EXPECT_EQ(refused_of_several, kFrames);
}

/// The numbers of the matrix are so short that the eye is known exactly, though the culler finds it by rounding. It is
/// proved from there.
TEST(CullsByMatrix, AreProvedFromTheExactEye) {
  std::mt19937 random(seed_of(1));
  const auto shortened = [](double number) { return std::ldexp(std::round(std::ldexp(number, 20)), -20); };
  const auto some = [&](double most) { return shortened(uniform(random, -most, most)); };
  std::array<std::size_t, 2> proved{};
  int inexact = 0;
  for (int i = 0; i < 2 * kFrames; ++i) {
    const Culler culler = small_leaves(random_town_of_houses(static_cast<std::uint32_t>(random()), 300));
    const dvec3 eye(some(45), some(45), shortened(uniform(random, 0.5, 4)));
    const double turn = uniform(random, 0, 6);
    const dvec3 forward(shortened(std::cos(turn)), shortened(std::sin(turn)), some(0.2));
    const dvec3 right(-forward.y + some(0.1), forward.x, some(0.1)), up(some(0.1), some(0.1), 1.5);
    std::array<double, 16> rows{};
    const auto set = [&](std::size_t row, const dvec3& normal, double constant) {
      for (int k = 0; k < 3; ++k) rows[4 * row + static_cast<std::size_t>(k)] = normal[k];
      rows[4 * row + 3] = constant - glm::dot(normal, eye);  // exact: 21 bits times 26, three times
    };
    set(0, right, 0);
    set(1, up, 0);
    set(2, forward, -0.125);
    set(3, forward, 0);
    const MatrixCamera matrix = MatrixCamera::from_rows(rows.data(), ClipDepth::zero_to_w);
    ASSERT_EQ(fault(matrix), "");
    inexact += matrix.eye() == eye ? 0 : 1;
    const SoupView& soup = culler.hierarchy().soup();
    const auto polygon = [&](std::span<const std::uint32_t> loop) {
      oracle::Loop result;
      for (const std::uint32_t v : loop) result.push_back({soup.vertices[v].x, soup.vertices[v].y, soup.vertices[v].z});
      return result;
    };
    const oracle::Viewpoint exact{{eye.x, eye.y, eye.z}};
    const CullResult by_cover = culler.cull(matrix, options_of(Method::cover));
    std::vector<CoverWitness> covers;
    culler.append_covers(by_cover, matrix, options_of(Method::cover), 60, covers);
    const oracle::Aabb all = to_oracle(culler.hierarchy().nodes()[0].box);
    for (const CoverWitness& cover : covers) {
      std::vector<oracle::Loop> polygons;
      for (const std::uint32_t p : cover.polygons) polygons.push_back(polygon(soup.loop(p)));
      ASSERT_EQ(oracle::relation_to_cover(exact, polygons, to_oracle(cover.box), proof::drawn(matrix, all)).relation,
                oracle::Relation::inside)
          << "seed " << seed_of(1) << ", frame " << i;
    }
    proved[0] += covers.size();
    const CullOptions by_frusta = options_of(Method::frusta);
    const CullResult frame = culler.cull(matrix, by_frusta);
    for (const Culled& culled : frame.culled) {
      if (culled.by != Culled::By::shadow) continue;
      const Occluder& occluder = frame.occluders[culled.index];
      oracle::Shadow shadow(exact, to_oracle(occluders_of(culler).geometry(occluder.index)),
                            to_oracle(by_frusta.shadow_near, {occluder.frustum}));
      ASSERT_EQ(shadow.refute_cull(to_oracle(culler.hierarchy().volume(culled.node))), "")
          << "seed " << seed_of(1) << ", frame " << i;
      ++proved[1];
    }
  }
  EXPECT_GT(proved[0], 50U);
  EXPECT_GT(proved[1], 20U);
  EXPECT_GT(inexact, 0) << "the eye is to be one that rounds";
}

/// A scene of boxes in a town that is one occluder, and a house that is moved to where it hides.
class CullsOfAScene : public testing::Test {
 protected:
  CullsOfAScene() {
    for (int i = 0; i < 150; ++i) {
      const dvec3 low(uniform(random_, -45, 45), uniform(random_, -45, 45), uniform(random_, 0, 3));
      const kernel::Vec3 end{low.x + uniform(random_, 0.1, 1), low.y + uniform(random_, 0.1, 1), low.z + 0.5};
      Box box = kernel::Aabb{{low.x, low.y, low.z}, end};
      if (i % 3 == 0) box = kernel::Obb{{low.x, low.y, low.z}, {{{0.3, 0.2, 0}, {-0.2, 0.3, 0}, {0, 0, 0.4}}}};
      boxes_.push_back(box);
    }
    ids_.resize(boxes_.size());
    scene_.add(boxes_, {}, ids_);
    scene_.add(std::make_shared<OccluderMesh>(random_town_of_houses(seed_of(1), 300)));
    PolygonSoup house;
    house.add_box({-2, -2, 0}, {2, 2, 6});
    const OccluderId moved = scene_.add(std::make_shared<OccluderMesh>(house));
    scene_.move(moved, {.x = {0.8, 0.6, 0}, .y = {-0.6, 0.8, 0}, .origin = {4, 3, 0}});
    scene_.update();
  }

  struct Proofs {
    std::size_t hidden = 0, out_of_view = 0, unproved = 0;
  };

  /// Proves each cull of a frame, from each of the eyes. With `forget` half of the polygons that hide are left out.
  template <class AnyCamera>
  Proofs prove(const AnyCamera& camera, const SceneOptions& options, const std::vector<oracle::Viewpoint>& eyes,
               bool forget = false) {
    const SceneResult& result = scene_.cull(camera, options, view_);
    std::set<std::uint32_t> left;
    for (const ObjectId id : ids_) left.insert(id.slot());
    for (const DrawnObject& object : result.drawn) left.erase(object.id.slot());
    std::vector<ObjectWitness> witnesses;
    scene_.append_witnesses(camera, options, view_, witnesses);
    Proofs proofs;
    for (const auto& [object, box, fate] : witnesses) {
      EXPECT_EQ(left.erase(object.slot()), 1U) << "it is drawn, or proved twice";
      if (fate.reason == ObjectFate::Reason::out_of_view) {
        ++proofs.out_of_view;
        const auto& [normal, offset] = result.view[fate.plane];
        const std::array<double, 4> plane{normal.x, normal.y, normal.z, offset};
        EXPECT_EQ(oracle::refute_view_cull(plane, to_oracle(box)), "");
        EXPECT_FALSE(proof::may_draw_beyond(plane, camera, kExtent));
        continue;
      }
      EXPECT_EQ(fate.reason, ObjectFate::Reason::hidden);
      ++proofs.hidden;
      std::vector<oracle::Loop> polygons;
      for (const ObjectFate::Hiding& hiding : fate.by) polygons.push_back(to_oracle(hiding.corners));
      if (forget) polygons.resize(polygons.size() / 2);
      const bool is_proved = std::ranges::all_of(eyes, [&](const oracle::Viewpoint& eye) {
        return oracle::relation_to_cover(eye, polygons, to_oracle(box), proof::drawn(camera, kExtent)).relation ==
               oracle::Relation::inside;
      });
      proofs.unproved += is_proved ? 0 : 1;
    }
    EXPECT_TRUE(left.empty()) << "each object is drawn, or the cull of it proved";
    EXPECT_EQ(witnesses.size(), result.stats.hidden + result.stats.out_of_view);
    return proofs;
  }

  static constexpr oracle::Aabb kExtent{{-60, -60, -1}, {75, 75, 15}};
  std::mt19937 random_{seed_of(1)};
  Scene scene_;
  std::vector<Box> boxes_;
  std::vector<ObjectId> ids_;
  SceneView view_;
};

TEST_F(CullsOfAScene, AreProvedByTheOracle) {
  std::array<Proofs, 3> all{};
  const auto add = [&](std::size_t way, const Proofs& proofs) {
    all[way].hidden += proofs.hidden;
    all[way].out_of_view += proofs.out_of_view;
    all[way].unproved += proofs.unproved;
  };
  for (int i = 0; i < 2 * kFrames; ++i) {
    const Camera camera = random_camera(random_);
    SceneOptions options;
    if (i % 2 == 1) options.margin = 1.0 / 512;
    add(0, prove(camera, options, {proof::viewpoint_of(camera)}));
    MatrixCamera matrix = matrix_of(camera);
    const oracle::Viewpoint middle = proof::viewpoint_of(matrix);
    add(1, prove(matrix, options, {middle}));
    matrix.eyes.radius = 0.1;
    std::vector<oracle::Viewpoint> eyes{middle};
    for (std::size_t axis = 0; axis < 3 && !middle.at_infinity; ++axis) {
      eyes.push_back(middle);
      eyes.back().value[axis] += axis == 1 ? 0.0999 : -0.0999;
    }
    add(2, prove(matrix, options, eyes));
  }
  for (std::size_t way = 0; way < all.size(); ++way) {
    EXPECT_GT(all[way].hidden, 50U) << way;
    EXPECT_GT(all[way].out_of_view, 500U) << way;
    EXPECT_EQ(all[way].unproved, 0U) << way << ", seed " << seed_of(1);
  }
}

TEST_F(CullsOfAScene, AreNotProvedByLess) {
  std::size_t hidden = 0, unproved = 0;
  for (int i = 0; i < kFrames; ++i) {
    const Camera camera = random_camera(random_);
    const Proofs proofs = prove(camera, {}, {proof::viewpoint_of(camera)}, true);
    hidden += proofs.hidden;
    unproved += proofs.unproved;
  }
  EXPECT_GT(unproved, 10U) << "of " << hidden;
}

}  // namespace engine_culls_test
