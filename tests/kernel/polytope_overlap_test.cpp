// SPDX-License-Identifier: MIT
// Convex polytopes against shadow frusta: by hand, by brute force over all triples of planes, and with boxes written as
// polytopes.
#include "occlude/kernel/polytope_overlap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "error_free.h"
#include "lattice_geometry.h"
#include "occlude/fuzz/cases.h"
#include "plane_coefficients.h"
#include "polytope_cap.h"
#include "seed.h"

namespace polytope_overlap_test {

using namespace occlude::kernel;
namespace fuzz = occlude::fuzz;
using lattice::Vector;
using Loop = std::vector<Vec3>;

ConvexPolytope polytope(const Polytope& given) {
  const auto made = ConvexPolytope::make(given);
  EXPECT_EQ(made.refusal, Refusal::none) << to_string(made.refusal);
  return *made.polytope;
}

ConvexPolytope tetrahedron(const std::array<Vec3, 4>& v) {
  return polytope({{v.begin(), v.end()}, lattice::polytopes()[0].faces});
}

// A square wall at x = 2, seen from the origin. Its shadow is |y|, |z| <= x / 2 beyond x = 2.
const Loop kWall{{2, -1, -1}, {2, 1, -1}, {2, 1, 1}, {2, -1, 1}};
const double kUp = std::nextafter(2.0, 3.0), kDown = std::nextafter(2.0, 1.0);

struct Row {
  const char* name;
  std::array<Vec3, 4> occludee;
  Relation closed, open;
};

constexpr auto kInside = Relation::inside, kPartial = Relation::partial, kOutside = Relation::outside;

const Row kRows[] = {
    {"well_inside", {{{4, 0, 0}, {4, 1, 0}, {4, 0, 1}, {5, 0, 0}}}, kInside, kInside},
    {"corners_on_sides", {{{4, 2, 0}, {4, -2, 0}, {6, 0, 3}, {6, 0, -3}}}, kInside, kInside},
    {"corner_beyond_a_side", {{{4, kUp, 0}, {4, -2, 0}, {6, 0, 3}, {6, 0, -3}}}, kPartial, kPartial},
    {"face_on_the_wall", {{{2, 1, 1}, {2, -1, 0}, {2, 1, -1}, {3, 0, 0}}}, kInside, kPartial},
    {"tip_on_the_wall", {{{3, 1, 1}, {3, -1, 0}, {3, 1, -1}, {2, 0, 0}}}, kInside, kPartial},
    {"tip_before_the_wall", {{{3, 1, 1}, {3, -1, 0}, {3, 1, -1}, {kDown, 0, 0}}}, kPartial, kPartial},
    {"tip_on_the_wall_from_before", {{{1, 0.25, 0.25}, {1, -0.25, 0}, {1, 0, -0.25}, {2, 0, 0}}}, kPartial, kPartial},
    {"all_before_the_wall", {{{1, 0.25, 0.25}, {1, -0.25, 0}, {1, 0, -0.25}, {kDown, 0, 0}}}, kOutside, kOutside},
    {"behind_the_eye", {{{-4, 0, 0}, {-4, 1, 0}, {-4, 0, 1}, {-5, 0, 0}}}, kOutside, kOutside},
    {"eye_on_a_face_shadow_untouched", {{{0, 1, 1}, {0, -1, 0}, {0, 1, -1}, {kDown, 0, 0}}}, kOutside, kOutside},
    {"eye_on_a_face_tip_on_the_wall", {{{0, 1, 1}, {0, -1, 0}, {0, 1, -1}, {2, 0, 0}}}, kPartial, kPartial},
    {"about_the_eye_through_the_wall", {{{-1, 2, 2}, {-1, -2, 0}, {-1, 2, -2}, {9, 0, 0}}}, kPartial, kPartial},
    {"about_the_eye_past_the_wall", {{{-1, 9, 9}, {-1, -9, 0}, {-1, 9, -9}, {9, 9, 9}}}, kPartial, kPartial},
    {"about_the_eye_before_the_wall", {{{-1, 9, 9}, {-1, -9, 0}, {-1, 9, -9}, {kDown, 9, 9}}}, kOutside, kOutside},
    {"about_wall_and_eye", {{{-9, 99, 99}, {-9, -99, 0}, {-9, 99, -99}, {99, 0, 0}}}, kPartial, kPartial},
    // They cross the plane x = 2 and overlap the wall in the view, but beyond x = 2 they are beside the shadow or only touch
    // it.
    {"around_the_edge_apart", {{{0.5, 0, -0.1}, {0.5, 0, 0.1}, {3, 3, 0}, {3, 2.75, 0.1}}}, kOutside, kOutside},
    {"around_the_edge_touching", {{{1, 0, 0}, {1, 0, 1}, {3, 2, 0}, {3, 3, 0}}}, kPartial, kPartial},
    {"around_the_edge_ulp_apart", {{{1, 0, 0}, {1, 0, 1}, {3, kUp, 0}, {3, 3, 0}}}, kOutside, kOutside},
    {"face_across_a_ray", {{{3, 0, 4}, {3, 4, 0}, {3, 9, 9}, {1, 9, 9}}}, kOutside, kOutside},
    {"face_touches_a_ray", {{{4, 0, 4}, {4, 4, 0}, {4, 9, 9}, {1, 9, 9}}}, kPartial, kPartial},
    {"edge_on_edge_of_the_wall", {{{2, -9, 1}, {2, 9, 1}, {1, 0, 5}, {1, 0, 3}}}, kPartial, kPartial},
    {"edge_on_corner_of_the_wall", {{{1, 1, 0}, {3, 1, 2}, {1, 9, 9}, {1, 9, 1}}}, kPartial, kPartial},
};

class Tetrahedra : public testing::TestWithParam<Row> {};

TEST_P(Tetrahedra, Relation) {
  const Row& row = GetParam();
  const auto frustum = *ShadowFrustum::make(Viewpoint::eye({0, 0, 0}), kWall, Near::surface).frustum;
  const ConvexPolytope occludee = tetrahedron(row.occludee);
  EXPECT_EQ(to_string(overlap_certified(frustum, occludee).relation), to_string(row.closed));
  EXPECT_EQ(to_string(overlap_certified(frustum, occludee, NearBoundary::open).relation), to_string(row.open));
}

TEST_P(Tetrahedra, CopiesAgree) {
  const Row& row = GetParam();
  using Copy = Vec3 (*)(const Vec3&);
  const Copy copies[] = {
      [](const Vec3& v) {
        return Vec3{v.y, v.z, v.x};
      },
      [](const Vec3& v) {
        return Vec3{v.x, -v.y, v.z};
      },
      [](const Vec3& v) {
        return Vec3{v.z * 0x1p90, v.y * 0x1p90, v.x * 0x1p90};
      },
      [](const Vec3& v) {
        return Vec3{v.x * 0x1p-90, v.y * 0x1p-90, v.z * 0x1p-90};
      },
  };
  for (const Copy copy : copies) {
    Loop wall;
    for (const Vec3& v : kWall) wall.push_back(copy(v));
    std::array<Vec3, 4> occludee;
    std::transform(row.occludee.begin(), row.occludee.end(), occludee.begin(), copy);
    const auto frustum = *ShadowFrustum::make(Viewpoint::eye({0, 0, 0}), wall, Near::surface).frustum;
    EXPECT_EQ(to_string(overlap_certified(frustum, tetrahedron(occludee)).relation), to_string(row.closed));
  }
}

INSTANTIATE_TEST_SUITE_P(Rows, Tetrahedra, testing::ValuesIn(kRows),
                         [](const auto& row) { return std::string(row.param.name); });

TEST(PolytopeOverlap, FaceThatOnlyEdgesOfTheOccluderCross) {
  // An octahedron has a corner turned to the eye, and the large base of a tetrahedron is in front of it. Neither the edges
  // of the tetrahedron nor the rays of the shadow, which start at x = 6, come near the common points.
  const ConvexPolytope occluder =
      polytope({{{8, 0, 0}, {4, 0, 0}, {6, 2, 0}, {6, -2, 0}, {6, 0, 2}, {6, 0, -2}}, lattice::polytopes()[2].faces});
  const auto frustum = *ShadowFrustum::make(Viewpoint::eye({0, 0, 0}), occluder, Near::surface).frustum;
  const auto relation = [&](double x) {
    return overlap_certified(frustum, tetrahedron({{{x, 90, 90}, {x, -90, 90}, {x, 0, -90}, {1, 0, 0}}})).relation;
  };
  EXPECT_EQ(relation(5), Relation::partial);
  EXPECT_EQ(relation(4), Relation::partial);
  EXPECT_EQ(relation(std::nextafter(4.0, 0.0)), Relation::outside);
}

// Brute force: if a frustum and a polytope share points, these are a polytope, and each of its corners lies on three planes.

/// normal . x + offset >= 0.
struct Plane {
  Vector normal;
  lattice::Integer offset = 0;

