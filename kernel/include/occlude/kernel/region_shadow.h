// SPDX-License-Identifier: MIT
// What a convex occluder hides from a region of eyes: from all of them, the umbra, or from at least one, the penumbra.
// Reading order: 12.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <utility>

#include "occlude/kernel/convex_polytope.h"
#include "occlude/kernel/overlap.h"
#include "occlude/kernel/types.h"
#include "occlude/kernel/validity.h"

namespace occlude::kernel {

/// Where the scene is seen from: any eye in a box, or any direction of view in a box of directions. The half edges of the
/// box may be any vectors, also zero: with three of them zero the region is one viewpoint.
struct ViewRegion {
  Viewpoint::Kind kind = Viewpoint::Kind::eye;
  Obb box;

  static ViewRegion eyes(const Obb& box) { return {Viewpoint::Kind::eye, box}; }
  static ViewRegion directions(const Obb& box) { return {Viewpoint::Kind::direction, box}; }
  friend bool operator==(const ViewRegion&, const ViewRegion&) = default;
};

/// From each viewpoint of the region the shadow is the one that begins at the occluder (Near::surface): every point whose
/// closed segment to the eye, or closed ray against the direction, meets the occluder. The `umbra` is the intersection of
/// these shadows, the `penumbra` their union. Both are convex and contain the occluder. The umbra may end: where the region
/// is larger than the occluder, it is bounded.
enum class ShadowKind { umbra, penumbra };

struct RegionShadowResult;
struct StoredRegionShadow;

/// The umbra or the penumbra of a convex occluder as an intersection of half-spaces: the near side and the other sides. A
/// shadow never changes, and copies share its data. One that was moved from may only be assigned to or destroyed.
class RegionShadow {
 public:
  /// Makes the shadow of the convex polygon `loop`, given in order, either way round, or of a convex polytope. All decisions
  /// are exact. Repeated vertices, and vertices collinear with their neighbours, change nothing. Refuses
  /// 1. numbers that are not legal (not_finite, out_of_range), the direction zero alone (zero_direction) and rounding_mode;
  /// 2. fewer than three distinct vertices (too_few_vertices), a loop that is not convex (not_convex), and one that is not
  ///    exactly in one plane (not_coplanar);
  /// 3. a region that meets the plane of the polygon, and collinear vertices (eye_in_plane);
  /// 4. a region of eyes that meets the polytope (eye_in_polytope), and a region of directions that contains zero
  ///    (zero_direction).
  [[nodiscard]] static RegionShadowResult make(const ViewRegion& region, std::span<const Vec3> loop, ShadowKind kind);
  [[nodiscard]] static RegionShadowResult make(const ViewRegion& region, const ConvexPolytope& polytope, ShadowKind kind);

  /// Planes of the near side and of the other sides. Of an umbra, the near side are the faces turned to some viewpoint of
  /// the region, and there is one other side for each edge between these and the rest: as many planes as a shadow from one
  /// viewpoint has. Of a penumbra, the near side are the faces turned to all viewpoints.
  [[nodiscard]] std::size_t plane_count() const;
  [[nodiscard]] std::size_t near_count() const;

  /// Internal.
  [[nodiscard]] const StoredRegionShadow& stored() const { return *stored_; }

 private:
  explicit RegionShadow(std::shared_ptr<const StoredRegionShadow> stored) : stored_(std::move(stored)) {}

  std::shared_ptr<const StoredRegionShadow> stored_;
};

/// A shadow, or why there is none.
struct RegionShadowResult {
  std::optional<RegionShadow> shadow;
  Refusal refusal = Refusal::none;
};

/// Relation of `box` to the shadow. Properties (1) to (4) of overlap.h hold, and
/// (5) the relation to the umbra of a region is `inside` if and only if it is `inside` the shadow from each corner of the
///     region; a smaller region has a larger umbra and a smaller penumbra;
/// (6) of a region of one viewpoint, umbra and penumbra are the shadow frustum with Near::surface.
/// Where several planes cut the box, the time of `overlap` may grow with the cube of their number.
/// `overlap` may allocate. REQUIRES (not checked): check(box) == Refusal::none, and rounding to nearest (validity.h).
[[nodiscard]] Decision overlap_certified(const RegionShadow& shadow, const Aabb& box,
                                         NearBoundary near = NearBoundary::closed);
[[nodiscard]] Decision overlap_certified(const RegionShadow& shadow, const Obb& box,
                                         NearBoundary near = NearBoundary::closed);
[[nodiscard]] Decision conservative_certified(const RegionShadow& shadow, const Aabb& box,
                                              NearBoundary near = NearBoundary::closed);
[[nodiscard]] Decision conservative_certified(const RegionShadow& shadow, const Obb& box,
                                              NearBoundary near = NearBoundary::closed);
[[nodiscard]] Relation overlap_plain(const RegionShadow& shadow, const Aabb& box, NearBoundary near = NearBoundary::closed);
[[nodiscard]] Relation overlap_plain(const RegionShadow& shadow, const Obb& box, NearBoundary near = NearBoundary::closed);

}  // namespace occlude::kernel
