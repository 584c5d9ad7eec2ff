// SPDX-License-Identifier: MIT
// The vector algebra that workloads and peers need, in plain doubles.
#pragma once

#include "occlude/kernel/types.h"

namespace occlude::bench {

using kernel::Vec3;

[[nodiscard]] inline Vec3 operator+(const Vec3& a, const Vec3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
[[nodiscard]] inline Vec3 operator-(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
[[nodiscard]] inline Vec3 operator*(double s, const Vec3& v) { return {s * v.x, s * v.y, s * v.z}; }
[[nodiscard]] inline double dot(const Vec3& a, const Vec3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
[[nodiscard]] inline Vec3 cross(const Vec3& a, const Vec3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

[[nodiscard]] inline Vec3 center(const kernel::Aabb& box) { return 0.5 * (box.min + box.max); }
[[nodiscard]] inline Vec3 half_extents(const kernel::Aabb& box) { return 0.5 * (box.max - box.min); }

/// Corner i of the box has the maximum on axis k when bit k of i is set, else the minimum.
[[nodiscard]] inline Vec3 corner(const kernel::Aabb& box, unsigned i) {
  return {i & 1U ? box.max.x : box.min.x, i & 2U ? box.max.y : box.min.y, i & 4U ? box.max.z : box.min.z};
}

}  // namespace occlude::bench