  static Plane of(const ExactPlane& plane) {
    const Vector a = lattice::from_kernel(plane.a_to) - lattice::from_kernel(plane.a_from);
    const Vector b = lattice::from_kernel(plane.b_to) - lattice::from_kernel(plane.b_from);
    const Vector normal = plane.direct ? a : cross(a, b);
    return {normal, -dot(normal, lattice::from_kernel(plane.origin))};
  }
  [[nodiscard]] lattice::Integer at(const Vec3& x) const { return dot(normal, lattice::from_kernel(x)) + offset; }
};

bool have_common_point(const std::vector<Plane>& planes) {
  for (std::size_t i = 0; i < planes.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      for (std::size_t k = 0; k < j; ++k) {
        const Plane &p = planes[i], &q = planes[j], &r = planes[k];
        const Vector qr = cross(q.normal, r.normal);
        const lattice::Integer weight = dot(p.normal, qr), sign = weight > 0 ? 1 : -1;
        if (weight == 0) continue;
        const Vector point = -p.offset * qr + -q.offset * cross(r.normal, p.normal) + -r.offset * cross(p.normal, q.normal);
        if (std::all_of(planes.begin(), planes.end(), [&](const Plane& plane) {
              return sign * (dot(plane.normal, point) + plane.offset * weight) >= 0;
            })) {
          return true;
        }
      }
    }
  }
  return false;
}

