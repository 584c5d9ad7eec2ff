// SPDX-License-Identifier: MIT
// What an occluder hides from a region of viewpoints, answered as exactly as the questions of oracle.h.
#pragma once

#include <memory>
#include <string>

#include "occlude/oracle/oracle.h"

namespace occlude::oracle {

/// Where the eye may be, or the direction of view when at_infinity: in a box whose half edges may be any vectors.
struct ViewRegion {
  Obb box;
  bool at_infinity = false;
};

/// Of the shadows, one from each viewpoint of a region, that begin at the occluder: their intersection or their union.
enum class ShadowKind { umbra, penumbra };

struct PreparedRegionShadow;

/// The umbra or the penumbra of an occluder, prepared for many boxes. Several threads may use different shadows. Only one
/// thread at a time may use a shadow.
class RegionShadow {
 public:
  /// Refuses numbers that are not in range, a polygon that is not convex or not coplanar, or whose plane the region meets,
  /// a polytope that is not convex or not closed or that an eye is in, and a region of directions that contains zero.
  RegionShadow(const ViewRegion& region, const Occluder& occluder, ShadowKind kind);
  ~RegionShadow();
  RegionShadow(RegionShadow&& other) noexcept;
  RegionShadow& operator=(RegionShadow&& other) noexcept;

  /// Why there is no shadow. Empty when there is one.
  [[nodiscard]] const std::string& refusal() const;

  /// Relation of `box` to the shadow, or the reason why the region, the occluder or the box is refused.
  [[nodiscard]] Answer relation(const Box& box);

  /// Whether a point of the box is on the plane of a face of the occluder at which the shadow begins, or before it: a face
  /// turned to some viewpoint of the region, or, for a penumbra, to all. REQUIRES: relation() has no refusal.
  [[nodiscard]] bool reaches_surface(const Box& box);

 private:
  std::unique_ptr<PreparedRegionShadow> prepared_;
};

}  // namespace occlude::oracle
