// SPDX-License-Identifier: MIT
// Which inputs are legal, and the reasons for refusing others. Reading order: 2. For the whole kernel:
//
// 1. These check their input, and refuse it with a reason: make() and assign() of ShadowFrustum, make() of ConvexPolytope,
//    ViewCone and Cover. Questions about a Cover check the box.
// 2. Nothing else checks: BoxBatch, PolytopeSilhouette, and all other questions about boxes, points and half-spaces, which
//    are asked millions of times a second. They REQUIRE check() == Refusal::none for what they are given. With other numbers
//    the answer means nothing, but no memory is read or written out of bounds.
// 3. Everything REQUIRES rounding to nearest, the default of every processor; otherwise error bounds and exact sums do not
//    hold. What checks its input (1) also checks the rounding mode, and refuses. Questions do not check it: a program that
//    changes the mode must restore it before it asks.
// 4. Refusals are returned, not thrown. The only exception ever thrown is std::bad_alloc, when memory runs out.
// 5. There is no shared mutable state. Const members, and functions of const arguments, may run on several threads at once.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include "occlude/kernel/types.h"

namespace occlude::kernel {

/// Why an input is refused; `none`: it is legal. Where several reasons apply, one of them is given.
enum class Refusal {
  none,
  not_finite,
  out_of_range,
  min_above_max,
  too_few_vertices,
  not_convex,
  eye_in_plane,
  zero_direction,
  bad_face_index,
  polytope_not_convex,
  polytope_not_closed,
  eye_in_polytope,
  not_coplanar,
  rounding_mode,
};

/// The reason in English, for messages; empty for `none`.
[[nodiscard]] constexpr std::string_view to_string(Refusal refusal) {
  switch (refusal) {
    case Refusal::none:
      return "";
    case Refusal::not_finite:
      return "number is not finite";
    case Refusal::out_of_range:
      return "number out of range: magnitude must be 0 or in [2^-100, 2^100]";
    case Refusal::min_above_max:
      return "box has min > max";
    case Refusal::too_few_vertices:
      return "fewer than 3 distinct silhouette vertices";
    case Refusal::not_convex:
      return "loop is not convex seen from the viewpoint";
    case Refusal::eye_in_plane:
      return "viewpoint lies in the occluder's plane";
    case Refusal::zero_direction:
      return "direction of view is zero";
    case Refusal::bad_face_index:
      return "face names a vertex that does not exist";
    case Refusal::polytope_not_convex:
      return "polytope is not convex with plane faces";
    case Refusal::polytope_not_closed:
      return "polytope is not closed";
    case Refusal::eye_in_polytope:
      return "viewpoint lies in the polytope";
    case Refusal::not_coplanar:
      return "vertices of the polygon are not in one plane";
    case Refusal::rounding_mode:
      return "processor does not round to nearest";
  }
  return "";
}

/// A legal number is 0 or has a magnitude in [kMinMagnitude, kMaxMagnitude]. Then two numbers that differ do so by at least
/// 2^-152. The exact stage multiplies up to six such differences: the terms of the products lie between 2^-912 and
/// 2^(6 * 101 + 12), and neither underflow (2^-1022) nor overflow (2^1024). Covers (cover.h) use longer integers instead.
inline constexpr double kMinMagnitude = 0x1p-100;
inline constexpr double kMaxMagnitude = 0x1p+100;

/// The number, or 0 if it is nearer to it than any legal one.
[[nodiscard]] inline double flushed(double x) { return std::fabs(x) < kMinMagnitude ? 0 : x; }

/// Refusal::rounding_mode if the calling thread does not round to nearest, else Refusal::none. It tests real additions,
/// since the mode may have been set without `<cfenv>`. Takes about a nanosecond.
[[nodiscard]] Refusal check_rounding();

/// Whether the number is legal: not_finite, out_of_range or none. It compares bits, which order magnitudes as numbers do, so
/// that it holds also where the processor flushes subnormals to zero or the compiler assumes that numbers are finite.
[[nodiscard]] inline Refusal check(double x) {
  constexpr auto bits = [](double number) { return std::bit_cast<std::uint64_t>(number) & ~(std::uint64_t{1} << 63U); };
  const std::uint64_t magnitude = bits(x);
  if (magnitude >= bits(std::numeric_limits<double>::infinity())) return Refusal::not_finite;
  const bool is_legal = magnitude == 0 || (magnitude >= bits(kMinMagnitude) && magnitude <= bits(kMaxMagnitude));
  return is_legal ? Refusal::none : Refusal::out_of_range;
}

/// Points: every coordinate must be legal.
[[nodiscard]] inline Refusal check(const Vec3& v) {
  for (int axis = 0; axis < 3; ++axis) {
    if (const Refusal refusal = check(v[axis]); refusal != Refusal::none) return refusal;
  }
  return Refusal::none;
}

[[nodiscard]] inline Refusal check(std::span<const Vec3> points) {
  for (const Vec3& point : points) {
    if (const Refusal refusal = check(point); refusal != Refusal::none) return refusal;
  }
  return Refusal::none;
}

/// Legal coordinates, and a direction that is not zero.
[[nodiscard]] inline Refusal check(const Viewpoint& viewpoint) {
  if (const Refusal refusal = check(viewpoint.value); refusal != Refusal::none) return refusal;
  return !viewpoint.is_eye() && viewpoint.value == Vec3{} ? Refusal::zero_direction : Refusal::none;
}

/// Legal coordinates, and min <= max on every axis.
[[nodiscard]] inline Refusal check(const Aabb& box) {
  for (const Vec3& corner : {box.min, box.max}) {
    if (const Refusal refusal = check(corner); refusal != Refusal::none) return refusal;
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (box.min[axis] > box.max[axis]) return Refusal::min_above_max;
  }
  return Refusal::none;
}

/// Legal centre and half edges. The corners, which are sums of these, need not be legal numbers.
[[nodiscard]] inline Refusal check(const Obb& box) {
  if (const Refusal refusal = check(box.center); refusal != Refusal::none) return refusal;
  return check(box.half_edges);
}

}  // namespace occlude::kernel
