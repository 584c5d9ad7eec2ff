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
/// eye to p. For a direction of view: through the vertex farthest along it, normal to it. Of equally far vertices the first
/// in the input counts.
/// `surface` (tighter): at the occluder itself: the plane of the polygon, or the faces of the polytope that are turned to
/// the viewpoint. For a polygon that is not exactly coplanar, at a support plane: no vertex lies beyond it, so neither does
/// any triangle of the fan that is drawn.
enum class Near { farthest, surface };

/// A near plane as exact numbers, for proofs of a cull by other programs: shadow where normal . (x - point) >= 0. The normal
/// has no particular length.
struct SupportPlane {
  Vec3 normal, point;

  friend bool operator==(const SupportPlane&, const SupportPlane&) = default;
};

struct ShadowFrustumResult;

/// The shadow of a convex occluder as an intersection of half-spaces: the near side, and one side plane for each edge of the
/// silhouette. It has no far plane. A default-constructed frustum is none (is_none()).
class ShadowFrustum {
 public:
  /// An edge of the near side that is an edge of the occluder. N_left x N_right points from `from` to `to`, N being normals
  /// of the planes `left` and `right`, which are indices in recipes().
  struct CapEdge {
    Vec3 from, to;
    std::uint32_t left, right;

    friend bool operator==(const CapEdge&, const CapEdge&) = default;
  };

  /// Builds the frustum of the convex polygon `loop`, given in order, either way round, with any number of vertices. All
  /// decisions are exact. Repeated vertices, and vertices collinear with their neighbours, change nothing. Refuses
  /// 1. numbers that are not legal (not_finite, out_of_range), zero_direction and rounding_mode;
  /// 2. fewer than three distinct vertices (too_few_vertices);
  /// 3. an eye at a vertex, or a loop seen edge-on, as all collinear loops are (eye_in_plane);
  /// 4. a loop that is not convex as seen from the viewpoint (not_convex). It need not be coplanar.
  [[nodiscard]] static ShadowFrustumResult make(const Viewpoint& viewpoint, std::span<const Vec3> loop, Near near);

  /// Builds the frustum of a convex polytope. Its silhouette separates the faces turned to the viewpoint from the others; a
  /// face seen edge-on is not turned. Refuses a viewpoint that is not legal (not_finite, out_of_range, zero_direction), an
  /// eye in the polytope or on its surface (eye_in_polytope), and rounding_mode.
  [[nodiscard]] static ShadowFrustumResult make(const Viewpoint& viewpoint, const ConvexPolytope& polytope, Near near);

  /// As make(), into an existing frustum, whose memory is reused. Returns the refusal of make(), or Refusal::none.
  /// 1. On refusal the frustum is unchanged. After std::bad_alloc it may only be assigned to or destroyed.
  /// 2. Allocates only if the frustum or `seen` needs more memory than it has, or the loop has more than 32 vertices.
  /// 3. `seen` is moved to the viewpoint (PolytopeSilhouette::update()), also on Refusal::eye_in_polytope.
  /// REQUIRES: `loop` is not memory of this frustum; `seen` has been used for this polytope alone since its clear().
  [[nodiscard]] Refusal assign(const Viewpoint& viewpoint, std::span<const Vec3> loop, Near near);
  [[nodiscard]] Refusal assign(const Viewpoint& viewpoint, const ConvexPolytope& polytope, Near near,
                               PolytopeSilhouette& seen);

  /// Whether there is no frustum: none was made yet, or it was moved from. Then every test answers `partial`, and the
  /// other members are empty or mean nothing.
  [[nodiscard]] bool is_none() const { return plane_count_ == 0; }

  /// Reserves memory for so many elements of each of recipes(), silhouette(), cap_edges() and cap_vertices(). Frusta within
  /// these numbers need no more.
  void reserve(std::size_t planes);

  [[nodiscard]] const Viewpoint& viewpoint() const { return viewpoint_; }
  /// The point that filter_planes() and refined_planes() are relative to: the eye, or silhouette()[0] for a direction.
  [[nodiscard]] const Vec3& origin() const { return origin_; }
  /// The corners of the silhouette, without repeated and collinear ones, clockwise seen from the viewpoint (right-handed
  /// axes). Side i passes through corners i and i + 1, cyclically.
  [[nodiscard]] std::span<const Vec3> silhouette() const { return silhouette_; }

  /// The planes, in three forms of the same size and order: exact, in doubles, and what the doubles lost. First near_count()
  /// planes of the near side, then one per side, plane_count() in all; after these the planes of the profile along the
  /// coordinate axes (profile.h).
  [[nodiscard]] std::span<const PlaneRecipe> recipes() const { return recipes_; }
  [[nodiscard]] std::span<const FilterPlane> filter_planes() const { return filter_planes_; }
  [[nodiscard]] std::span<const RefinedPlane> refined_planes() const { return refined_planes_; }
  /// Error bounds of the first plane_count() planes, and of the planes of the profile.
  [[nodiscard]] const FilterBound& filter_bound() const { return filter_bound_; }
  [[nodiscard]] const FilterBound& profile_bound() const { return profile_bound_; }
  /// Filter plane i as a half-space: n . (x - origin()) + offset >= 0. It is relative to origin(), rounded and scaled: good
  /// for margins and pictures, not for exact answers. REQUIRES: i < filter_planes().size().
  [[nodiscard]] HalfSpace rounded_plane(std::size_t i) const { return {filter_planes_[i].normal, filter_planes_[i].offset}; }
  /// Planes of the near side: the turned faces of a polytope with Near::surface, else 1.
  [[nodiscard]] std::size_t near_count() const { return near_count_; }
  /// Planes of the frustum: near side and sides, without the profile.
  [[nodiscard]] std::size_t plane_count() const { return plane_count_; }

  /// Whether the near side is a single plane that cuts the edges of the frustum, and not the occluder itself.
  [[nodiscard]] bool is_cut() const { return cap_edges_.empty(); }
  /// The edges of the near side if it is the occluder, else none.
  [[nodiscard]] std::span<const CapEdge> cap_edges() const { return cap_edges_; }
  /// The corners of the polygon, or all vertices of the polytope, if the near side is the occluder; else none.
  [[nodiscard]] std::span<const Vec3> cap_vertices() const { return cap_vertices_; }
  /// The near plane chosen for Near::surface if the polygon is not exactly coplanar, else none.
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
