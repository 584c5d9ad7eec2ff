// SPDX-License-Identifier: MIT
// Boxes against intersections of half-spaces: by hand with a far plane, and against shadow frusta without one.
#include "occlude/kernel/view_frustum.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <optional>
#include <variant>
#include <vector>

#include "expansion.h"
#include "occlude/fuzz/cases.h"
#include "plane_coefficients.h"

namespace view_frustum_test {

using namespace occlude;
using namespace occlude::kernel;

/// The set |y| <= x, |z| <= x, 1 <= x <= 4.
const std::vector<HalfSpace> kView{{{1, -1, 0}, 0}, {{1, 1, 0}, 0},  {{1, 0, -1}, 0},
                                   {{1, 0, 1}, 0},  {{1, 0, 0}, -1}, {{-1, 0, 0}, 4}};

struct Row {
  const char* name;
  Aabb box;
  Relation relation;
};

const double kBeyond = std::nextafter(4.0, 5.0);

const Row kRows[] = {
    {"inside_up_to_the_far_plane", {{3, -1, -1}, {4, 1, 1}}, Relation::inside},
    {"one_ulp_through_the_far_plane", {{3, -1, -1}, {kBeyond, 1, 1}}, Relation::partial},
    {"touches_the_far_plane_from_beyond", {{4, -1, -1}, {5, 1, 1}}, Relation::partial},
    {"beyond_the_far_plane", {{kBeyond, -1, -1}, {5, 1, 1}}, Relation::outside},
    {"touches_a_far_corner", {{4, 4, 4}, {5, 5, 5}}, Relation::partial},
    {"holds_the_frustum", {{0, -5, -5}, {5, 5, 5}}, Relation::partial},
    {"between_near_and_far_beside", {{2, 3, -1}, {2.5, 4, 1}}, Relation::outside},
    {"touches_a_side_edge", {{2, 3, 3}, {3, 4, 4}}, Relation::partial},
    {"past_a_side_edge", {{2, std::nextafter(3.0, 4), 3}, {3, 4, 4}}, Relation::outside},
};

class ViewRows : public testing::TestWithParam<Row> {};

TEST_P(ViewRows, Answer) {
  const auto& [name, box, expected] = GetParam();
  EXPECT_EQ(to_string(overlap_certified(kView, box).relation), to_string(expected));
  const Vec3 c{(box.min.x + box.max.x) / 2, (box.min.y + box.max.y) / 2, (box.min.z + box.max.z) / 2};
  const Vec3 h{box.max.x - c.x, box.max.y - c.y, box.max.z - c.z};
  const bool is_exact = c.x - h.x == box.min.x && c.y - h.y == box.min.y;  // false where the ulp rows round
  if (is_exact && box.max.x != kBeyond && box.min.x != kBeyond && std::string_view(name) != "past_a_side_edge") {
    const Obb same{c, {Vec3{h.x, 0, 0}, Vec3{0, h.y, 0}, Vec3{0, 0, h.z}}};
    EXPECT_EQ(to_string(overlap_certified(kView, same).relation), to_string(expected));
  }
}

INSTANTIATE_TEST_SUITE_P(Rows, ViewRows, testing::ValuesIn(kRows),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(ViewFrustum, EdgeAgainstEdge) {
  // An oriented box is beside the far edge y = x = 4. Its edge from (4.5, 3) to (3.5, 5) passes through that edge, and a
  // little farther out no face of either separates them.
  const auto diamond = [](double y) { return Obb{{4.5, y, 0}, {Vec3{0.5, 1, 0}, Vec3{0.5, -1, 0}, Vec3{0, 0, 1}}}; };
  EXPECT_EQ(overlap_certified(kView, diamond(5)).relation, Relation::partial);
  EXPECT_EQ(overlap_certified(kView, diamond(std::nextafter(5.0, 6))).relation, Relation::outside);
}

/// The planes of a shadow frustum, or nothing unless they have exact coefficients within the legal range.
std::optional<std::vector<HalfSpace>> planes_of(const ShadowFrustum& frustum) {
  std::vector<HalfSpace> planes;
  for (std::size_t i = 0; i < frustum.plane_count(); ++i) {
    const ExactPlane& laid = plane_of(*stored(frustum), i);
    const auto n = normal<PlainArithmetic>(laid);
    const HalfSpace h{{n.x, n.y, n.z}, -(n.x * laid.origin.x + n.y * laid.origin.y + n.z * laid.origin.z)};
    const auto exact = normal<ExactArithmetic>(laid);
    const Expansion offset = -dot(exact, constants<ExactArithmetic>(laid.origin));
    const bool same = (exact.x - Expansion(n.x)).sign() == 0 && (exact.y - Expansion(n.y)).sign() == 0 &&
                      (exact.z - Expansion(n.z)).sign() == 0 && (offset - Expansion(h.offset)).sign() == 0;
    if (!same || check(h.normal) != Refusal::none || check(h.offset) != Refusal::none) return std::nullopt;
    planes.push_back(h);
  }
  return planes;
}

/// The same question is answered through the profile of a shadow frustum and by an intersection of half-spaces.
TEST(ViewFrustum, AgreesWithShadowFrusta) {
  std::array<int, 3> counts{};
  for (const fuzz::Family family : fuzz::families()) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
      const fuzz::Case c = fuzz::make_case(family, seed);
      const auto* polygon = std::get_if<std::vector<Vec3>>(&c.occluder);
      if (!polygon || polygon->size() > 8) continue;
      const auto made = ShadowFrustum::make(c.viewpoint, *polygon, c.near);
      if (!made.frustum) continue;
      const auto planes = planes_of(*made.frustum);
      if (!planes) continue;
      std::visit(
          [&](const auto& box) {
            const Relation expected = overlap_certified(*made.frustum, box).relation;
            ASSERT_EQ(to_string(overlap_certified(*planes, box).relation), to_string(expected))
                << fuzz::name(family) << " " << seed;
            ++counts[static_cast<std::size_t>(expected)];
          },
          c.box);
    }
  }
  std::printf("inside %d partial %d outside %d\n", counts[0], counts[1], counts[2]);
  for (const int count : counts) EXPECT_GT(count, 200);
}

}  // namespace view_frustum_test
