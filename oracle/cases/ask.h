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

[[nodiscard]] inline kernel::RegionShadowResult make_shadow(const RegionCase& c) {
  if (const auto* const polygon = std::get_if<Polygon>(&c.occluder)) {
    return kernel::RegionShadow::make(c.region, *polygon, c.kind);
  }
  const auto [polytope, refusal] = kernel::ConvexPolytope::make(std::get<kernel::Polytope>(c.occluder));
  if (!polytope) return {std::nullopt, refusal};
  return kernel::RegionShadow::make(c.region, *polytope, c.kind);
}

[[nodiscard]] inline kernel::Refusal check(const Box& box) {
  return std::visit([](const auto& kind) { return kernel::check(kind); }, box);
}

/// Here and below, `shadow` is a ShadowFrustum or a RegionShadow.
template <class Shadow>
[[nodiscard]] kernel::Decision overlap(const Shadow& shadow, const Box& box,
                                       kernel::NearBoundary near = kernel::NearBoundary::closed) {
  return std::visit([&](const auto& kind) { return kernel::overlap_certified(shadow, kind, near); }, box);
}

template <class Shadow>
[[nodiscard]] kernel::Decision conservative(const Shadow& shadow, const Box& box,
                                            kernel::NearBoundary near = kernel::NearBoundary::closed) {
  return std::visit([&](const auto& kind) { return kernel::conservative_certified(shadow, kind, near); }, box);
}

template <class Shadow>
[[nodiscard]] kernel::Relation overlap_plain(const Shadow& shadow, const Box& box) {
  return std::visit([&](const auto& kind) { return kernel::overlap_plain(shadow, kind); }, box);
}

}  // namespace occlude::cases
