// SPDX-License-Identifier: MIT
// Cones of rays against each other: degenerate positions worked out by hand, brute force over all pairs of sides, and the
// cost.
#include "occlude/kernel/view_cone.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "cone_sweep.h"
#include "lattice_geometry.h"
#include "seed.h"

namespace view_cone_test {

using namespace occlude::kernel;
using Loop = std::vector<Vec3>;

ViewCone cone(const Viewpoint& viewpoint, const Loop& loop) {
  const auto made = ViewCone::make(viewpoint, loop);
  EXPECT_EQ(made.refusal, Refusal::none) << to_string(made.refusal);
  return *made.cone;
}

/// A loop in the plane z = 1, as the eye at the origin sees it.
Loop at_one(const std::vector<std::array<double, 2>>& corners) {
  Loop loop;
  for (const auto& [x, y] : corners) loop.push_back({x, y, 1});
  return loop;
}

Loop scaled(Loop loop, double factor) {
  for (Vec3& v : loop) v = {v.x * factor, v.y * factor, v.z * factor};
  return loop;
}

const Loop kSquare = at_one({{-2, -2}, {2, -2}, {2, 2}, {-2, 2}});
const double kUp = std::nextafter(2.0, 3.0);

struct Row {
  const char* name;
  Loop occluder, occludee;
  Relation relation;
};

const Row kRows[] = {
    {"well_inside", kSquare, at_one({{-1, -1}, {1, -1}, {0, 1}}), Relation::inside},
    {"itself", kSquare, kSquare, Relation::inside},
    {"itself_farther_away", kSquare, scaled(kSquare, 3), Relation::inside},
    {"shares_an_edge_from_inside", kSquare, at_one({{-2, -2}, {2, -2}, {0, 1}}), Relation::inside},
    {"part_of_an_edge_from_inside", kSquare, at_one({{-1, -2}, {1, -2}, {0, 1}}), Relation::inside},
    {"corner_on_edge_from_inside", kSquare, at_one({{0, -2}, {1, 1}, {-1, 1}}), Relation::inside},
    {"corners_on_all_edges", kSquare, at_one({{0, -2}, {2, 0}, {0, 2}, {-2, 0}}), Relation::inside},
    {"half_of_it", kSquare, at_one({{-2, -2}, {2, -2}, {2, 2}}), Relation::inside},
    {"corner_one_ulp_beyond", kSquare, at_one({{0, -1}, {kUp, 0}, {0, 1}}), Relation::partial},
    {"across_an_edge", kSquare, at_one({{0, 0}, {4, -1}, {4, 1}}), Relation::partial},
    {"holds_it", kSquare, at_one({{-5, -5}, {5, -5}, {5, 5}, {-5, 5}}), Relation::partial},
    {"holds_it_and_shares_a_corner", kSquare, at_one({{-2, -2}, {5, -2}, {5, 5}, {-2, 5}}), Relation::partial},
    {"star_without_corners_inside", at_one({{0, 2}, {-3, -2}, {3, -2}}), at_one({{0, -3}, {3, 1}, {-3, 1}}),
     Relation::partial},
    {"needle_across", kSquare, at_one({{-5, 0}, {5, -0.125}, {5, 0.125}}), Relation::partial},
    {"shares_an_edge_from_outside", kSquare, at_one({{-2, -2}, {2, -2}, {0, -4}}), Relation::partial},
    {"part_of_an_edge_from_outside", kSquare, at_one({{1, -2}, {5, -2}, {0, -4}}), Relation::partial},
    {"corner_on_edge_from_outside", kSquare, at_one({{0, -2}, {1, -4}, {-1, -4}}), Relation::partial},
    {"edge_on_corner_from_outside", kSquare, at_one({{3, 1}, {1, 3}, {4, 4}}), Relation::partial},
    {"corner_on_corner", kSquare, at_one({{2, 2}, {4, 2}, {4, 4}}), Relation::partial},
    {"corner_one_ulp_away", kSquare, at_one({{kUp, 2}, {4, 2}, {4, 4}}), Relation::outside},
    {"edge_one_ulp_away", kSquare, at_one({{kUp, -2}, {4, -2}, {4, 2}, {kUp, 2}}), Relation::outside},
    {"apart_in_line_with_an_edge", kSquare, at_one({{3, -2}, {5, -2}, {4, 0}}), Relation::outside},
    {"apart_by_no_side_of_one_of_them", kSquare, at_one({{5, 0}, {0, 5}, {5, 5}}), Relation::outside},
    // The cones of the rays x and -x share only their apex, and the apex is not a ray.
    {"behind_the_eye", kSquare, scaled(kSquare, -1), Relation::outside},
    {"behind_the_eye_and_smaller", kSquare, scaled(kSquare, -0.5), Relation::outside},
    {"behind_the_eye_and_across", kSquare, scaled(at_one({{1, 1}, {9, 1}, {1, 9}}), -1), Relation::outside},
    // Both are nearly half-spaces, one above and one below. A plane separates them, but no side of either does.
    {"wide_opposite", {{8, 0, 1}, {-4, 7, 1}, {-4, -7, 1}}, {{-8, 0, -1}, {4, 7, -1}, {4, -7, -1}}, Relation::outside},
    {"wide_opposite_touching",
     {{8, 0, 0}, {-4, 7, 1}, {-4, -7, 1}},
     {{8, 0, 0}, {-4, 7, -1}, {-4, -7, -1}},
     Relation::partial},
    {"wide_opposite_apart_at_that_ray",
     {{8, 0, 0}, {-4, 7, 1}, {-4, -7, 1}},
     {{-8, 0, 0}, {4, 7, -1}, {4, -7, -1}},
     Relation::outside},
    {"wide_and_tilted_holds_what_is_behind",
     {{90, -90, -1}, {90, 90, -1}, {-90, 0, 9}},
     {{70, 9, -0.5}, {70, -9, -0.5}, {70, 0, 1}},
     Relation::inside},
    {"wide_about_the_ray_behind",
     {{8, 0, 1}, {-4, 7, 1}, {-4, -7, 1}},
     {{8, 0, -1}, {-8, 1, 8}, {-8, -1, 8}},
     Relation::partial},
};

class Cones : public testing::TestWithParam<Row> {};

TEST_P(Cones, Relation) {
  const Row& row = GetParam();
  const Viewpoint origin = Viewpoint::eye({0, 0, 0});
  const ConeOverlap overlap = overlap_certified(cone(origin, row.occluder), cone(origin, row.occludee));
  EXPECT_EQ(to_string(overlap.relation), to_string(row.relation));
  EXPECT_EQ(overlap.common.has_value(), row.relation != Relation::outside);
}

/// The loop starts at every corner and turns either way, so the sweep is about another corner each time.
TEST_P(Cones, AnyPivotTellsTheSame) {
  const Row& row = GetParam();
  const Viewpoint origin = Viewpoint::eye({0, 0, 0});
  Loop occludee = row.occludee;
  for (int turned = 0; turned < 2; ++turned) {
    for (std::size_t i = 0; i < occludee.size(); ++i) {
      std::rotate(occludee.begin(), occludee.begin() + 1, occludee.end());
      EXPECT_EQ(overlap_certified(cone(origin, row.occluder), cone(origin, occludee)).relation, row.relation);
    }
    std::reverse(occludee.begin(), occludee.end());
  }
}

TEST_P(Cones, ExchangedTheyStillMeetOrDoNot) {
  const Row& row = GetParam();
  const Viewpoint origin = Viewpoint::eye({0, 0, 0});
  const Relation exchanged = overlap_certified(cone(origin, row.occludee), cone(origin, row.occluder)).relation;
  EXPECT_EQ(exchanged == Relation::outside, row.relation == Relation::outside);
}

TEST_P(Cones, CopiesAgree) {
  const Row& row = GetParam();
  using Copy = Vec3 (*)(const Vec3&);
  const Copy copies[] = {
      [](const Vec3& v) {
        return Vec3{v.y, v.z, v.x};
      },
      [](const Vec3& v) {
        return Vec3{v.y, v.x, v.z};
      },
      [](const Vec3& v) {
        return Vec3{-v.x, v.y, v.z};
      },
      [](const Vec3& v) {
        return Vec3{v.x * 0x1p60, v.y * 0x1p60, v.z * 0x1p60};
      },
      [](const Vec3& v) {
        return Vec3{v.x * 0x1p-90, v.y * 0x1p-90, v.z * 0x1p-90};
      },
  };
  const Viewpoint origin = Viewpoint::eye({0, 0, 0});
  for (const Copy copy : copies) {
    Loop occluder, occludee;
    for (const Vec3& v : row.occluder) occluder.push_back(copy(v));
    for (const Vec3& v : row.occludee) occludee.push_back(copy(v));
    EXPECT_EQ(overlap_certified(cone(origin, occluder), cone(origin, occludee)).relation, row.relation);
  }
}

/// Polygons in the plane z = 1 have the same relation in rays to their points and in rays along z through them.
TEST_P(Cones, PrismsAgreeWithConesOfOnePlane) {
  const Row& row = GetParam();
  Loop occluder = row.occluder, occludee = row.occludee;
  const auto is_in_plane = [](const Vec3& v) { return v.z == 1; };
  if (!std::all_of(occluder.begin(), occluder.end(), is_in_plane)) return;
  if (!std::all_of(occludee.begin(), occludee.end(), is_in_plane)) return;
  for (std::size_t i = 0; i < occludee.size(); ++i) occludee[i].z = static_cast<double>(i) - 7;
  for (const double along : {1.0, -0.25}) {
    const Viewpoint viewpoint = Viewpoint::direction({0, 0, along});
    EXPECT_EQ(overlap_certified(cone(viewpoint, occluder), cone(viewpoint, occludee)).relation, row.relation);
  }
}

INSTANTIATE_TEST_SUITE_P(Rows, Cones, testing::ValuesIn(kRows), [](const auto& row) { return std::string(row.param.name); });

TEST(ViewCone, Refusals) {
  const Viewpoint origin = Viewpoint::eye({0, 0, 0});
  EXPECT_EQ(ViewCone::make(origin, at_one({{0, 0}, {1, 0}})).refusal, Refusal::too_few_vertices);
  EXPECT_EQ(ViewCone::make(origin, Loop{{1, 0, 0}, {0, 1, 0}, {-1, -1, 0}}).refusal, Refusal::eye_in_plane);
  EXPECT_EQ(ViewCone::make(origin, at_one({{0, 0}, {4, 0}, {1, 1}, {0, 4}})).refusal, Refusal::not_convex);
  EXPECT_EQ(ViewCone::make(origin, at_one({{0, 0}, {HUGE_VAL, 0}, {0, 4}})).refusal, Refusal::not_finite);
  EXPECT_EQ(ViewCone::make(Viewpoint::direction({0, 0, 0}), kSquare).refusal, Refusal::zero_direction);
  EXPECT_EQ(ViewCone::make(Viewpoint::eye({0, HUGE_VAL, 0}), kSquare).refusal, Refusal::not_finite);
  const auto cube = *ConvexPolytope::make(lattice::polytopes()[1]).polytope;
  EXPECT_EQ(ViewCone::make(origin, cube).refusal, Refusal::eye_in_polytope);
  EXPECT_EQ(ViewCone::make(Viewpoint::eye({1, 0, 0}), cube).refusal, Refusal::eye_in_polytope);
  EXPECT_EQ(ViewCone::make(Viewpoint::direction({0, 0, 0}), cube).refusal, Refusal::zero_direction);
  EXPECT_EQ(ViewCone::make(Viewpoint::eye({2, 0, 0}), cube).refusal, Refusal::none);
}

TEST(ViewCone, OfPolytopeIsThatOfItsSilhouette) {
  const auto cube = *ConvexPolytope::make(lattice::polytopes()[1]).polytope;
  EXPECT_EQ(ViewCone::make(Viewpoint::eye({3, 0, 0}), cube).cone->corners().size(), 4U);
  EXPECT_EQ(ViewCone::make(Viewpoint::eye({3, 3, 3}), cube).cone->corners().size(), 6U);
  EXPECT_EQ(ViewCone::make(Viewpoint::direction({1, 1, 1}), cube).cone->corners().size(), 6U);
}

TEST(ViewCone, StageTellsWhoDecided) {
  const Viewpoint eye = Viewpoint::eye({0.1, 0.2, 0.3});
  const auto beyond = [&](double x, double y) { return Vec3{0.1 + x, 0.2 + y, 1.3}; };
  const Loop occluder{beyond(-2, -2), beyond(2, -2), beyond(0, 2)};
  const Loop within{beyond(-0.3, -0.4), beyond(0.3, -0.4), beyond(0.2, 0.3)};
  const Loop touching{beyond(-0.3, -0.4), beyond(0.7, -2), beyond(0.2, 0.3)};
  EXPECT_EQ(overlap_certified(cone(eye, occluder), cone(eye, within)).stage, Stage::filter);
  EXPECT_EQ(overlap_certified(cone(eye, occluder), cone(eye, touching)).stage, Stage::exact);
}

// Brute force: two pointed cones share a ray exactly when they share an edge of one or the line in which two sides meet.

using lattice::Vector;

/// The cone as directions from the eye. A prism becomes the cone over its cross-section at height 1.
struct Judged {
  std::vector<Vector> rays, normals;

