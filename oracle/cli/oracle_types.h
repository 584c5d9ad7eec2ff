// SPDX-License-Identifier: MIT
// The oracle shares no types with the kernel: the translation.
#pragma once

#include <span>
#include <vector>

#include "occlude/kernel/shadow_frustum.h"
#include "occlude/oracle/oracle.h"

namespace occlude::cli {

[[nodiscard]] inline oracle::Point to_oracle(const kernel::Vec3& v) { return {v.x, v.y, v.z}; }
[[nodiscard]] inline oracle::Viewpoint to_oracle(const kernel::Viewpoint& v) { return {to_oracle(v.value), !v.is_eye()}; }
[[nodiscard]] inline oracle::Aabb to_oracle(const kernel::Aabb& box) { return {to_oracle(box.min), to_oracle(box.max)}; }

[[nodiscard]] inline oracle::Loop to_oracle(std::span<const kernel::Vec3> points) {
  oracle::Loop result;
  for (const kernel::Vec3& v : points) result.push_back(to_oracle(v));
  return result;
}

[[nodiscard]] inline oracle::Near to_oracle(kernel::Near near) {
  using Kind = oracle::Near::Kind;
  return {near == kernel::Near::farthest ? Kind::farthest : Kind::surface, {}, {}};
}

[[nodiscard]] inline oracle::Near to_oracle(const kernel::SupportPlane& plane) {
  return {oracle::Near::Kind::plane, to_oracle(plane.normal), to_oracle(plane.point)};
}

}  // namespace occlude::cli
