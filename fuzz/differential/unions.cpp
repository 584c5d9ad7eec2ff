// SPDX-License-Identifier: MIT
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "any_case.h"
#include "cases/ask.h"
#include "cases/to_oracle.h"
#include "experiment.h"
#include "nudge.h"
#include "occlude/fuzz/neighbours.h"
#include "occlude/kernel/shadow_union.h"
#include "rows.h"
#include "verdict.h"

namespace occlude::fuzz {
namespace {

using kernel::Vec3;

/// Cuts a polygon along a line through two corners, or a triangle along the line from a corner to the middle of the opposite
/// side.
std::array<Polygon, 2> cut(Random& random, Polygon polygon) {
  if (polygon.size() == 3) {
    const Vec3 &a = polygon[0], &b = polygon[1];
    polygon.insert(polygon.begin() + 1, {a.x + 0.5 * (b.x - a.x), a.y + 0.5 * (b.y - a.y), a.z + 0.5 * (b.z - a.z)});
    return {Polygon{polygon[0], polygon[1], polygon[3]}, Polygon{polygon[1], polygon[2], polygon[3]}};
  }
  const std::size_t k = 2 + random.index(polygon.size() - 3);
  const auto middle = polygon.begin() + static_cast<std::ptrdiff_t>(k);
  Polygon first(polygon.begin(), middle + 1), second(middle, polygon.end());
  second.push_back(polygon.front());
  return {std::move(first), std::move(second)};
}

/// A parallelogram in the plane of a face that continues the face beyond one of its edges.
Polygon wall_beside(Random& random, const kernel::Polytope& solid) {
  const auto& face = solid.faces[random.index(solid.faces.size())];
  const std::size_t i = random.index(face.size());
  const auto corner = [&](std::size_t k) { return solid.vertices[face[(i + k) % face.size()]]; };
  const Vec3 a = corner(0), b = corner(1), c = corner(2);
  const Vec3 away{b.x - c.x, b.y - c.y, b.z - c.z};
  return {a, b, {b.x + away.x, b.y + away.y, b.z + away.z}, {a.x + away.x, a.y + away.y, a.z + away.z}};
}

/// The two occluders of a question, each as a case. They have the same viewpoint and kind of near plane.
std::array<Case, 2> halves_of(Random& random, const Case& whole) {
  std::array<Case, 2> halves{whole, whole};
  const auto* const polygon = std::get_if<Polygon>(&whole.occluder);
  if (random.chance(0.2)) {
    halves[1].occluder = any_case(random).occluder;
  } else if (polygon) {
    std::array<Polygon, 2> parts = cut(random, *polygon);
    if (random.chance(0.3)) nudge(random, parts[1]);
    for (std::size_t i = 0; i < 2; ++i) halves[i].occluder = std::move(parts[i]);
  } else {
    halves[random.index(2)].occluder = wall_beside(random, std::get<kernel::Polytope>(whole.occluder));
  }
  return halves;
}

struct Pair {
  std::array<Case, 2> halves;
  std::array<kernel::ShadowFrustum, 2> shadows;
  Box box;
};

std::optional<Pair> some_pair(Random& random) {
  const Case whole = any_case(random);
  std::array<Case, 2> halves = halves_of(random, whole);
  auto first = make_frustum(halves[0]), second = make_frustum(halves[1]);
  if (!first.frustum || !second.frustum || check(whole.box) != kernel::Refusal::none) return std::nullopt;
  return Pair{std::move(halves), {std::move(*first.frustum), std::move(*second.frustum)}, whole.box};
}

oracle::Shadow shadow_of(const Case& c, const kernel::ShadowFrustum& frustum) {
  return {to_oracle(c.viewpoint), to_oracle(c.occluder), to_oracle(c.near, {frustum, {}})};
}

}  // namespace

void run_unions(std::uint64_t seed, Report& report) {
  Random random(seed);
  const auto [halves, shadows, touching] = first_legal([&] { return some_pair(random); });
  oracle::Shadow first = shadow_of(halves[0], shadows[0]), second = shadow_of(halves[1], shadows[1]);
  const kernel::ShadowUnion both{shadows[0], shadows[1]};
  for (std::uint64_t i = 0; i < kGroup; ++i) {
    const Box box = i == 0 ? touching : legal_neighbour(random, touching);
    const auto ask = [&](kernel::NearBoundary near) {
      return std::visit([&](const auto& kind) { return kernel::overlap_certified(both, kind, near); }, box);
    };
    const std::string what = "box " + std::to_string(i);
    const kernel::Decision decision = ask(kernel::NearBoundary::closed);
    judge(report, what, decision.relation, decision.stage, first.relation_to_union(second, to_oracle(box)));
    if (ask(kernel::NearBoundary::open).relation != kernel::Relation::inside) continue;
    const std::string refuted = first.refute_union_cull(second, to_oracle(box));
    if (!refuted.empty()) add_finding(report, "certified, near plane open", what + ": inside, but " + refuted);
  }
}

}  // namespace occlude::fuzz
