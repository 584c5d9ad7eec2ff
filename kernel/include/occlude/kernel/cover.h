// SPDX-License-Identifier: MIT
// Joined shadows: what a set of polygons hides together, of any shape and in any place. Reading order: 15.
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

/// Polygons that hide together, seen from a viewpoint. Each is what is drawn of it, its fan of triangles, so it need not be
/// convex or flat. A point is in their shadow when the open segment from the viewpoint to it, or the open ray that ends in
/// it along a direction of view, meets one of them. May be asked on several threads at once.
class Cover {
 public:
  using Polygon = std::vector<Vec3>;

  /// Refuses numbers that are not finite or out of range, a polygon of fewer than three vertices, a zero direction. A
  /// polygon may be degenerate, be seen edge-on or hold the viewpoint. With `drawn` only what of the polygons lies in that
  /// half-space hides, and polygons seen edge-on hide nothing.
  [[nodiscard]] static CoverResult make(const Viewpoint& viewpoint, std::span<const Polygon> polygons,
                                        const std::optional<HalfSpace>& drawn = {});

  [[nodiscard]] const CoverParts& parts() const { return *parts_; }

 private:
  explicit Cover(std::shared_ptr<const CoverParts> parts) : parts_(std::move(parts)) {}

  std::shared_ptr<const CoverParts> parts_;
};

struct CoverResult {
  std::optional<Cover> cover;  ///< none where the input is refused
  Refusal refusal = Refusal::none;
};

/// `inside` when every point of the box is in the shadow, else `partial`, exactly. The time grows with the square of the
/// number of polygons before the box, and with the pieces into which they cut it. A box of which check() is not
/// Refusal::none is `partial`. REQUIRES: rounding to nearest (validity.h), as when the cover was made.
///
/// Properties:
/// (1) What is on a polygon is not in its shadow. A box that holds the viewpoint is in no shadow.
/// (2) The answer depends on the sets of points alone: the order of the polygons, repeated polygons and vertices, permuted
///     axes, mirror images, scaling by a power of two and exact translation change nothing.
/// (3) More polygons hide no less. A box within another that is `inside` is `inside`.
[[nodiscard]] Decision overlap_certified(const Cover& cover, const Aabb& box);
[[nodiscard]] Decision overlap_certified(const Cover& cover, const Obb& box);

}  // namespace occlude::kernel
