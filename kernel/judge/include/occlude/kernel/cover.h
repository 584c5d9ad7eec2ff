// SPDX-License-Identifier: MIT
// Joined shadows: what a set of polygons of any shape hides together, which the paper leaves open (section 4). Reading
// order: 15.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "occlude/kernel/half_space.h"
#include "occlude/kernel/overlap.h"
#include "occlude/kernel/types.h"
#include "occlude/kernel/validity.h"

namespace occlude::kernel {

struct CoverResult;
struct CoverParts;

/// Polygons that hide together, seen from a viewpoint. Each counts as it is drawn, as its fan of triangles (v0, vi, vi+1),
/// so it need not be convex or planar. A point is in their shadow if one of them meets the open segment from the eye to the
/// point; for a direction of view, the ray that ends in the point, without the point. A cover never changes, and copies
/// share its data. A cover that was moved from may only be assigned to or destroyed.
class Cover {
 public:
  using Polygon = std::vector<Vec3>;

  /// Makes a cover of any number of polygons; of none it hides nothing.
  /// 1. Refuses numbers that are not legal (not_finite, out_of_range), a polygon of fewer than three vertices, repeated ones
  ///    counted (too_few_vertices), a direction of view or a normal of `drawn` that is zero (zero_direction), and
  ///    rounding_mode.
  /// 2. A polygon may be degenerate, be seen edge-on or contain the viewpoint.
  /// 3. With `drawn`, only the parts of the polygons in that half-space hide, and triangles seen edge-on hide nothing.
  [[nodiscard]] static CoverResult make(const Viewpoint& viewpoint, std::span<const Polygon> polygons,
                                        const std::optional<HalfSpace>& drawn = {});

  /// Internal.
  [[nodiscard]] const CoverParts& parts() const { return *parts_; }

 private:
  explicit Cover(std::shared_ptr<const CoverParts> parts) : parts_(std::move(parts)) {}

  std::shared_ptr<const CoverParts> parts_;
};

/// A cover, or why there is none.
struct CoverResult {
  std::optional<Cover> cover;
  Refusal refusal = Refusal::none;
};

/// `inside` if every point of the box is in the shadow, else `partial`; exactly, and never `outside`. A box that check()
/// refuses is `partial`. The time grows with the square of the number of polygons in front of the box, and with the number
/// of pieces into which they cut it. Allocates. REQUIRES: rounding to nearest (validity.h).
///
/// Properties:
/// (1) A point on a polygon is not in the shadow of that polygon. A box that contains the eye is `partial`.
/// (2) The relation depends on the point sets alone: the order of the polygons, repeated polygons and vertices, permuting
///     axes, mirroring, scaling by a power of two and exact translation change nothing.
/// (3) Adding polygons never turns `inside` into `partial`. A box within a box that is `inside` is `inside`.
[[nodiscard]] Decision overlap_certified(const Cover& cover, const Aabb& box);
[[nodiscard]] Decision overlap_certified(const Cover& cover, const Obb& box);

}  // namespace occlude::kernel
