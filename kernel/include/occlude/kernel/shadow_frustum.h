// SPDX-License-Identifier: MIT
// The shadow frustum of an occluder (section 5 of the paper): what a convex polygon or polytope hides from a viewpoint.
// Reading order: 5.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "occlude/kernel/convex_polytope.h"
#include "occlude/kernel/half_space.h"
#include "occlude/kernel/planes.h"
#include "occlude/kernel/polytope_silhouette.h"
#include "occlude/kernel/types.h"
#include "occlude/kernel/validity.h"

namespace occlude::kernel {

/// Where the shadow begins.
/// `farthest` (the paper's): at the plane through the silhouette vertex p farthest from the eye, normal to the line from the
/// eye to p; farthest along the direction of view for orthographic views. On a tie the lowest index in the input counts.
/// `surface` (tighter): at the occluder itself. A polygon that is not exactly coplanar is drawn as its fan of triangles; its
/// shadow begins at a support plane beyond all its vertices.
enum class Near { farthest, surface };

/// The near plane as numbers, for those who prove a cull from the outside: shadow where normal . (x - point) >= 0.
struct SupportPlane {
  Vec3 normal, point;

  friend bool operator==(const SupportPlane&, const SupportPlane&) = default;
};

struct ShadowFrustumResult;

class ShadowFrustum {
 public:
  /// An edge of the near side that is an edge of the occluder, between the planes `left` and `right`, whose normals have a
  /// cross product in the direction from -> to.
  struct CapEdge {
    Vec3 from, to;
    std::uint32_t left, right;

    friend bool operator==(const CapEdge&, const CapEdge&) = default;
  };

  /// Builds the frustum of the convex polygon `loop` (in order, either way round) seen from `viewpoint`, any number of
  /// sides. Everything is decided exactly; repeated vertices and vertices in line with their neighbours change nothing.
  /// Refuses, with the reason, non-finite or out-of-range numbers, fewer than three distinct silhouette vertices, a loop
  /// that is not convex seen from the viewpoint, a viewpoint in the polygon's plane, a zero direction, and every frustum
  /// while the processor does not round to nearest (validity.h).
  [[nodiscard]] static ShadowFrustumResult make(const Viewpoint& viewpoint, std::span<const Vec3> loop, Near near);

  /// Builds the frustum of a convex polytope. Its silhouette runs between faces turned to the viewpoint and faces that are
  /// not; a face seen edge-on is not turned to it. Refuses non-finite or out-of-range numbers, a viewpoint in the polytope,
  /// a zero direction, and every frustum while the processor does not round to nearest.
  [[nodiscard]] static ShadowFrustumResult make(const Viewpoint& viewpoint, const ConvexPolytope& polytope, Near near);

  /// The same into a frustum that is there, whose memory is used again: from frame to frame nothing is allocated. Returns
  /// why there is no such frustum; then this one is what it was. `seen`, of this polytope, is moved on to the viewpoint.
  [[nodiscard]] Refusal assign(const Viewpoint& viewpoint, std::span<const Vec3> loop, Near near);
  [[nodiscard]] Refusal assign(const Viewpoint& viewpoint, const ConvexPolytope& polytope, Near near,
                               PolytopeSilhouette& seen);

  /// Whether there is no frustum here: none was made yet, or it was moved elsewhere. Then it hides nothing: every test
  /// answers `partial`.
  [[nodiscard]] bool is_none() const { return plane_count_ == 0; }

  /// Makes room for so many planes, sides and faces: up to that assign() allocates nothing even the first time.
  void reserve(std::size_t planes);

  [[nodiscard]] const Viewpoint& viewpoint() const { return viewpoint_; }
  /// What the planes in doubles are relative to: the eye, or a corner of the silhouette for directions.
  [[nodiscard]] const Vec3& origin() const { return origin_; }
  /// The corners that matter, clockwise seen from the viewpoint (right-handed axes): side i passes through corners i, i + 1.
  [[nodiscard]] std::span<const Vec3> silhouette() const { return silhouette_; }

  /// The planes of the frustum, those of the near side first, then one a side; after them those of its profile along the
  /// coordinate axes (profile.h), in three forms.
  [[nodiscard]] std::span<const PlaneRecipe> recipes() const { return recipes_; }
  [[nodiscard]] std::span<const FilterPlane> filter_planes() const { return filter_planes_; }
  [[nodiscard]] std::span<const RefinedPlane> refined_planes() const { return refined_planes_; }
  /// The bounds of the planes of the frustum and of those of its profile.
  [[nodiscard]] const FilterBound& filter_bound() const { return filter_bound_; }
  [[nodiscard]] const FilterBound& profile_bound() const { return profile_bound_; }
  /// Plane i as n . (x - origin()) + offset >= 0, rounded and scaled: for margins and pictures, not for answers.
  [[nodiscard]] HalfSpace rounded_plane(std::size_t i) const { return {filter_planes_[i].normal, filter_planes_[i].offset}; }
  [[nodiscard]] std::size_t near_count() const { return near_count_; }
  [[nodiscard]] std::size_t plane_count() const { return plane_count_; }

  /// Whether the near side is a plane that cuts the frustum's edges, and not the occluder.
  [[nodiscard]] bool is_cut() const { return cap_edges_.empty(); }
  /// Edges and vertices of the near side when it is the occluder, else none.
  [[nodiscard]] std::span<const CapEdge> cap_edges() const { return cap_edges_; }
  [[nodiscard]] std::span<const Vec3> cap_vertices() const { return cap_vertices_; }
  /// The support plane chosen for `surface` when the polygon is not exactly coplanar.
  [[nodiscard]] const std::optional<SupportPlane>& support_plane() const { return support_plane_; }

 private:
  /// A number that a move leaves at zero, as it leaves a vector empty.
  class Count {
   public:
    Count(std::size_t value = 0) : value_(value) {}  // NOLINT(google-explicit-constructor): a number like any other
    Count(const Count&) = default;
    Count& operator=(const Count&) = default;
    Count(Count&& other) noexcept : value_(std::exchange(other.value_, 0)) {}
    Count& operator=(Count&& other) noexcept {
      value_ = std::exchange(other.value_, 0);
      return *this;
    }
    ~Count() = default;
    operator std::size_t() const { return value_; }  // NOLINT(google-explicit-constructor)

   private:
    std::size_t value_;
  };

  void begin(const Viewpoint& viewpoint, std::span<const Vec3> corners);
  void add_sides();
  void finish();

  Viewpoint viewpoint_;
  Vec3 origin_;
  std::vector<Vec3> silhouette_;
  Count near_count_, plane_count_;
  std::vector<PlaneRecipe> recipes_;
  std::vector<FilterPlane> filter_planes_;
  std::vector<RefinedPlane> refined_planes_;
  FilterBound filter_bound_, profile_bound_;
  std::vector<CapEdge> cap_edges_;
  std::vector<Vec3> cap_vertices_;
  std::optional<SupportPlane> support_plane_;
};

/// A frustum, or why there is none.
struct ShadowFrustumResult {
  std::optional<ShadowFrustum> frustum;
  Refusal refusal = Refusal::none;
};

}  // namespace occlude::kernel