Relation by_brute_force(const ShadowFrustum& frustum, const ConvexPolytope& occludee, NearBoundary near) {
  std::vector<Plane> planes;
  bool inside = true;
  for (std::size_t i = 0; i < frustum.plane_count(); ++i) {
    planes.push_back(Plane::of(plane_of(*stored(frustum), i)));
    const lattice::Integer least = near == NearBoundary::open && i < frustum.near_count() ? 1 : 0;
    for (const Vec3& v : occludee.vertices()) inside = inside && planes[i].at(v) >= least;
  }
  if (inside) return Relation::inside;
  for (std::uint32_t face = 0; face < occludee.faces().size(); ++face) {
    planes.push_back(Plane::of(inner_plane(occludee, face)));
  }
  return have_common_point(planes) ? Relation::partial : Relation::outside;
}

std::optional<ShadowFrustum> random_frustum(fuzz::Random& random, bool is_eye) {
  const Vec3 value = lattice::to_kernel(lattice::random_vector(random, is_eye ? 3 : 2));
  const Viewpoint viewpoint = is_eye ? Viewpoint::eye(value) : Viewpoint::direction(value);
  const Near near = random.chance(0.5) ? Near::farthest : Near::surface;
  if (random.chance(0.5)) return ShadowFrustum::make(viewpoint, lattice::random_polygon(random, 3), near).frustum;
  return ShadowFrustum::make(viewpoint, polytope(lattice::random_polytope(random, 4, 2)), near).frustum;
}

/// A random polytope, often moved away from the viewpoint, to where shadows are.
ConvexPolytope random_occludee(fuzz::Random& random, const ShadowFrustum& frustum) {
  Polytope given = lattice::random_polytope(random, 6, random.integer(1, 4));
  const Vector value = lattice::from_kernel(frustum.viewpoint().value);
  const Vector away = frustum.viewpoint().is_eye() ? lattice::from_kernel(frustum.silhouette()[0]) - value : value;
  const int times = random.chance(0.5) ? random.integer(1, 3) : 0;
  for (Vec3& v : given.vertices) v = lattice::to_kernel(lattice::from_kernel(v) + times * away);
  return polytope(given);
}

class BruteForceOfPlanes : public testing::TestWithParam<bool> {};

TEST_P(BruteForceOfPlanes, AgreesOnLatticePolytopes) {
  constexpr std::uint64_t kCases = 20000;
  std::array<int, 3> answers{};
  for (std::uint64_t i = 0; i < kCases; ++i) {
    const std::uint64_t seed = std::uint64_t{occlude::seed_of(1)} * kCases + i;
    SCOPED_TRACE("seed " + std::to_string(seed));
    fuzz::Random random(seed);
    const auto frustum = random_frustum(random, GetParam());
    if (!frustum) continue;
    const ConvexPolytope occludee = random_occludee(random, *frustum);
    for (const NearBoundary near : {NearBoundary::closed, NearBoundary::open}) {
      const Relation relation = overlap_certified(*frustum, occludee, near).relation;
      ASSERT_EQ(to_string(relation), to_string(by_brute_force(*frustum, occludee, near)));
      ++answers[static_cast<std::size_t>(relation)];
    }
  }
  std::printf("inside %d partial %d outside %d\n", answers[0], answers[1], answers[2]);
  for (const int count : answers) EXPECT_GT(count, 100);
}

