// SPDX-License-Identifier: MIT
// Which inputs the kernel answers for, and the reasons for which it refuses the others. Reading order: 2.
//
// What checks: everything that makes something of its input, ShadowFrustum, ConvexPolytope, ViewCone and Cover, and the
// questions about a Cover. They refuse and say why. What does not: questions about boxes, points and half-spaces, which are
// asked millions of times a second. They REQUIRE check() == Refusal::none of what they are given. Of other numbers their
// answers mean nothing, but nothing is read or written out of place, whatever the numbers are.
//
// Rounding: everything REQUIRES that the processor rounds to nearest, as it does unless told otherwise; in other modes error
// bounds and exact sums are void. What checks its input checks that too, and refuses. So a program that runs in another mode
// has nothing to ask about. A program that changes the mode between making and asking has to change it back.
#pragma once

#include <bit>
#include <cstdint>
#include <limits>
#include <span>
#include <string_view>

#include "occlude/kernel/types.h"

namespace occlude::kernel {

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
  rounding_mode,
};

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
    case Refusal::rounding_mode:
      return "processor does not round to nearest";
  }
  return "";
}

/// The exact stage works on products of up to six differences of coordinates. With every magnitude 0 or in this range the
/// smallest non-zero difference is 2^-152, so the tiniest term of such a product is at least 2^-912 and the largest at most
/// 2^(6 * 101 + 12): neither underflows (2^-1022) nor overflows (2^1024).
inline constexpr double kMinMagnitude = 0x1p-100;
inline constexpr double kMaxMagnitude = 0x1p+100;

/// Refusal::rounding_mode while the calling thread's additions are not rounded to nearest: asked of the additions
/// themselves, for whoever sets the mode may have told the processor alone and not the library of C. Takes a nanosecond.
[[nodiscard]] Refusal check_rounding();

/// By the bits, which order magnitudes as numbers do: whoever embeds the kernel may have set the processor to take the
/// smallest numbers for zero, or have told the compiler that there is no infinity.
[[nodiscard]] inline Refusal check(double x) {
  constexpr auto bits = [](double number) { return std::bit_cast<std::uint64_t>(number) & ~(std::uint64_t{1} << 63U); };
  const std::uint64_t magnitude = bits(x);
  if (magnitude >= bits(std::numeric_limits<double>::infinity())) return Refusal::not_finite;
  const bool is_legal = magnitude == 0 || (magnitude >= bits(kMinMagnitude) && magnitude <= bits(kMaxMagnitude));
  return is_legal ? Refusal::none : Refusal::out_of_range;
}

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

[[nodiscard]] inline Refusal check(const Viewpoint& viewpoint) {
  if (const Refusal refusal = check(viewpoint.value); refusal != Refusal::none) return refusal;
  return !viewpoint.is_eye() && viewpoint.value == Vec3{} ? Refusal::zero_direction : Refusal::none;
}

[[nodiscard]] inline Refusal check(const Aabb& box) {
  for (const Vec3& corner : {box.min, box.max}) {
    if (const Refusal refusal = check(corner); refusal != Refusal::none) return refusal;
  }
  for (int axis = 0; axis < 3; ++axis) {
    if (box.min[axis] > box.max[axis]) return Refusal::min_above_max;
  }
  return Refusal::none;
}

[[nodiscard]] inline Refusal check(const Obb& box) {
  if (const Refusal refusal = check(box.center); refusal != Refusal::none) return refusal;
  return check(box.half_edges);
}

}  // namespace occlude::kernel
