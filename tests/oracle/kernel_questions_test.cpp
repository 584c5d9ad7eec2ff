// SPDX-License-Identifier: MIT
// Compares the kernel's other questions with the oracle on every family of degenerate cases.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "cases/ask.h"
#include "cases/to_oracle.h"
#include "differential/answers.h"
#include "occlude/fuzz/cases.h"
#include "occlude/fuzz/random.h"
#include "occlude/kernel/polytope_overlap.h"
#include "occlude/kernel/shadow_union.h"
#include "occlude/kernel/view_cone.h"
#include "occlude/kernel/view_frustum.h"
#include "occlude/oracle/questions.h"
#include "seed.h"
#include "stored_frustum.h"

namespace occlude::oracle {
namespace kernel_questions_test {

using fuzz::to_oracle;

using Polygon = std::vector<kernel::Vec3>;
using Counts = std::array<std::size_t, 3>;

/// Runs the cases of the family.
class QuestionsOfFamily : public testing::TestWithParam<fuzz::Family> {
 protected:
  template <class Check>
  void for_each_case(const Check& check) {
    const std::uint64_t base = occlude::seed_of(1);
    constexpr std::uint64_t kCases = 200;
    for (std::uint64_t i = 0; i < kCases; ++i) {
      const std::uint64_t seed = base * kCases + i;
      SCOPED_TRACE("seed " + std::to_string(seed));
      fuzz::Random random(seed);
      check(fuzz::make_case(GetParam(), seed), random);
      if (HasFatalFailure()) return;
    }
  }

