// SPDX-License-Identifier: MIT
// Cases of the kernel's question, made from a seed. Each family of cases aims at one way of being wrong.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "occlude/fuzz/case.h"

namespace occlude::fuzz {

/// fuzz/README.md describes the families. The name says what kind a family is: with `obb` the box is oriented, with
/// `polytope` the occluder is a polytope, with `orthographic` the viewpoint is a direction.
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
  wide_frustum,
  wide_frustum_ulp,
  axis_aligned_faces,
  shared_vertex,
  edge_crossing,
  edge_crossing_ulp,
  edge_crossing_random,
  orthographic_axis_aligned,
  orthographic_edge_crossing,
  obb_random,
  obb_lattice,
  obb_flat,
  obb_needle,
  obb_point,
  obb_dependent,
  obb_axis,
  obb_ulp,
  obb_parallel,
  obb_parallel_ulp,
  obb_about_eye,
  obb_shared_vertex,
  obb_edge_crossing,
  obb_edge_crossing_ulp,
  obb_wide_frustum,
  obb_sliver,
  obb_many_sided,
  obb_decimal,
  obb_far_offset,
  obb_tiny_scale,
  obb_huge_scale,
  obb_orthographic,
  obb_orthographic_touch,
  obb_orthographic_parallel,
  obb_orthographic_ulp,
  polytope_random,
  polytope_box,
  polytope_hull,
  polytope_near,
  polytope_edge_on,
  polytope_ulp,
  polytope_many,
  polytope_equal_farthest,
  polytope_wide_frustum,
  polytope_edge_crossing,
  polytope_shared_vertex,
  polytope_decimal,
  polytope_far_offset,
  polytope_tiny_scale,
  polytope_huge_scale,
  polytope_orthographic,
  polytope_orthographic_touch,
  polytope_orthographic_edge_on,
  polytope_orthographic_ulp,
  obb_polytope,
  obb_polytope_random,
  obb_polytope_near,
  obb_polytope_edge_on,
  obb_polytope_edge_crossing,
  obb_polytope_ulp,
  obb_polytope_orthographic,
  hair,
  obb_hair,
  polytope_hair,
  edge_on,
  cospherical,
  any_scale,
  obb_any_scale,
  polytope_any_scale,
  long_box,
  obb_long_box,
  polytope_long_box,
  edge_at_eye,
  obb_edge_at_eye,
  obb_orthographic_long,
};

[[nodiscard]] std::span<const Family> families();

[[nodiscard]] std::string_view name(Family family);

/// Makes a case. The same arguments give the same case on every machine. A few in a hundred are not legal (README.md).
[[nodiscard]] Case make_case(Family family, std::uint64_t seed);

}  // namespace occlude::fuzz
