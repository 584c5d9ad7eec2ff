// SPDX-License-Identifier: MIT
// Puts a case to the kernel, for any kind of occluder and box.
#pragma once

#include <optional>
#include <variant>

#include "cases/case.h"
#include "occlude/kernel/overlap.h"

namespace occlude::cases {

[[nodiscard]] inline kernel::ShadowFrustumResult make_frustum(const Case& c) {
  if (const auto* const polygon = std::get_if<Polygon>(&c.occluder)) {
    return kernel::ShadowFrustum::make(c.viewpoint, *polygon, c.near);
  }
  const auto [polytope, refusal] = kernel::ConvexPolytope::make(std::get<kernel::Polytope>(c.occluder));
  if (!polytope) return {std::nullopt, refusal};
  return kernel::ShadowFrustum::make(c.viewpoint, *polytope, c.near);
}

[[nodiscard]] inline kernel::Refusal check(const Box& box) {
  return std::visit([](const auto& kind) { return kernel::check(kind); }, box);
}

[[nodiscard]] inline kernel::Decision overlap(const kernel::ShadowFrustum& frustum, const Box& box,
                                              kernel::NearBoundary near = kernel::NearBoundary::closed) {
  return std::visit([&](const auto& kind) { return kernel::overlap_certified(frustum, kind, near); }, box);
}

[[nodiscard]] inline kernel::Decision conservative(const kernel::ShadowFrustum& frustum, const Box& box,
                                                   kernel::NearBoundary near = kernel::NearBoundary::closed) {
  return std::visit([&](const auto& kind) { return kernel::conservative_certified(frustum, kind, near); }, box);
}

[[nodiscard]] inline kernel::Relation overlap_plain(const kernel::ShadowFrustum& frustum, const Box& box) {
  return std::visit([&](const auto& kind) { return kernel::overlap_plain(frustum, kind); }, box);
}

}  // namespace occlude::cases
