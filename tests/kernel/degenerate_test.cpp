// SPDX-License-Identifier: MIT
// The hand cases, exact copies of them, and what needs a test of its own.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <tuple>
#include <variant>
#include <vector>

#include "cases/ask.h"
#include "hand_cases.h"
#include "kernel/exact_copies.h"
#include "occlude/kernel/overlap.h"

namespace degenerate_test {

using namespace occlude;
using namespace occlude::kernel;
using Loop = std::vector<Vec3>;

ShadowFrustum frustum(const cases::Case& scene) {
  auto result = cases::make_frustum(scene);
  EXPECT_EQ(to_string(result.refusal), to_string(Refusal::none));
  return *result.frustum;
}

Decision decide(const cases::Case& scene) {
  EXPECT_EQ(cases::check(scene.box), Refusal::none);
  return cases::overlap(frustum(scene), scene.box);
}

class Degenerate : public testing::TestWithParam<HandCase> {};

TEST_P(Degenerate, AnswerAndStage) {
  const HandCase& row = GetParam();
  const Decision decision = decide(row.question);
  EXPECT_EQ(to_string(decision.relation), to_string(row.relation));
  EXPECT_EQ(decision.stage, row.stage);
}

TEST_P(Degenerate, ConservativeIsTheSameOrPartial) {
  const HandCase& row = GetParam();
  const Relation relation = cases::conservative(frustum(row.question), row.question.box).relation;
  if (row.relation == Relation::outside && relation == Relation::partial) return;
  EXPECT_EQ(to_string(relation), to_string(row.relation));
}

/// Checks the answer for every copy that is exact, and returns the number of these copies.
std::size_t check_copies(const HandCase& row, const std::vector<Similarity>& similarities) {
  std::size_t count = 0;
  for (const Similarity& similarity : similarities) {
    const auto image = copy(row.question, similarity);
    if (!image) continue;
    EXPECT_EQ(to_string(decide(*image).relation), to_string(row.relation)) << similarity.name;
    ++count;
  }
  return count;
}

TEST_P(Degenerate, ExactCopiesAgree) {
  const HandCase& row = GetParam();
  EXPECT_EQ(check_copies(row, permutations_and_mirrors()), permutations_and_mirrors().size());
  // Rows at an end of the legal range can be scaled in one direction only.
  EXPECT_GE(check_copies(row, scalings()), 2U);
  // Not every row has an exact translation, so MostCanBeTranslatedExactly counts them over all rows.
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

/// Other ways to write a loop that keep its first vertex first. Where several vertices are equally far, the near plane of
/// `farthest` stays the same only if the first vertex of the loop is one of them. This is so in all rows with such a tie.
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
  const HandCase& row = GetParam();
  const auto* const loop = std::get_if<Loop>(&row.question.occluder);
  if (!loop) return;
  for (const Loop& other : other_loops(*loop)) {
    cases::Case scene = row.question;
    scene.occluder = other;
    EXPECT_EQ(to_string(decide(scene).relation), to_string(row.relation)) << other.size() << " vertices";
  }
}

INSTANTIATE_TEST_SUITE_P(Rows, Degenerate, testing::ValuesIn(hand_cases()), [](const auto& row) { return row.param.id; });

TEST(DegenerateRows, MostCanBeTranslatedExactly) {
  std::size_t copies = 0, rows = 0;
  for (const HandCase& row : hand_cases()) {
    ++rows;
    for (const Similarity& similarity : translations()) copies += copy(row.question, similarity).has_value();
  }
  std::printf("%zu exact translations of %zu rows\n", copies, rows);
  EXPECT_GT(copies, 2 * rows);
}

/// A square wall at x = 2. Seen from the origin, its shadow is |y|, |z| <= x / 2, and for `surface` also x >= 2.
const Loop kWall{{2, -1, -1}, {2, 1, -1}, {2, 1, 1}, {2, -1, 1}};

Aabb point(const Vec3& p) { return {p, p}; }

/// Vertices (i, i^2) of a parabola at x = 2: at x = 4 the shadow is bounded by the chords of z = y^2 / 2 between (2i, 2i^2)
/// and (2i + 2, 2(i + 1)^2). The middles of these chords are at y = 2i + 1, z = 2i^2 + 2i + 1, and the parabola there is at
/// z - 1/2. Points between a chord and the parabola are not hidden, so the test fails when any one side is left out.
TEST(Overlap, ManySidesAllCount) {
  Loop parabola;
  for (int i = -31; i <= 32; ++i) parabola.push_back({2, static_cast<double>(i), static_cast<double>(i * i)});
  const ShadowFrustum shadow = *ShadowFrustum::make(Viewpoint::eye({0, 0, 0}), parabola, Near::surface).frustum;
  EXPECT_EQ(shadow.plane_count(), 65U);
  for (int i = -31; i < 32; ++i) {
    SCOPED_TRACE("side " + std::to_string(i + 32));
    const double y = 2 * i + 1, z = 2 * i * i + 2 * i + 1;
    const auto relation = [&](double low, double high) {
      return overlap_certified(shadow, Aabb{{4, y, low}, {4, y, high}}).relation;
    };
    EXPECT_EQ(relation(z, z), Relation::inside) << "touched";
    EXPECT_EQ(relation(z - 0.5, z), Relation::partial) << "touched from outside";
    EXPECT_EQ(relation(z - 0.25, z - 0.25), Relation::outside) << "between side and parabola";
    EXPECT_EQ(relation(z + 0.25, z + 0.25), Relation::inside);
  }
}

TEST(Overlap, TieAmongFarthestGoesToTheFirstCorner) {
  // (2, 0, -1) comes first but is nearer. The four corners are equally far, and (2, 1, -1) is the first of them, so the near
  // plane is 2x + y - z = 6. With the loop reversed, (2, -1, -1) is the first, and the plane is 2x - y - z = 6.
  const Loop loop{{2, 0, -1}, {2, 1, -1}, {2, 1, 1}, {2, -1, 1}, {2, -1, -1}};
  const Loop reversed{loop[0], loop[4], loop[3], loop[2], loop[1]};
  const cases::Box at_first = point({2.75, 0.5, 0}), at_other = point({2.75, -0.5, 0});
  for (const auto& [corners, touching, before] : {std::tuple{loop, at_first, at_other}, {reversed, at_other, at_first}}) {
    const ShadowFrustum shadow = frustum({Viewpoint::eye({0, 0, 0}), corners, Near::farthest, touching});
    EXPECT_EQ(cases::overlap(shadow, touching).relation, Relation::inside);
    EXPECT_EQ(cases::overlap(shadow, before).relation, Relation::outside);
  }
}

/// A reversed loop gives the same answers with `surface`, and with `farthest` unless several vertices are exactly equally
/// far (overlap.h).
TEST(Overlap, ReversingALoopChangesTiesAmongTheFarthestAlone) {
  const Loop tied{{2, 0, -1}, {2, 1, -1}, {2, 1, 1}, {2, -1, 1}, {2, -1, -1}};
  Loop clear = tied;
  clear[1].y = std::nextafter(1.0, 2);  // now the only farthest vertex
  const cases::Box box = point({2.75, 0.5, 0});
  const auto relation = [&](const Loop& loop, Near near) {
    return cases::overlap(frustum({Viewpoint::eye({0, 0, 0}), loop, near, box}), box).relation;
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
  // The planes of the frustum alone leave all of these undecided.
  const std::vector<HandCase> rows = hand_cases("diamond_");
  EXPECT_EQ(rows.size(), 4U);
  for (const HandCase& row : rows) {
    EXPECT_EQ(cases::conservative(frustum(row.question), row.question.box).relation, Relation::partial) << row.id;
  }
}

TEST(Overlap, OpenNearBoundaryDrawsWhatIsCoplanar) {
  const ShadowFrustum shadow = *ShadowFrustum::make(Viewpoint::eye({0, 0, 0}), kWall, Near::surface).frustum;
  const double beyond = std::nextafter(2.0, 3.0);
  const Aabb on_the_wall{{2, -0.5, -0.5}, {2, 0.5, 0.5}}, behind{{beyond, -0.5, -0.5}, {3, 0.5, 0.5}};
  EXPECT_EQ(conservative_certified(shadow, on_the_wall, NearBoundary::open).relation, Relation::partial);
  EXPECT_EQ(conservative_certified(shadow, behind, NearBoundary::open).relation, Relation::inside);

  const Aabb from_before{{1, -0.25, -0.25}, {2, 0.25, 0.25}};  // it shares points with the shadow, which is closed
  for (const NearBoundary near : {NearBoundary::closed, NearBoundary::open}) {
    EXPECT_EQ(overlap_certified(shadow, from_before, near).relation, Relation::partial);
    EXPECT_EQ(conservative_certified(shadow, from_before, near).relation, Relation::partial);
  }
}

TEST(Overlap, PlainIsWrongWhereCertifiedIsNot) {
  // The corner of each box touches the side of a skew shadow within an ulp. Rounding must make `plain` wrong somewhere.
  const std::vector<Vec3> loop{{1.1, -0.3, -0.7}, {1.3, 0.9, -0.6}, {1.2, 0.1, 1.1}};
  const Vec3 eye{0.1, 0.2, 0.3};
  const ShadowFrustum shadow = *ShadowFrustum::make(Viewpoint::eye(eye), loop, Near::farthest).frustum;
  int wrong = 0;
  for (int i = 1; i < 2000; ++i) {
    const double s = 1 + i * 0.001, t = i * 0.0005;  // for a point on the side through corners 0 and 1, rounded
    Vec3 p;
    for (int axis = 0; axis < 3; ++axis) {
      p[axis] = eye[axis] + 5 * s * ((1 - t) * (loop[0][axis] - eye[axis]) + t * (loop[1][axis] - eye[axis]));
    }
    wrong += overlap_plain(shadow, Aabb{p, p}) != overlap_certified(shadow, Aabb{p, p}).relation;
  }
  std::printf("plain is wrong on %d of 1999 points that touch\n", wrong);
  EXPECT_GT(wrong, 0);
}

}  // namespace degenerate_test
