// SPDX-License-Identifier: MIT
// Batches of every size give the same answers as the tests of single boxes, on every instruction set of this machine.
#include "occlude/kernel/batch.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "cases/ask.h"
#include "occlude/fuzz/cases.h"
#include "occlude/fuzz/random.h"
#include "occlude/kernel/overlap.h"
#include "only_target.h"

namespace batch_test {

using namespace occlude;
using namespace occlude::kernel;
using fuzz::Family;

/// Sizes below, at and above whole vectors, and around the 1024 tests after which the undecided ones are finished.
constexpr std::array<std::size_t, 11> kSizes{0, 1, 2, 3, 7, 8, 9, 1023, 1024, 1025, 3000};
constexpr std::size_t kMost = kSizes.back();

constexpr std::array kBoundaries{NearBoundary::closed, NearBoundary::open};

constexpr std::array kBoxFamilies{
    Family::random,        Family::lattice,       Family::face_touch, Family::ray_touch,     Family::near_touch,
    Family::corner_touch,  Family::ulp_lattice,   Family::flat_box,   Family::needle_box,    Family::point_box,
    Family::eye_in_box,    Family::edge_crossing, Family::sliver,     Family::shared_vertex, Family::axis_aligned_faces,
    Family::polytope_near, Family::polytope_box,  Family::decimal,    Family::many_sided};

/// These families have triangles, up to 64 sides, polytopes with one and several near planes, near and far eyes, and
/// directions.
constexpr std::array kFrustumFamilies{
    Family::lattice,       Family::sliver,     Family::ulp_lattice,  Family::many_sided,         Family::random,
    Family::near_touch,    Family::decimal,    Family::wide_frustum, Family::orthographic_touch, Family::orthographic,
    Family::polytope_near, Family::far_offset, Family::polytope_box, Family::polytope_many,      Family::edge_crossing};

/// Legal boxes, from each of these families in turn.
std::vector<Aabb> boxes_of(std::span<const Family> families, std::size_t count) {
  std::vector<Aabb> boxes;
  for (std::uint64_t i = 0; boxes.size() < count; ++i) {
    const Aabb box = std::get<Aabb>(fuzz::make_case(families[i % families.size()], i).box);
    if (kernel::check(box) == Refusal::none) boxes.push_back(box);
  }
  return boxes;
}

/// Frusta, from each of these families in turn, and the boxes that they are tested with.
struct Scenes {
  std::vector<ShadowFrustum> frusta;
  std::vector<Aabb> boxes;
};

Scenes scenes_of(std::span<const Family> families, std::size_t count) {
  Scenes scenes;
  for (std::uint64_t i = 0; scenes.frusta.size() < count; ++i) {
    const fuzz::Case c = fuzz::make_case(families[i % families.size()], i);
    auto made = fuzz::make_frustum(c);
    if (!made.frustum) continue;
    scenes.frusta.push_back(std::move(*made.frustum));
    scenes.boxes.push_back(std::get<Aabb>(c.box));
  }
  return scenes;
}

/// Boxes with a corner at a corner of the silhouette. It lies on two sides of the shadow, so the filter leaves nearly all.
std::vector<Aabb> touching_boxes(const ShadowFrustum& frustum) {
  std::vector<Aabb> boxes;
  for (const Vec3& v : frustum.silhouette()) {
    for (unsigned octant = 0; octant < 8; ++octant) {
      Aabb box{v, v};
      for (int k = 0; k < 3; ++k) (octant >> k & 1U ? box.max : box.min)[k] += (octant >> k & 1U ? 1 : -1) * (k + 1);
      boxes.push_back(box);
    }
  }
  return boxes;
}

/// Shadows of triangles of whole numbers with a corner at v, from random viewpoints. Boxes at v touch them.
std::vector<ShadowFrustum> frusta_about(const Vec3& v, std::size_t count) {
  fuzz::Random random(1);
  const auto whole = [&] {
    const double x = random.integer(-9, 9), y = random.integer(-9, 9), z = random.integer(-9, 9);
    return Vec3{x, y, z};
  };
  std::vector<ShadowFrustum> frusta;
  while (frusta.size() < count) {
    const Vec3 eye = whole(), a = whole(), b = whole();
    auto made = ShadowFrustum::make(Viewpoint::eye(eye), std::array{v, a, b}, Near::surface);
    if (made.frustum) frusta.push_back(std::move(*made.frustum));
  }
  return frusta;
}

/// Replaces every third element of `all` by the elements of `others` in turn.
template <class T>
void mix_in(std::vector<T>& all, const std::vector<T>& others) {
  for (std::size_t i = 0; i < all.size(); i += 3) all[i] = others[i / 3 % others.size()];
}

constexpr auto kCanary = static_cast<Relation>(77);

/// Runs `batch(answers)` with room for exactly the expected answers, and checks that nothing is written beyond them.
template <class Batch>
void expect_answers(std::span<const Decision> expected, const Batch& batch) {
  std::vector<Relation> written(expected.size() + 64, kCanary);
  batch(std::span(written).first(expected.size()));
  for (std::size_t i = 0; i < expected.size(); ++i) {
    ASSERT_EQ(static_cast<int>(written[i]), static_cast<int>(expected[i].relation)) << i << " of " << expected.size();
  }
  const auto beyond = std::span(written).subspan(expected.size());
  ASSERT_TRUE(std::ranges::all_of(beyond, [](Relation r) { return r == kCanary; })) << expected.size();
}

/// Checks that the batches are varied enough to test anything: they have all answers, and tests that the filter leaves.
class Variety {
 public:
  void add(std::span<const Decision> decisions) {
    for (const auto& [relation, stage] : decisions) {
      ++relations_[static_cast<std::size_t>(relation)];
      left_ += stage == Stage::exact;
    }
  }
  void expect_all() const {
    for (const std::size_t count : relations_) EXPECT_GT(count, 100U);
    EXPECT_GT(left_, 1000U);
  }