  [[nodiscard]] fuzz::Case other_case(fuzz::Random& random) const { return fuzz::make_case(GetParam(), random.bits()); }
};

kernel::Vec3 plus(const kernel::Vec3& a, const kernel::Vec3& b, double sign) {
  return {a.x + sign * b.x, a.y + sign * b.y, a.z + sign * b.z};
}

/// The corners of the box. Those of an oriented box are rounded.
Polygon corners_of(const fuzz::Box& box) {
  Polygon corners;
  for (unsigned i = 0; i < 8; ++i) {
    const auto is_high = [&](unsigned k) { return (i >> k & 1U) != 0; };
    if (const auto* aabb = std::get_if<kernel::Aabb>(&box)) {
      const auto& [min, max] = *aabb;
      corners.push_back({is_high(0) ? max.x : min.x, is_high(1) ? max.y : min.y, is_high(2) ? max.z : min.z});
    } else {
      const auto& [center, h] = std::get<kernel::Obb>(box);
      kernel::Vec3 x = center;
      for (unsigned k = 0; k < 3; ++k) x = plus(x, h[k], is_high(k) ? 1 : -1);
      corners.push_back(x);
    }
  }
  return corners;
}

/// The box as a polytope, or one of its faces. The polytope is not legal when the box is flat, or when rounding moved its
/// corners out of their planes.
fuzz::Occluder occludee_of(const fuzz::Box& box, fuzz::Random& random) {
  const std::vector<std::vector<std::uint32_t>> faces{{0, 2, 6, 4}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                                      {2, 3, 7, 6}, {0, 1, 3, 2}, {4, 5, 7, 6}};
  const Polygon corners = corners_of(box);
  if (random.chance(0.6)) return kernel::Polytope{corners, faces};
  Polygon loop;
  for (const std::uint32_t index : faces[random.index(faces.size())]) loop.push_back(corners[index]);
  return loop;
}

// ------------------------------------------------------------------------------------------------------------ half-spaces

/// Half-spaces with small integer normals, whose planes pass through corners of the box or nearly. They all contain one
/// point, which is in the box or near it, so their intersection is not empty.
std::vector<kernel::HalfSpace> half_spaces_about(const fuzz::Box& box, fuzz::Random& random) {
  const Polygon corners = corners_of(box);
  const kernel::Vec3 &p = corners[random.index(8)], &q = corners[random.index(8)];
  const kernel::Vec3 within = plus(p, plus(p, q, -1), random.real(-1, 1));
  std::vector<kernel::HalfSpace> half_spaces;
  for (std::size_t i = random.index(6) + 1; i > 0; --i) {
    const auto coefficient = [&] { return static_cast<double>(random.integer(-2, 2)); };
    kernel::Vec3 n{coefficient(), coefficient(), coefficient()};
    const kernel::Vec3& c = corners[random.index(8)];
    double d = -(n.x * c.x + n.y * c.y + n.z * c.z);
    if (random.chance(0.3)) d *= 1 + 0x1p-52 * random.integer(-2, 2);
    const HalfSpaceCoefficients plane{n.x, n.y, n.z, d};
    // The relation of a point box says exactly on which side the point is.
    if (relation_to_half_spaces(std::array<HalfSpaceCoefficients, 1>{plane}, Aabb{to_oracle(within), to_oracle(within)})
            .relation == Relation::outside) {
      n = {-n.x, -n.y, -n.z};
      d = -d;
    }
    half_spaces.push_back({n, d});
  }
  return half_spaces;
}

TEST_P(QuestionsOfFamily, HalfSpaces) {
  Counts counts{};
  for_each_case([&](const fuzz::Case& c, fuzz::Random& random) {
    const std::vector<kernel::HalfSpace> half_spaces = half_spaces_about(c.box, random);
    std::vector<HalfSpaceCoefficients> coefficients;
    for (const auto& [n, d] : half_spaces) {
      if (kernel::check(d) != kernel::Refusal::none) return;
      coefficients.push_back({n.x, n.y, n.z, d});
    }
    const Box box = to_oracle(c.box);
    const Answer answer = relation_to_half_spaces(coefficients, box);
    ASSERT_EQ(answer.refusal.empty(), fuzz::check(c.box) == kernel::Refusal::none) << answer.refusal;
    if (!answer.refusal.empty()) return;
    const auto found = std::visit([&](const auto& kind) { return overlap_certified(half_spaces, kind); }, c.box);
    ASSERT_EQ(found.relation, fuzz::relation_of(answer.relation));
    const auto one = [&](const auto& kind) { return relation(half_spaces[0], kind, kernel::Arithmetic::certified); };
    ASSERT_EQ(std::visit(one, c.box),
              fuzz::relation_of(relation_to_half_spaces(std::span(coefficients).first(1), box).relation));
    ++counts[static_cast<std::size_t>(answer.relation)];
  });
  EXPECT_GT(counts[0] + counts[1] + counts[2], 100U);
}

// -------------------------------------------------------------------------------------------------------------- silhouette

Loop sorted(Loop points) {
  std::ranges::sort(points);
  return points;
}

TEST_P(QuestionsOfFamily, Silhouette) {
  std::size_t answered = 0;
  for_each_case([&](fuzz::Case c, fuzz::Random&) {
    c.near = kernel::Near::farthest;
    const auto made = fuzz::make_frustum(c);
    const Outline found = outline(to_oracle(c.viewpoint), to_oracle(c.occluder));
    ASSERT_EQ(made.frustum.has_value(), found.refusal.empty()) << found.refusal;
    if (!made.frustum) return;
    const auto corners = made.frustum->silhouette();
    ASSERT_EQ(sorted(to_oracle(Polygon(corners.begin(), corners.end()))), found.corners);
    ASSERT_EQ(to_oracle(std::get<kernel::ExactPlane>(kernel::stored(*made.frustum)->recipes[0]).origin), found.farthest);
    ++answered;
  });
  EXPECT_GT(answered, 100U);
}

// ------------------------------------------------------------------------------------------------------------ cones of rays

kernel::ViewConeResult cone_of(const kernel::Viewpoint& viewpoint, const fuzz::Occluder& occluder) {
  if (const auto* polygon = std::get_if<Polygon>(&occluder)) return kernel::ViewCone::make(viewpoint, *polygon);
  const auto made = kernel::ConvexPolytope::make(std::get<kernel::Polytope>(occluder));
  if (!made.polytope) return {std::nullopt, made.refusal};
  return kernel::ViewCone::make(viewpoint, *made.polytope);
}

TEST_P(QuestionsOfFamily, Cones) {
  Counts counts{};
  for_each_case([&](const fuzz::Case& c, fuzz::Random& random) {
    const fuzz::Occluder occludee = random.chance(0.7) ? occludee_of(c.box, random) : other_case(random).occluder;
    const auto outer = cone_of(c.viewpoint, c.occluder), inner = cone_of(c.viewpoint, occludee);
    const Answer answer = cone_relation(to_oracle(c.viewpoint), to_oracle(c.occluder), to_oracle(occludee));
    ASSERT_EQ(outer.cone && inner.cone, answer.refusal.empty()) << answer.refusal;
    if (!outer.cone || !inner.cone) return;
    ASSERT_EQ(overlap_certified(*outer.cone, *inner.cone).relation, fuzz::relation_of(answer.relation));
    ++counts[static_cast<std::size_t>(answer.relation)];
  });
  std::printf("%-28s inside %zu partial %zu outside %zu\n", std::string(fuzz::name(GetParam())).c_str(), counts[0],
              counts[1], counts[2]);
}

// ------------------------------------------------------------------------------------------------- polytopes as occludees

TEST_P(QuestionsOfFamily, Occludees) {
  Counts counts{};
  for_each_case([&](const fuzz::Case& c, fuzz::Random& random) {
    const auto made = fuzz::make_frustum(c);
    if (!made.frustum) return;
    fuzz::Occluder given = random.chance(0.7) ? occludee_of(c.box, random) : other_case(random).occluder;
    const auto* polytope = std::get_if<kernel::Polytope>(&given);
    if (!polytope) return;
    const auto occludee = kernel::ConvexPolytope::make(*polytope);
    Shadow shadow(to_oracle(c.viewpoint), to_oracle(c.occluder), to_oracle(c.near, made));
    const Answer answer = shadow.relation(std::get<Polytope>(to_oracle(given)));
    ASSERT_EQ(occludee.polytope.has_value(), answer.refusal.empty()) << answer.refusal;
    if (!occludee.polytope) return;
    ASSERT_EQ(overlap_certified(*made.frustum, *occludee.polytope).relation, fuzz::relation_of(answer.relation));
    ++counts[static_cast<std::size_t>(answer.relation)];
  });
  std::printf("%-28s inside %zu partial %zu outside %zu\n", std::string(fuzz::name(GetParam())).c_str(), counts[0],
              counts[1], counts[2]);
}

// ------------------------------------------------------------------------------------------------------------------ unions

/// Two occluders: the parts of a polygon on both sides of a diagonal, or the occluders of this case and of another.
std::pair<fuzz::Occluder, fuzz::Occluder> occluders_of(const fuzz::Case& c, const fuzz::Case& other) {
  const auto* loop = std::get_if<Polygon>(&c.occluder);
  if (!loop || loop->size() < 4) return {c.occluder, other.occluder};
  const auto middle = loop->begin() + static_cast<std::ptrdiff_t>(loop->size() / 2);
  Polygon first(loop->begin(), middle + 1), second(middle, loop->end());
  second.push_back(loop->front());
  return {first, second};
}

TEST_P(QuestionsOfFamily, Unions) {
  Counts counts{};
  std::size_t joint = 0;              // inside the union but in neither shadow alone
  std::size_t proved = 0, found = 0;  // culls by both, open near planes: proved by the oracle, found by the kernel
  for_each_case([&](const fuzz::Case& c, fuzz::Random& random) {
    std::pair<fuzz::Case, fuzz::Case> parts{c, c};
    std::tie(parts.first.occluder, parts.second.occluder) = occluders_of(c, other_case(random));
    const auto first = fuzz::make_frustum(parts.first), second = fuzz::make_frustum(parts.second);
    if (!first.frustum || !second.frustum) return;
    const auto shadow = [&](const fuzz::Case& part, const kernel::ShadowFrustumResult& made) {
      return Shadow(to_oracle(part.viewpoint), to_oracle(part.occluder), to_oracle(part.near, made));
    };
    Shadow one = shadow(parts.first, first), two = shadow(parts.second, second);
    const Box box = to_oracle(c.box);
    const Answer answer = one.relation_to_union(two, box);
    ASSERT_EQ(answer.refusal.empty(), fuzz::check(c.box) == kernel::Refusal::none) << answer.refusal;
    if (!answer.refusal.empty()) return;
    const kernel::ShadowUnion both{*first.frustum, *second.frustum};
    const auto ask = [&](kernel::NearBoundary near) {
      return std::visit([&](const auto& kind) { return overlap_certified(both, kind, near).relation; }, c.box);
    };
    ASSERT_EQ(ask(kernel::NearBoundary::closed), fuzz::relation_of(answer.relation));
    const std::string refuted = one.refute_union_cull(two, box);
    ASSERT_EQ(refuted, two.refute_union_cull(one, box));
    const bool is_found = ask(kernel::NearBoundary::open) == kernel::Relation::inside;
    ASSERT_TRUE(!is_found || refuted.empty()) << refuted;
    proved += refuted.empty() ? 1 : 0;
    found += is_found ? 1 : 0;
    ++counts[static_cast<std::size_t>(answer.relation)];
    const bool is_in_one = one.relation(box).relation == Relation::inside || two.relation(box).relation == Relation::inside;
    if (answer.relation == Relation::inside && !is_in_one) ++joint;
  });
  std::printf("%-28s inside %zu (%zu by both) partial %zu outside %zu; culls %zu of %zu\n",
              std::string(fuzz::name(GetParam())).c_str(), counts[0], joint, counts[1], counts[2], found, proved);
}

INSTANTIATE_TEST_SUITE_P(All, QuestionsOfFamily, testing::ValuesIn(fuzz::families().begin(), fuzz::families().end()),
                         [](const auto& family) { return std::string(fuzz::name(family.param)); });

}  // namespace kernel_questions_test
}  // namespace occlude::oracle