INSTANTIATE_TEST_SUITE_P(Viewpoints, BruteForceOfPlanes, testing::Values(true, false),
                         [](const auto& is_eye) { return is_eye.param ? "eye" : "direction"; });

// Boxes of all families of the fuzzer, as polytopes of eight vertices.

std::optional<double> exact_sum(double a, double b) {
  const TwoTerms sum = two_sum(a, b);
  return sum.low == 0 ? std::optional(sum.high) : std::nullopt;
}

/// The corners, or nothing where a corner is not a double. Bit k of the index of a corner tells the end of edge k.
std::optional<Loop> corners(const Aabb& box) {
  Loop result;
  for (unsigned i = 0; i < 8; ++i) {
    const auto at = [&](int axis) { return (i >> axis & 1U) != 0 ? box.max[axis] : box.min[axis]; };
    result.push_back({at(0), at(1), at(2)});
  }
  return result;
}
std::optional<Loop> corners(const Obb& box) {
  Loop result;
  for (unsigned i = 0; i < 8; ++i) {
    Vec3 corner = box.center;
    for (unsigned k = 0; k < 3; ++k) {
      for (int axis = 0; axis < 3; ++axis) {
        const auto sum = exact_sum(corner[axis], (i >> k & 1U) != 0 ? box.half_edges[k][axis] : -box.half_edges[k][axis]);
        if (!sum) return std::nullopt;
        corner[axis] = *sum;
      }
    }
    result.push_back(corner);
  }
  return result;
}

std::optional<ConvexPolytope> as_polytope(const fuzz::Box& box) {
  const auto vertices = std::visit([](const auto& kind) { return corners(kind); }, box);
  if (!vertices) return std::nullopt;
  return ConvexPolytope::make({*vertices, lattice::polytopes()[1].faces}).polytope;
}

std::optional<ShadowFrustum> frustum_of(const fuzz::Case& c) {
  if (const auto* polygon = std::get_if<Loop>(&c.occluder)) {
    return ShadowFrustum::make(c.viewpoint, *polygon, c.near).frustum;
  }
  const auto made = ConvexPolytope::make(std::get<Polytope>(c.occluder));
  return made.polytope ? ShadowFrustum::make(c.viewpoint, *made.polytope, c.near).frustum : std::nullopt;
}

class BoxesAsPolytopes : public testing::TestWithParam<fuzz::Family> {};

TEST_P(BoxesAsPolytopes, AgreeWithTheTestOfBoxes) {
  constexpr std::uint64_t kCases = 200;
  std::array<int, 3> answers{};
  int compared = 0;
  for (std::uint64_t i = 0; i < kCases; ++i) {
    const std::uint64_t seed = std::uint64_t{occlude::seed_of(1)} * kCases + i;
    SCOPED_TRACE("seed " + std::to_string(seed));
    const fuzz::Case c = fuzz::make_case(GetParam(), seed);
    const auto occludee = as_polytope(c.box);
    const auto frustum = occludee ? frustum_of(c) : std::nullopt;
    if (!frustum) continue;
    for (const NearBoundary near : {NearBoundary::closed, NearBoundary::open}) {
      const Relation as_box =
          std::visit([&](const auto& box) { return overlap_certified(*frustum, box, near).relation; }, c.box);
      const Relation relation = overlap_certified(*frustum, *occludee, near).relation;
      ASSERT_EQ(to_string(relation), to_string(as_box));
      ++answers[static_cast<std::size_t>(relation)];
    }
    ++compared;
  }
  std::printf("%-28s %3d compared: inside %d partial %d outside %d\n", std::string(fuzz::name(GetParam())).c_str(), compared,
              answers[0], answers[1], answers[2]);
}

INSTANTIATE_TEST_SUITE_P(Families, BoxesAsPolytopes, testing::ValuesIn(fuzz::families().begin(), fuzz::families().end()),
                         [](const auto& family) { return std::string(fuzz::name(family.param)); });

}  // namespace polytope_overlap_test