  Judged(const Viewpoint& viewpoint, std::span<const Vec3> corners) {
    for (const Vec3& corner : corners) rays.push_back(ray(viewpoint, lattice::from_kernel(corner)));
    const std::size_t n = rays.size();
    for (std::size_t i = 0; i < n; ++i) {
      const Vector normal = cross(rays[i], rays[(i + 1) % n]);
      normals.push_back(dot(normal, rays[(i + 2) % n]) > 0 ? normal : -normal);
    }
  }

  static Vector ray(const Viewpoint& viewpoint, const Vector& point) {
    const Vector v = lattice::from_kernel(viewpoint.value);
    if (viewpoint.is_eye()) return point - v;
    const Vector across = v.x != 0 ? Vector{-v.y, v.x, 0} : Vector{1, 0, 0};
    return {dot(across, point), dot(cross(v, across), point), 1};
  }

  [[nodiscard]] bool holds(const Vector& x) const {
    return x != Vector{} && std::all_of(normals.begin(), normals.end(), [&](const Vector& n) { return dot(n, x) >= 0; });
  }
};

Relation by_brute_force(const Judged& occluder, const Judged& occludee) {
  const auto is_in_occluder = [&](const Vector& x) { return occluder.holds(x); };
  const auto is_common = [&](const Vector& x) { return occluder.holds(x) && occludee.holds(x); };
  if (std::all_of(occludee.rays.begin(), occludee.rays.end(), is_in_occluder)) return Relation::inside;
  bool meet = std::any_of(occludee.rays.begin(), occludee.rays.end(), is_in_occluder) ||
              std::any_of(occluder.rays.begin(), occluder.rays.end(), is_common);
  for (const Vector& n : occluder.normals) {
    for (const Vector& m : occludee.normals) meet = meet || is_common(cross(n, m)) || is_common(cross(m, n));
  }
  return meet ? Relation::partial : Relation::outside;
}

/// The ray in integers. Of the two directions of a crossing, the one that both cones hold.
Vector direction(const CommonRay& ray, const Judged& occluder, const Judged& occludee) {
  if (const auto* corner = std::get_if<OccluderCorner>(&ray)) return occluder.rays[corner->corner];
  if (const auto* corner = std::get_if<OccludeeCorner>(&ray)) return occludee.rays[corner->corner];
  const auto& [edge, corner] = std::get<Crossing>(ray);
  const Vector line = cross(occluder.normals[edge], cross(occludee.rays[0], occludee.rays[corner]));
  return occluder.holds(line) ? line : -line;
}

/// A point on a ray that is derived from a loop: through a corner, between two corners, or opposite.
Vec3 derived_point(occlude::fuzz::Random& random, const Viewpoint& viewpoint, const Loop& loop) {
  const auto corner = [&] { return lattice::from_kernel(loop[random.index(loop.size())]); };
  const Vector v = lattice::from_kernel(viewpoint.value), a = corner(), b = corner();
  const int factor = random.integer(1, 2);
  if (!viewpoint.is_eye()) return lattice::to_kernel((random.chance(0.3) ? 2 * a - b : a) + factor * v);
  switch (random.integer(0, 3)) {
    case 0:
      return lattice::to_kernel(v + factor * (a - v));
    case 1:
      return lattice::to_kernel(a + b - v);
    case 2:
      return lattice::to_kernel(v - factor * (a - v));
    default:
      return lattice::to_kernel(2 * a - b);
  }
}

Loop random_occludee(occlude::fuzz::Random& random, const Viewpoint& viewpoint, const Loop& occluder) {
  if (random.chance(0.4)) return lattice::random_polygon(random, 6);
  Loop loop;
  for (int i = 0; i < 3; ++i) {
    loop.push_back(random.chance(0.7) ? derived_point(random, viewpoint, occluder)
                                      : lattice::to_kernel(lattice::random_vector(random, 6)));
  }
  return loop;
}

class BruteForce : public testing::TestWithParam<bool> {};

TEST_P(BruteForce, AgreesOnLatticeCones) {
  constexpr std::uint64_t kCases = 40000;
  std::array<int, 3> answers{}, witnesses{};
  for (std::uint64_t i = 0; i < kCases; ++i) {
    const std::uint64_t seed = std::uint64_t{occlude::seed_of(1)} * kCases + i;
    SCOPED_TRACE("seed " + std::to_string(seed));
    occlude::fuzz::Random random(seed);
    const Vec3 value = lattice::to_kernel(lattice::random_vector(random, GetParam() ? 4 : 2));
    const Viewpoint viewpoint = GetParam() ? Viewpoint::eye(value) : Viewpoint::direction(value);
    const Loop loop = lattice::random_polygon(random, 4);
    const auto occluder = ViewCone::make(viewpoint, loop).cone;
    const auto occludee = ViewCone::make(viewpoint, random_occludee(random, viewpoint, loop)).cone;
    if (!occluder || !occludee) continue;
    const Judged a(viewpoint, occluder->corners()), b(viewpoint, occludee->corners());
    const ConeOverlap overlap = overlap_certified(*occluder, *occludee);
    ASSERT_EQ(to_string(overlap.relation), to_string(by_brute_force(a, b)));
    ++answers[static_cast<std::size_t>(overlap.relation)];
    ASSERT_EQ(overlap.common.has_value(), overlap.relation != Relation::outside);
    if (!overlap.common) continue;
    const Vector common = direction(*overlap.common, a, b);
    ASSERT_TRUE(a.holds(common) && b.holds(common));
    ++witnesses[overlap.common->index()];
  }
  std::printf("inside %d partial %d outside %d; common rays: %d, %d, %d\n", answers[0], answers[1], answers[2], witnesses[0],
              witnesses[1], witnesses[2]);
  for (const int count : answers) EXPECT_GT(count, 500);
  for (const int count : witnesses) EXPECT_GT(count, 200);
}

INSTANTIATE_TEST_SUITE_P(Viewpoints, BruteForce, testing::Values(true, false),
                         [](const auto& is_eye) { return is_eye.param ? "eye" : "direction"; });

/// The number of signs that the sweep asks for on two regular polygons in the plane z = 1.
std::size_t signs_asked(int occluder_corners, int occludee_corners, double radius, double distance, int first,
                        Relation expected) {
  const auto regular = [](int corners, double size, double x, int start) {
    Loop loop;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * std::acos(-1.0) * (i + start) / corners;
      loop.push_back({x + size * std::cos(angle), size * std::sin(angle), 1});
    }
    return loop;
  };
  std::size_t count = 0;
  const auto orientation = [&](const Vec3& p, const Vec3& q, const Vec3& r) {
    ++count;
    const double value = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    return (value > 0) - (value < 0);
  };
  const Loop occluder = regular(occluder_corners, 1, 0, 0), occludee = regular(occludee_corners, radius, distance, first);
  EXPECT_EQ(ConeSweep(orientation, occluder, occludee).overlap().relation, expected);
  return count;
}

