// SPDX-License-Identifier: MIT
// The degenerate positions, exact copies of them, and what only a test of its own can say.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "cases/ask.h"
#include "kernel/degenerate_rows.h"
#include "kernel/exact_copies.h"
#include "occlude/kernel/overlap.h"

namespace {

using namespace occlude;
using namespace occlude::kernel;
using Loop = std::vector<Vec3>;

ShadowFrustum frustum(const fuzz::Case& scene) {
  auto result = fuzz::make_frustum(scene);
  EXPECT_EQ(to_string(result.refusal), to_string(Refusal::none));
  return *result.frustum;
}

Decision decide(const fuzz::Case& scene) {
  EXPECT_EQ(fuzz::check(scene.box), Refusal::none);
  return fuzz::overlap(frustum(scene), scene.box);
}

class Degenerate : public testing::TestWithParam<DegenerateRow> {};

TEST_P(Degenerate, AnswerAndStage) {
  const DegenerateRow& row = GetParam();
  const Decision decision = decide(row.scene);
  EXPECT_EQ(to_string(decision.relation), to_string(row.relation));
  EXPECT_EQ(decision.stage, row.stage);
}

TEST_P(Degenerate, ConservativeIsTheSameOrPartial) {
  const DegenerateRow& row = GetParam();
  const Relation relation = fuzz::conservative(frustum(row.scene), row.scene.box).relation;
  if (row.relation == Relation::outside && relation == Relation::partial) return;
  EXPECT_EQ(to_string(relation), to_string(row.relation));
}

/// Checks the answer for those copies that are exact and returns how many they are.
std::size_t check_copies(const DegenerateRow& row, const std::vector<Similarity>& similarities) {
  std::size_t count = 0;
  for (const Similarity& similarity : similarities) {
    const auto image = copy(row.scene, similarity);
    if (!image) continue;
    EXPECT_EQ(to_string(decide(*image).relation), to_string(row.relation)) << similarity.name;
    ++count;
  }
  return count;
}

TEST_P(Degenerate, ExactCopiesAgree) {
  const DegenerateRow& row = GetParam();
  EXPECT_EQ(check_copies(row, permutations_and_mirrors()), permutations_and_mirrors().size());
  // Rows at the ends of the legal range can go one way only.
  EXPECT_GE(check_copies(row, scalings()), 2U);
  // Not every row has an exact translation; below they are counted.
  check_copies(row, translations());
}

std::optional<Vec3> exact_middle(const Vec3& a, const Vec3& b) {
  Vec3 middle;
  for (int k = 0; k < 3; ++k) {
    const double sum = a[k] + b[k];
    if (sum - a[k] != b[k] || sum - b[k] != a[k]) return std::nullopt;
    middle[k] = sum / 2;
  }
  return middle;
}

/// Ways to write a loop that leave its first vertex the first. Where several vertices are equally far the near plane of
/// `farthest` is the same only if it is the first of them in both; so it is in all rows, of which none has a tie without it.
std::vector<Loop> other_loops(const Loop& loop) {
  Loop reversed(loop.rbegin(), loop.rend());
  std::rotate(reversed.begin(), reversed.end() - 1, reversed.end());
  Loop repeated, with_middles;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3 &a = loop[i], &b = loop[(i + 1) % loop.size()];
    repeated.insert(repeated.end(), 1 + i % 3, a);
    with_middles.push_back(a);
    if (const auto between = exact_middle(a, b)) with_middles.push_back(*between);
  }
  return {reversed, repeated, with_middles};
}

TEST_P(Degenerate, LoopMayTurnEitherWayAndCarryNeedlessVertices) {
  const DegenerateRow& row = GetParam();
  const auto* const loop = std::get_if<Loop>(&row.scene.occluder);
  if (!loop) return;
  for (const Loop& other : other_loops(*loop)) {
    fuzz::Case scene = row.scene;
    scene.occluder = other;
    EXPECT_EQ(to_string(decide(scene).relation), to_string(row.relation)) << other.size() << " vertices";
  }
}

INSTANTIATE_TEST_SUITE_P(Rows, Degenerate, testing::ValuesIn(degenerate_rows()),
                         [](const auto& row) { return row.param.name; });

TEST(DegenerateRows, MostCanBeTranslatedExactly) {
  std::size_t copies = 0, rows = 0;
  for (const DegenerateRow& row : degenerate_rows()) {
    ++rows;
    for (const Similarity& similarity : translations()) copies += copy(row.scene, similarity).has_value();
  }
  std::printf("%zu exact translations of %zu rows\n", copies, rows);
  EXPECT_GT(copies, 2 * rows);
}

const Loop kWall = degenerate::kWall;

TEST(Overlap, ManySidesAllCount) {
  std::vector<int> sides(63);
  std::iota(sides.begin(), sides.end(), -31);
  for (const DegenerateRow& row : degenerate::many_sided_rows(sides)) {
    const ShadowFrustum shadow = frustum(row.scene);
    EXPECT_EQ(shadow.plane_count(), 65U);
    EXPECT_EQ(fuzz::overlap(shadow, row.scene.box).relation, row.relation) << row.name;
  }
}

