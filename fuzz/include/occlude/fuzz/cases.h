// SPDX-License-Identifier: MIT
// Cases of the kernel's question, made from a seed, in families that each aim at one way of being wrong.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "occlude/kernel/shadow_frustum.h"
#include "occlude/kernel/types.h"

namespace occlude::fuzz {

using kernel::Near;

/// One question: how does `box` lie to the shadow frustum of `polygon` seen from `viewpoint`?
struct Case {
  kernel::Viewpoint viewpoint;
  std::vector<kernel::Vec3> polygon;
  Near near = Near::farthest;
  kernel::Aabb box;
};

/// What each is: fuzz/README.md.
enum class Family {
  random,
  lattice,
  face_touch,
  ray_touch,
  near_touch,
  corner_touch,
  ulp_lattice,
  ulp_random,
  flat_box,
  needle_box,
  point_box,
  eye_in_box,
  sliver,
  sliver_lattice,
  many_sided,
  collinear,
  equal_farthest,
  far_offset,
  tiny_scale,
  huge_scale,
  decimal,
  non_coplanar,
  orthographic,
  orthographic_touch,
  orthographic_ulp,
};

[[nodiscard]] std::span<const Family> families();

[[nodiscard]] std::string_view name(Family family);

/// The same case for the same arguments, on every machine. A few in a hundred are not legal (see the README).
[[nodiscard]] Case make_case(Family family, std::uint64_t seed);

}  // namespace occlude::fuzz