TEST(ConeSweep, AsksForSignsLinearInTheEdges) {
  struct Placement {
    const char* name;
    double radius, distance;
    Relation relation;
  };
  const Placement placements[] = {
      {"within", 0.5, 0.25, Relation::inside},           {"about the same", 0.875, 0.1, Relation::inside},
      {"poking out", 0.5, 0.75, Relation::partial},      {"around", 8, 0, Relation::partial},
      {"nearly touching", 1, 2.001, Relation::outside},  {"far", 1, 9, Relation::outside},
      {"large and near", 64, 65.001, Relation::outside},
  };
  double worst = 0;
  for (const auto& [name, radius, distance, relation] : placements) {
    for (int corners = 256; corners <= 16384; corners *= 2) {
      for (const int other : {64, corners}) {
        for (const int first : {0, 7, other / 4, other / 2, other - 3}) {
          SCOPED_TRACE(std::string(name) + ", " + std::to_string(corners) + " and " + std::to_string(other));
          for (const auto& [k, n] : {std::pair{corners, other}, std::pair{other, corners}}) {
            const std::size_t signs = signs_asked(k, n, radius, distance, first, relation);
            worst = std::max(worst, static_cast<double>(signs) / (k + n));
          }
        }
      }
    }
  }
  std::printf("at most %.2f signs an edge\n", worst);
  // The sweep asks k signs for the rim. For each fan it asks at most two turns of two signs per span, and five signs for
  // each corner that is located in it.
  EXPECT_LE(worst, 10);
}

}  // namespace view_cone_test
