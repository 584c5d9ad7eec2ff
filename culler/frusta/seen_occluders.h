// SPDX-License-Identifier: MIT
// Several potential occluders at once: which of them are in view, and how large they look.
#pragma once

#include <hwy/cache_control.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>

#include "frusta/potential_occluders.h"
#include "occlude/culler/camera.h"

namespace occlude::culler {

/// At most 32 potential occluders, and what is known of them. Each array has a value for each.
struct SeenOccluders {
  static constexpr std::size_t kMost = 32;
  using Doubles = std::array<double, kMost>;

  /// Replaces them with `count` of all potential occluders; occluder_at(k) is the number of one. REQUIRES: count <= kMost.
  template <class Occluders, class OccluderAt>
  void assign(const Occluders& all, std::size_t count, const OccluderAt& occluder_at) {
    for (std::size_t k = 0; k < count; ++k) hwy::Prefetch(&all[occluder_at(k)]);
    size = 0;
    for (std::size_t k = 0; k < count; ++k) add(all[occluder_at(k)]);
  }
  void add(const PotentialOccluder& occluder);
  /// Computes the members that follow `round_area`.
  void see(const glm::dvec3& eye, std::span<const HalfSpace> view);

  std::size_t size = 0;
  alignas(64) std::array<Doubles, 3> centre{}, normal{};  ///< by axis; `normal` is PotentialOccluder::area_normal
  alignas(64) Doubles radius{}, round_area{};

  alignas(64) Doubles angle;  ///< PotentialOccluder::area_angle(eye)
  /// A bit for each occluder, unless the ball around it is beyond a half-space. This is a heuristic: rounding may give
  /// either answer.
  std::uint32_t in_view = 0;
};

}  // namespace occlude::culler
