// SPDX-License-Identifier: MIT
// What is measured on: one shadow frustum of five planes and many boxes about it. Same seed, same boxes, on any machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "occlude/kernel/shadow_frustum.h"
#include "occlude/kernel/types.h"

namespace occlude::bench {

/// The frustum is that of a parallelogram, exactly coplanar, seen from an eye, with near `surface`: the silhouette is the
/// border of the near face.
struct Workload {
  std::string name, about;
  kernel::ShadowFrustum frustum;
  std::vector<kernel::Aabb> boxes;
};

inline constexpr std::uint64_t kDefaultSeed = 1997;

/// Three workloads of `boxes` boxes each:
/// `random`: boxes of all sizes strewn about the frustum; nothing touches.
/// `integer_touching`: all coordinates are whole numbers; every box touches a plane, an edge or a vertex of the frustum.
/// `ulp_touching`: every box touches in the same ways up to rounding, then moved by -2 to 2 ulps on each axis.
[[nodiscard]] std::vector<Workload> make_workloads(std::size_t boxes, std::uint64_t seed);

}  // namespace occlude::bench
