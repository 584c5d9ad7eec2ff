// SPDX-License-Identifier: MIT
// What holds for every case of a family.
#include "occlude/fuzz/cases.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <set>
#include <string>

#include "case_hash.h"
#include "occlude/kernel/validity.h"

namespace occlude::fuzz {
namespace cases_test {

using kernel::Vec3;
using Polygon = std::vector<Vec3>;

constexpr std::uint64_t kCases = 300;

void for_each_case(Family family, const std::function<void(const Case&)>& check) {
  for (std::uint64_t seed = 0; seed < kCases; ++seed) {
    SCOPED_TRACE("family " + std::string(name(family)) + ", seed " + std::to_string(seed));
    check(make_case(family, seed));
  }
}

/// The number of cases of the family for which this holds.
std::uint64_t count(Family family, const std::function<bool(const Case&)>& is_such) {
  std::uint64_t number = 0;
  for (std::uint64_t seed = 0; seed < kCases; ++seed) number += is_such(make_case(family, seed)) ? 1 : 0;
  return number;
}

Vec3 minus(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
Vec3 cross(const Vec3& a, const Vec3& b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

class Cases : public testing::TestWithParam<Family> {};

TEST_P(Cases, AreTheSameForTheSameSeed) {
  CaseHash once, again, other;
  for (std::uint64_t seed = 0; seed < kCases; ++seed) {
    once.add(make_case(GetParam(), seed));
    again.add(make_case(GetParam(), seed));
    other.add(make_case(GetParam(), seed + 1));
  }
  EXPECT_EQ(once.value(), again.value());
  EXPECT_NE(once.value(), other.value());
}

TEST_P(Cases, AreWithinTheLegalRange) {
  for_each_case(GetParam(), [](const Case& c) {
    ASSERT_EQ(kernel::check(c.viewpoint.value), kernel::Refusal::none);
    for (const Vec3& vertex : vertices_of(c.occluder)) ASSERT_EQ(kernel::check(vertex), kernel::Refusal::none);
    std::visit([](const auto& box) { ASSERT_EQ(kernel::check(box), kernel::Refusal::none); }, c.box);
  });
}

TEST_P(Cases, AreOfTheKindsThatTheNameTells) {
  const auto tells = [](std::string_view word) { return name(GetParam()).find(word) != std::string_view::npos; };
  for_each_case(GetParam(), [&](const Case& c) {
    ASSERT_EQ(std::holds_alternative<kernel::Obb>(c.box), tells("obb"));
    ASSERT_EQ(std::holds_alternative<kernel::Polytope>(c.occluder), tells("polytope"));
    ASSERT_EQ(!c.viewpoint.is_eye(), tells("orthographic"));
  });
}

TEST_P(Cases, HaveFacesOfVerticesThatExist) {
  for_each_case(GetParam(), [](const Case& c) {
    const auto* const polytope = std::get_if<kernel::Polytope>(&c.occluder);
    if (!polytope) return;
    ASSERT_GE(polytope->faces.size(), 4);
    for (const auto& face : polytope->faces) {
      ASSERT_GE(face.size(), 3);
      for (const std::uint32_t i : face) ASSERT_LT(i, polytope->vertices.size());
    }
  });
}

INSTANTIATE_TEST_SUITE_P(All, Cases, testing::ValuesIn(families().begin(), families().end()),
                         [](const auto& family) { return std::string(name(family.param)); });

TEST(Families, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (const Family family : families()) names.insert(name(family));
  EXPECT_EQ(names.size(), families().size());
}

TEST(Families, AskForBothNearPlanes) {
  for (const Family family : {Family::lattice, Family::obb_lattice, Family::polytope_hull, Family::obb_polytope,
                              Family::polytope_orthographic_touch, Family::obb_orthographic_touch}) {
    const std::uint64_t farthest = count(family, [](const Case& c) { return c.near == Near::farthest; });
    EXPECT_GT(farthest, kCases / 3) << name(family);
    EXPECT_LT(farthest, kCases * 2 / 3) << name(family);
  }
}

std::ptrdiff_t zero_half_edges(const Case& c) { return std::ranges::count(std::get<kernel::Obb>(c.box).half_edges, Vec3{}); }

TEST(Families, FlatBoxesAreFlat) {
  for_each_case(Family::obb_flat, [](const Case& c) { ASSERT_GE(zero_half_edges(c), 1); });
  for_each_case(Family::obb_needle, [](const Case& c) { ASSERT_GE(zero_half_edges(c), 2); });
  for_each_case(Family::obb_point, [](const Case& c) { ASSERT_EQ(zero_half_edges(c), 3); });
}

/// An integer vector in lowest terms, so that a determinant of such vectors is exact.
Vec3 reduced(const Vec3& v) {
  const auto whole = [](double x) { return static_cast<std::int64_t>(x); };
  const auto divisor = static_cast<double>(std::gcd(std::gcd(whole(v.x), whole(v.y)), whole(v.z)));
  return divisor == 0 ? v : Vec3{v.x / divisor, v.y / divisor, v.z / divisor};
}

TEST(Families, FlatHexagonsHaveNoVolumeYetThreeHalfEdges) {
  const auto is_hexagon = [](const Case& c) {
    const auto& [e, f, g] = std::get<kernel::Obb>(c.box).half_edges;
    return cross(e, f) != Vec3{} && cross(f, g) != Vec3{} && cross(e, g) != Vec3{};
  };
  for_each_case(Family::obb_dependent, [](const Case& c) {
    const auto& [e, f, g] = std::get<kernel::Obb>(c.box).half_edges;
    ASSERT_EQ(dot(cross(reduced(e), reduced(f)), reduced(g)), 0);
  });
  EXPECT_GT(count(Family::obb_dependent, is_hexagon), kCases / 10);
}

TEST(Families, AxisBoxesLieAlongTheAxes) {
  for_each_case(Family::obb_axis, [](const Case& c) {
    for (const Vec3& e : std::get<kernel::Obb>(c.box).half_edges) ASSERT_GE((e.x == 0) + (e.y == 0) + (e.z == 0), 2);
  });
}

const Vec3& farthest_from_eye(const Case& c) {
  return *std::ranges::max_element(vertices_of(c.occluder), {}, [&](const Vec3& v) {
    const Vec3 ray = minus(v, c.viewpoint.value);
    return dot(ray, ray);
  });
}

TEST(Families, WideFrustaHaveRaysBehindTheirNearPlane) {
  const auto has_ray_behind = [](const Case& c) {
    const Vec3 normal = minus(farthest_from_eye(c), c.viewpoint.value);
    return std::ranges::any_of(vertices_of(c.occluder),
                               [&](const Vec3& v) { return dot(minus(v, c.viewpoint.value), normal) <= 0; });
  };
  EXPECT_GT(count(Family::wide_frustum, has_ray_behind), kCases / 2);
  EXPECT_GT(count(Family::obb_wide_frustum, has_ray_behind), kCases / 2);
  EXPECT_GT(count(Family::polytope_wide_frustum, has_ray_behind), kCases / 2);
}

/// The area of a face as seen, for the plane of the face at its first corner. It is exactly zero for a face seen edge-on,
/// because the numbers are small integers.
double seen_area(const Case& c, const kernel::Polytope& polytope, const std::vector<std::uint32_t>& face) {
  const Vec3& first = polytope.vertices[face[0]];
  const Vec3 line = c.viewpoint.is_eye() ? minus(first, c.viewpoint.value) : c.viewpoint.value;
  double area = 0;
  for (std::size_t i = 1; i + 1 < face.size(); ++i) {
    area += dot(line, cross(minus(polytope.vertices[face[i]], first), minus(polytope.vertices[face[i + 1]], first)));
  }
  return area;
}

TEST(Families, EdgeOnFacesAreSeenEdgeOn) {
  const auto has_face_edge_on = [](const Case& c) {
    const auto& polytope = std::get<kernel::Polytope>(c.occluder);
    return std::ranges::any_of(polytope.faces, [&](const auto& face) { return seen_area(c, polytope, face) == 0; });
  };
  for (const Family family :
       {Family::polytope_edge_on, Family::polytope_orthographic_edge_on, Family::obb_polytope_edge_on}) {
    EXPECT_GT(count(family, has_face_edge_on), kCases * 9 / 10) << name(family);
  }
}

TEST(Families, FarthestVerticesAreEquallyFar) {
  const auto has_tie = [](const Case& c) {
    const Vec3& p = farthest_from_eye(c);
    const auto square = [&](const Vec3& v) { return dot(minus(v, c.viewpoint.value), minus(v, c.viewpoint.value)); };
    return std::ranges::any_of(vertices_of(c.occluder), [&](const Vec3& v) { return v != p && square(v) == square(p); });
  };
  EXPECT_EQ(count(Family::equal_farthest, has_tie), kCases);
  // An apex may be farther, but is not on the silhouette.
  EXPECT_GT(count(Family::polytope_equal_farthest, has_tie), kCases / 2);
}

}  // namespace cases_test
}  // namespace occlude::fuzz
