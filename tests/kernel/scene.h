// SPDX-License-Identifier: MIT
// A case put to the kernel, whatever the kinds of its occluder and its box.
#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "occlude/fuzz/cases.h"
#include "occlude/kernel/overlap.h"

namespace occlude {

inline kernel::ShadowFrustumResult make_frustum(const fuzz::Case& c) {
  if (const auto* const polygon = std::get_if<std::vector<kernel::Vec3>>(&c.occluder)) {
    return kernel::ShadowFrustum::make(c.viewpoint, *polygon, c.near);
  }
  const auto made = kernel::ConvexPolytope::make(std::get<kernel::Polytope>(c.occluder));
  if (!made.polytope) return {std::nullopt, made.refusal};
  return kernel::ShadowFrustum::make(c.viewpoint, *made.polytope, c.near);
}

inline kernel::Refusal check(const fuzz::Box& box) {
  return std::visit([](const auto& kind) { return kernel::check(kind); }, box);
}

inline kernel::Decision overlap(const kernel::ShadowFrustum& frustum, const fuzz::Box& box) {
  return std::visit([&](const auto& kind) { return kernel::overlap_certified(frustum, kind); }, box);
}

inline kernel::Decision conservative(const kernel::ShadowFrustum& frustum, const fuzz::Box& box) {
  return std::visit([&](const auto& kind) { return kernel::conservative_certified(frustum, kind); }, box);
}

}  // namespace occlude