TEST(Overlap, TieAmongFarthestGoesToTheFirstCorner) {
  // (2, 0, -1) comes first but is nearer; of the four corners, all equally far, (2, 1, -1) is then the first: the near
  // plane is 2x + y - z = 6. With the loop reversed it is (2, -1, -1), and 2x - y - z = 6.
  const Loop loop{{2, 0, -1}, {2, 1, -1}, {2, 1, 1}, {2, -1, 1}, {2, -1, -1}};
  const Loop reversed{loop[0], loop[4], loop[3], loop[2], loop[1]};
  const fuzz::Box at_first = degenerate::point({2.75, 0.5, 0}), at_other = degenerate::point({2.75, -0.5, 0});
  for (const auto& [corners, touching, before] : {std::tuple{loop, at_first, at_other}, {reversed, at_other, at_first}}) {
    const ShadowFrustum shadow = frustum({Viewpoint::eye({0, 0, 0}), corners, Near::farthest, touching});
    EXPECT_EQ(fuzz::overlap(shadow, touching).relation, Relation::inside);
    EXPECT_EQ(fuzz::overlap(shadow, before).relation, Relation::outside);
  }
}

/// What overlap.h says of loops that go the other way round: with `surface` they are the same, with `farthest` unless
/// several vertices are exactly equally far.
TEST(Overlap, ReversingALoopChangesTiesAmongTheFarthestAlone) {
  const Loop tied{{2, 0, -1}, {2, 1, -1}, {2, 1, 1}, {2, -1, 1}, {2, -1, -1}};
  Loop clear = tied;
  clear[1].y = std::nextafter(1.0, 2);  // the farthest now
  const fuzz::Box box = degenerate::point({2.75, 0.5, 0});
  const auto relation = [&](const Loop& loop, Near near) {
    return fuzz::overlap(frustum({Viewpoint::eye({0, 0, 0}), loop, near, box}), box).relation;
  };
  const auto reversed = [](const Loop& loop) { return Loop{loop[0], loop[4], loop[3], loop[2], loop[1]}; };
  EXPECT_EQ(relation(tied, Near::farthest), Relation::inside);
  EXPECT_EQ(relation(reversed(tied), Near::farthest), Relation::outside) << "the tie";
  EXPECT_EQ(relation(clear, Near::farthest), relation(reversed(clear), Near::farthest));
  for (const Loop& loop : {tied, clear}) {
    Loop turned = loop;
    for (std::size_t i = 0; i < loop.size(); ++i) {
      std::rotate(turned.begin(), turned.begin() + 1, turned.end());
      EXPECT_EQ(relation(turned, Near::surface), Relation::inside);
      EXPECT_EQ(relation(Loop(turned.rbegin(), turned.rend()), Near::surface), Relation::inside);
    }
  }
}

TEST(Overlap, ConservativeAsksPlanesOnly) {
  for (const DegenerateRow& row : degenerate::edge_rows()) {
    EXPECT_EQ(fuzz::conservative(frustum(row.scene), row.scene.box).relation, Relation::partial) << row.name;
  }
}

TEST(Overlap, OpenNearBoundaryDrawsWhatIsCoplanar) {
  const ShadowFrustum shadow = *ShadowFrustum::make(Viewpoint::eye({0, 0, 0}), kWall, Near::surface).frustum;
  const double beyond = std::nextafter(2.0, 3.0);
  const Aabb on_the_wall{{2, -0.5, -0.5}, {2, 0.5, 0.5}}, behind{{beyond, -0.5, -0.5}, {3, 0.5, 0.5}};
  EXPECT_EQ(conservative_certified(shadow, on_the_wall, NearBoundary::open).relation, Relation::partial);
  EXPECT_EQ(conservative_certified(shadow, behind, NearBoundary::open).relation, Relation::inside);

  const Aabb from_before{{1, -0.25, -0.25}, {2, 0.25, 0.25}};  // it still shares points with the shadow, which is closed
  for (const NearBoundary near : {NearBoundary::closed, NearBoundary::open}) {
    EXPECT_EQ(overlap_certified(shadow, from_before, near).relation, Relation::partial);
    EXPECT_EQ(conservative_certified(shadow, from_before, near).relation, Relation::partial);
  }
}

TEST(Overlap, PlainIsWrongWhereCertifiedIsNot) {
  // Boxes whose corner touches the side of a skew shadow within an ulp: rounding must mislead plain somewhere.
  const std::vector<Vec3> loop{{1.1, -0.3, -0.7}, {1.3, 0.9, -0.6}, {1.2, 0.1, 1.1}};
  const Vec3 eye{0.1, 0.2, 0.3};
  const ShadowFrustum shadow = *ShadowFrustum::make(Viewpoint::eye(eye), loop, Near::farthest).frustum;
  int wrong = 0;
  for (int i = 1; i < 2000; ++i) {
    const double s = 1 + i * 0.001, t = i * 0.0005;  // a point of the side through corners 0 and 1, rounded
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) {
      p[axis] = eye[axis] + 5 * s * ((1 - t) * (loop[0][axis] - eye[axis]) + t * (loop[1][axis] - eye[axis]));
    }
    wrong += overlap_plain(shadow, Aabb{p, p}) != overlap_certified(shadow, Aabb{p, p}).relation;
  }
  std::printf("plain is wrong on %d of 1999 points that touch\n", wrong);
  EXPECT_GT(wrong, 0);
}

}  // namespace