 private:
  std::array<std::size_t, 3> relations_{};
  std::size_t left_ = 0;
};

class Batch : public testing::TestWithParam<std::int64_t> {};

TEST_P(Batch, BoxesAgainstAFrustum) {
  const OnlyTarget target(GetParam());
  std::vector<Aabb> boxes = boxes_of(kBoxFamilies, kMost);
  Variety variety;
  for (const ShadowFrustum& frustum : scenes_of(kFrustumFamilies, kFrustumFamilies.size()).frusta) {
    mix_in(boxes, touching_boxes(frustum));
    for (const NearBoundary near : kBoundaries) {
      std::vector<Decision> overlaps, by_planes;
      for (const Aabb& box : boxes) {
        overlaps.push_back(overlap_certified(frustum, box, near));
        by_planes.push_back(conservative_certified(frustum, box, near));
      }
      variety.add(overlaps);
      for (const std::size_t size : kSizes) {
        const BoxBatch batch{std::span(boxes).first(size)};
        expect_answers(std::span(overlaps).first(size),
                       [&](std::span<Relation> answers) { overlap_certified(frustum, batch, near, answers); });
        expect_answers(std::span(by_planes).first(size),
                       [&](std::span<Relation> answers) { conservative_certified(frustum, batch, near, answers); });
      }
    }
  }
  variety.expect_all();
}

TEST_P(Batch, FrustaAgainstABox) {
  const OnlyTarget target(GetParam());
  const Vec3 corner{2, 1, 1};
  Scenes scenes = scenes_of(kFrustumFamilies, kMost);
  mix_in(scenes.frusta, frusta_about(corner, 100));
  scenes.boxes.resize(kFrustumFamilies.size());
  scenes.boxes.insert(scenes.boxes.end(), {{corner, {3, 3, 4}}, {{-1, 0, 1}, corner}, {corner, corner}});
  Variety variety;
  for (const Aabb& box : scenes.boxes) {
    for (const NearBoundary near : kBoundaries) {
      std::vector<Decision> overlaps, by_planes;
      for (const ShadowFrustum& frustum : scenes.frusta) {
        overlaps.push_back(overlap_certified(frustum, box, near));
        by_planes.push_back(conservative_certified(frustum, box, near));
      }
      variety.add(overlaps);
      for (const std::size_t size : kSizes) {
        const FrustumBatch batch{std::span(scenes.frusta).first(size)};
        expect_answers(std::span(overlaps).first(size),
                       [&](std::span<Relation> answers) { overlap_certified(batch, box, near, answers); });
        expect_answers(std::span(by_planes).first(size),
                       [&](std::span<Relation> answers) { conservative_certified(batch, box, near, answers); });
      }
    }
  }
  variety.expect_all();
}

TEST_P(Batch, EveryFrustumAgainstTheBoxPutToIt) {
  // A frustum rarely touches the box of another case. Here touching is the rule.
  const OnlyTarget target(GetParam());
  const Scenes scenes = scenes_of(kFrustumFamilies, 3000);
  Variety variety;
  for (std::size_t i = 0; i < scenes.frusta.size(); ++i) {
    const std::span frustum(&scenes.frusta[i], 1);
    const std::span box(&scenes.boxes[i], 1);
    for (const NearBoundary near : kBoundaries) {
      const std::array expected{overlap_certified(frustum[0], box[0], near)};
      variety.add(expected);
      expect_answers(expected,
                     [&](std::span<Relation> answers) { overlap_certified(frustum[0], BoxBatch(box), near, answers); });
      expect_answers(expected,
                     [&](std::span<Relation> answers) { overlap_certified(FrustumBatch(frustum), box[0], near, answers); });
    }
  }
  variety.expect_all();
}

TEST_P(Batch, ProfilesHaveABoundOfTheirOwn) {
  // The eye is nearly in the plane of the triangle, so all planes of the frustum have offsets of nearly zero. The plane of
  // the profile through the nearest edge and parallel to y has a larger one. The box reaches this edge and no farther.
  // Rounding changes the value of that plane there by 1.05 times what the bound of the frustum's own planes allows for.
  const OnlyTarget target(GetParam());
  const Vec3 eye{0x1.99d1ff9a4acfcp-42, 0, -0x1.53f5255fdfa0ep-41};
  const std::array triangle{Vec3{0x1.fcdcb38c565d3p-1, 0x1.24babd9910a26p-22, 0x1.b4c78022b11a4p-1},
                            Vec3{0x1.b2f7456b9168p-1, 0x1.24badb79487b9p-22, 0x1.fa007e7d859dbp-1},
                            Vec3{0x1.eab049658976p+0, 0x1.24bae87f1a968p-22, 0x1.ebdd85764872ap+0}};
  const Aabb box{{-0x1.d588e0e9cb075p-1, -0x1.4b5f4b0a44289p-1, -0x1.bccc9acbdae18p-1},
                 {0x1.d83cecc1bd784p-1, 0x1.4b5f4b0a44289p-1, 0x1.d7164de12ce11p-1}};
  const ShadowFrustum frustum = ShadowFrustum::make(Viewpoint::eye(eye), triangle, Near::surface).frustum.value();
  const std::array expected{overlap_certified(frustum, box)};
  EXPECT_EQ(expected[0].relation, Relation::partial);
  expect_answers(expected, [&](std::span<Relation> answers) {
    overlap_certified(frustum, BoxBatch(std::span(&box, 1)), NearBoundary::closed, answers);
  });
}

INSTANTIATE_TEST_SUITE_P(Targets, Batch, testing::ValuesIn(hwy::SupportedAndGeneratedTargets()),
                         [](const auto& target) { return std::string(hwy::TargetName(target.param)); });

TEST(BoxBatch, HoldsItsBoxes) {
  const std::vector<Aabb> boxes = boxes_of(kBoxFamilies, 100);
  const BoxBatch batch(boxes);
  ASSERT_EQ(batch.size(), boxes.size());
  Aabb bounds = boxes[0];
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    EXPECT_EQ(batch.box(i), boxes[i]);
    for (int k = 0; k < 3; ++k) {
      bounds.min[k] = std::min(bounds.min[k], boxes[i].min[k]);
      bounds.max[k] = std::max(bounds.max[k], boxes[i].max[k]);
    }
  }
  EXPECT_EQ(batch.bounds(), bounds);
  EXPECT_EQ(BoxBatch({}).bounds(), Aabb{});
}

}  // namespace batch_test
