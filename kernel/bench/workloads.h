// SPDX-License-Identifier: MIT
// The workloads of the benchmark: one shadow frustum of five planes and many boxes near it. The same seed gives the same
// boxes on any machine.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "occlude/kernel/shadow_frustum.h"
#include "occlude/kernel/types.h"

namespace occlude::bench {

/// The frustum is the shadow of an exactly coplanar parallelogram, seen from an eye, with near plane `surface`. So the
/// silhouette is the border of the near face.
struct Workload {
  std::string name, about;
  kernel::ShadowFrustum frustum;
  std::vector<kernel::Aabb> boxes;
};

inline constexpr std::uint64_t kDefaultSeed = 1997;

/// Four workloads of `boxes` boxes each:
/// - `random`: boxes of all sizes, scattered about the frustum; none touches it.
/// - `integer_touching`: all coordinates are whole numbers; every box touches a plane, an edge or a vertex of the frustum.
/// - `ulp_touching`: every box touches in the same ways up to rounding, and is then moved by -2 to 2 ulps on each axis.
/// - `decimal`: the frustum and boxes like those of `integer_touching`, each coordinate divided by 100 and rounded.
[[nodiscard]] std::vector<Workload> make_workloads(std::size_t boxes, std::uint64_t seed);

}  // namespace occlude::bench
