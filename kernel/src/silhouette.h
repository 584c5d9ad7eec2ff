// SPDX-License-Identifier: MIT
// The silhouette of a polygon from a viewpoint: its loop, always turned the same way and without vertices at which it
// does not turn.
#pragma once

#include <memory_resource>
#include <span>
#include <vector>

#include "occlude/kernel/types.h"
#include "occlude/kernel/validity.h"
#include "planes.h"

namespace occlude::kernel {

/// The plane through the viewpoint and the edge from -> to; its inner side is where
/// det(from - V, to - V, x - V) >= 0, or det(d, to - from, x - from) >= 0 for a direction d.
[[nodiscard]] ExactPlane side_plane(const Viewpoint& viewpoint, const Vec3& from, const Vec3& to);

struct Silhouette {
  std::pmr::vector<Vec3> corners;  ///< of a strictly convex loop, each on the inner side of every side plane
  Refusal refusal = Refusal::none;
};

/// REQUIRES: all numbers in the legal range.
[[nodiscard]] Silhouette silhouette(const Viewpoint& viewpoint, std::span<const Vec3> loop,
                                    std::pmr::memory_resource& memory);

}  // namespace occlude::kernel
