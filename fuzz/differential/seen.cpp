// SPDX-License-Identifier: MIT
#include <algorithm>
#include <optional>
#include <variant>
#include <vector>

#include "any_case.h"
#include "cases/ask.h"
#include "cases/to_oracle.h"
#include "experiment.h"
#include "occlude/fuzz/neighbours.h"
#include "occlude/kernel/polytope_overlap.h"
#include "occlude/kernel/view_cone.h"
#include "occlude/oracle/questions.h"
#include "rows.h"
#include "verdict.h"

namespace occlude::fuzz {
namespace {

using kernel::Aabb;
using kernel::Polytope;
using kernel::Vec3;
using kernel::ViewCone;

/// Corner i is at the high end of axis k when bit k of i is set.
std::vector<Vec3> aabb_corners(const Aabb& box) {
  std::vector<Vec3> corners;
  for (unsigned i = 0; i < 8; ++i) {
    corners.push_back({(i & 1U ? box.max : box.min).x, (i & 2U ? box.max : box.min).y, (i & 4U ? box.max : box.min).z});
  }
  return corners;
}

Polytope polytope_of(const Aabb& box) {
  return {aabb_corners(box), {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
}

Polytope tetrahedron_of(Random& random, const Aabb& box) {
  const std::vector<Vec3> corners = aabb_corners(box);
  Polytope result{{}, {{0, 1, 2}, {0, 3, 1}, {1, 3, 2}, {2, 3, 0}}};
  for (int i = 0; i < 4; ++i) result.vertices.push_back(corners[random.index(8)]);
  return result;
}

Polygon face_of(Random& random, const Aabb& box) {
  const Polytope whole = polytope_of(box);
  Polygon face;
  for (const std::uint32_t i : whole.faces[random.index(whole.faces.size())]) face.push_back(whole.vertices[i]);
  return face;
}

/// A triangle of three of its vertices.
Polygon part_of(Random& random, const Occluder& occluder) {
  const std::vector<Vec3>& vertices = vertices_of(occluder);
  Polygon part;
  for (int i = 0; i < 3; ++i) part.push_back(vertices[random.index(vertices.size())]);
  return part;
}

Occluder some_occludee(Random& random, const Case& c) {
  const Box box = random.chance(0.5) ? c.box : neighbour(c.box, random.bits());
  const auto* const aabb = std::get_if<Aabb>(&box);
  switch (random.integer(0, aabb ? 5 : 2)) {
    case 0:
      return c.occluder;
    case 1:
      return part_of(random, c.occluder);
    case 2:
      return any_case(random).occluder;
    case 3:
      return face_of(random, *aabb);
    case 4:
      return tetrahedron_of(random, *aabb);
    default:
      return polytope_of(*aabb);
  }
}

std::optional<ViewCone> cone_of(const kernel::Viewpoint& viewpoint, const Occluder& object) {
  if (const auto* const polygon = std::get_if<Polygon>(&object)) return ViewCone::make(viewpoint, *polygon).cone;
  const auto made = kernel::ConvexPolytope::make(std::get<Polytope>(object));
  return made.polytope ? ViewCone::make(viewpoint, *made.polytope).cone : std::nullopt;
}

/// Compares the corners of the silhouette with the oracle's. Two vertices of a polygon that is not coplanar may be seen as
/// one.
std::string silhouette_fault(const Case& c, const ViewCone& cone) {
  const oracle::Outline outline = oracle::outline(to_oracle(c.viewpoint), to_oracle(c.occluder));
  if (!outline.refusal.empty()) return "the oracle refuses: " + outline.refusal;
  std::vector<oracle::Point> corners = to_oracle(Polygon(cone.corners().begin(), cone.corners().end()));
  std::ranges::sort(corners);
  if (!std::ranges::includes(outline.corners, corners)) return "a corner that is none";
  if (corners.size() == outline.corners.size()) return "";
  const oracle::Shadow flat(to_oracle(c.viewpoint), to_oracle(c.occluder), to_oracle(Near::surface));
  return flat.refusal().empty() ? "a corner is missing" : "";
}

/// A group is full long before this, unless the kernel refuses what it should not.
constexpr std::uint64_t kMostTries = 100 * kGroup;

}  // namespace

void run_cones(std::uint64_t seed, Report& report) {
  Random random(seed);
  const Case c = any_legal_case(random);
  const std::optional<ViewCone> occluder = cone_of(c.viewpoint, c.occluder);
  if (!occluder) return add_finding(report, "refusal", "a cone is refused, its frustum is not");
  const std::string fault = silhouette_fault(c, *occluder);
  if (!fault.empty()) add_finding(report, "silhouette", fault);
  for (std::uint64_t i = 0, tries = 0; i < kGroup && tries < kMostTries; ++tries) {
    const Occluder object = some_occludee(random, c);
    const oracle::Answer truth = oracle::cone_relation(to_oracle(c.viewpoint), to_oracle(c.occluder), to_oracle(object));
    const std::optional<ViewCone> occludee = cone_of(c.viewpoint, object);
    if (occludee.has_value() != truth.refusal.empty()) {
      add_finding(report, "refusal", "the oracle: " + (occludee ? truth.refusal : "none"));
    }
    if (!occludee) continue;
    const kernel::ConeOverlap answer = kernel::overlap_certified(*occluder, *occludee);
    judge(report, "occludee " + std::to_string(i++), answer.relation, answer.stage, truth);
  }
}

void run_occludees(std::uint64_t seed, Report& report) {
  Random random(seed);
  const Case c = any_legal_case(random);
  const auto made = make_frustum(c);
  oracle::Shadow shadow(to_oracle(c.viewpoint), to_oracle(c.occluder), to_oracle(c.near, made));
  for (std::uint64_t i = 0, tries = 0; i < kGroup && tries < kMostTries; ++tries) {
    const Occluder object = some_occludee(random, c);
    const auto* const given = std::get_if<Polytope>(&object);
    if (!given) continue;
    const oracle::Answer truth = shadow.relation(to_oracle(*given));
    const auto occludee = kernel::ConvexPolytope::make(*given);
    if (occludee.polytope.has_value() != truth.refusal.empty()) {
      add_finding(report, "refusal", "the oracle: " + (occludee.polytope ? truth.refusal : "none"));
    }
    if (!occludee.polytope) continue;
    const kernel::Decision answer = kernel::overlap_certified(*made.frustum, *occludee.polytope);
    judge(report, "occludee " + std::to_string(i++), answer.relation, answer.stage, truth);
  }
}

}  // namespace occlude::fuzz
