// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "any_case.h"
#include "cases/ask.h"
#include "cases/to_oracle.h"
#include "experiment.h"
#include "occlude/fuzz/neighbours.h"
#include "occlude/kernel/view_frustum.h"
#include "occlude/oracle/questions.h"
#include "rows.h"
#include "verdict.h"

namespace occlude::fuzz {
namespace {

using kernel::HalfSpace;
using kernel::Vec3;
using HalfSpaces = std::vector<HalfSpace>;

/// The time of the test grows with the cube of their number.
constexpr std::size_t kMostPlanes = 12;

double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

bool is_legal(const HalfSpace& h) {
  return kernel::check(h.normal) == kernel::Refusal::none && kernel::check(h.offset) == kernel::Refusal::none;
}

/// The planes of the frustum as the filter has them. They may be rounded.
HalfSpaces planes_of(const kernel::ShadowFrustum& frustum) {
  HalfSpaces planes;
  for (std::size_t i = 0; i < frustum.plane_count(); ++i) {
    const HalfSpace plane = frustum.rounded_plane(i);
    planes.push_back({plane.normal, plane.offset - dot(plane.normal, frustum.origin())});
  }
  return planes;
}

/// A half-space that faces the first plane, with a point of the box on its plane or inside.
HalfSpace far_plane(Random& random, const HalfSpace& near, const Box& box) {
  const auto* const aabb = std::get_if<kernel::Aabb>(&box);
  const Vec3 point = aabb ? aabb->max : std::get<kernel::Obb>(box).center;
  const Vec3 normal{-near.normal.x, -near.normal.y, -near.normal.z};
  return {normal, -dot(normal, point) + (random.chance(0.5) ? 0 : std::abs(near.offset))};
}

struct View {
  HalfSpaces half_spaces;
  Box box;
};

/// Half-spaces with a common point: those of a shadow, and perhaps a far plane.
std::optional<View> some_view(Random& random) {
  const Case c = any_legal_case(random);
  HalfSpaces view = planes_of(*make_frustum(c).frustum);
  if (random.chance(0.5)) {
    const HalfSpace& near = view.front();
    const HalfSpace far = far_plane(random, near, c.box);
    // There is room between the two planes, and the shadow has points there because it has no far end.
    if (far.offset + near.offset > 1e-3 * std::abs(near.offset)) view.push_back(far);
  }
  if (view.size() > kMostPlanes || !std::ranges::all_of(view, is_legal)) return std::nullopt;
  return View{std::move(view), c.box};
}

std::vector<oracle::HalfSpaceCoefficients> coefficients(const HalfSpaces& view) {
  std::vector<oracle::HalfSpaceCoefficients> result;
  for (const HalfSpace& h : view) result.push_back({h.normal.x, h.normal.y, h.normal.z, h.offset});
  return result;
}

}  // namespace

void run_view_frusta(std::uint64_t seed, Report& report) {
  Random random(seed);
  const auto [half_spaces, touching] = first_legal([&] { return some_view(random); });
  const HalfSpaces& view = half_spaces;
  const auto judged = coefficients(view);
  for (std::uint64_t i = 0; i < kGroup / 2; ++i) {
    const Box box = i == 0 ? touching : legal_neighbour(random, touching);
    const std::size_t one = random.index(view.size());
    const auto ask_all = [&](const auto& kind) { return kernel::overlap_certified(view, kind); };
    const auto ask_one = [&](const auto& kind) { return kernel::relation(view[one], kind, kernel::Arithmetic::certified); };
    const kernel::Decision all = std::visit(ask_all, box);
    judge(report, "box " + std::to_string(i), all.relation, all.stage,
          oracle::relation_to_half_spaces(judged, to_oracle(box)));
    judge(report, "box " + std::to_string(i) + ", half-space " + std::to_string(one), std::visit(ask_one, box), std::nullopt,
          oracle::relation_to_half_spaces({&judged[one], 1}, to_oracle(box)));
  }
}

}  // namespace occlude::fuzz
