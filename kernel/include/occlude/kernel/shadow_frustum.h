// SPDX-License-Identifier: MIT
// The shadow frustum of an occluder (section 5 of the paper): what a convex polygon or polytope hides from a viewpoint.
// Reading order: 5.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

#include "occlude/kernel/convex_polytope.h"
#include "occlude/kernel/half_space.h"
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
struct StoredFrustum;

/// The shadow of a convex occluder as an intersection of half-spaces: the near side, and one side plane for each edge of the
/// silhouette. It has no far plane. A default-constructed frustum is none (is_none()).
class ShadowFrustum {
 public:
  ShadowFrustum();
  /// A copy by assignment reuses the memory of the frustum assigned to. What is moved from is none.
  ShadowFrustum(const ShadowFrustum& other);
  ShadowFrustum(ShadowFrustum&& other) noexcept;
  ShadowFrustum& operator=(const ShadowFrustum& other);
  ShadowFrustum& operator=(ShadowFrustum&& other) noexcept;
  ~ShadowFrustum();

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

  /// Derives the planes that `overlap` tests of axis-aligned boxes ask, beside the frustum's own. make() has done so. After
  /// assign() such tests give the same answers, but derive these planes anew each time. Does nothing if is_none().
  void prepare_overlap();

  /// Whether there is no frustum: none was made yet, or it was moved from. Then every test answers `partial`, and the
  /// other members are empty or mean nothing.
  [[nodiscard]] bool is_none() const;

  /// Reserves memory for `count` planes, those that the tests derive from the frustum included, and for as many corners of
  /// the silhouette and edges and vertices of the near side. Frusta within these numbers need no more.
  void reserve(std::size_t count);

  [[nodiscard]] Viewpoint viewpoint() const;
  /// The corners of the silhouette, without repeated and collinear ones, clockwise seen from the viewpoint (right-handed
  /// axes). Side i passes through corners i and i + 1, cyclically.
  [[nodiscard]] std::span<const Vec3> silhouette() const;
  /// Planes of the near side and of the sides, which are numbered in this order.
  [[nodiscard]] std::size_t plane_count() const;
  /// Planes of the near side: the turned faces of a polytope with Near::surface, else 1.
  [[nodiscard]] std::size_t near_count() const;
  /// Plane i as a half-space: n . (x - origin()) + offset >= 0. It is relative to origin(), rounded and scaled: good for
  /// margins and pictures, not for exact answers. REQUIRES: i < plane_count().
  [[nodiscard]] HalfSpace rounded_plane(std::size_t i) const;
  /// The eye, or silhouette()[0] for a direction.
  [[nodiscard]] Vec3 origin() const;
  /// The near plane chosen for Near::surface if the polygon is not exactly coplanar, else none.
  [[nodiscard]] const std::optional<SupportPlane>& support_plane() const;

 private:
  friend const StoredFrustum* stored(const ShadowFrustum& frustum);

  [[nodiscard]] StoredFrustum& own();
  [[nodiscard]] const StoredFrustum& own() const;

  /// A StoredFrustum in place, because a pointer to one would be one more step to what each test reads. It has
  /// seven vectors of three pointers each, and 176 bytes of numbers.
  static constexpr std::size_t kBytes = 344;
  alignas(std::max_align_t) std::byte stored_[kBytes];
};

/// A frustum, or why there is none.
struct ShadowFrustumResult {
  std::optional<ShadowFrustum> frustum;
  Refusal refusal = Refusal::none;
};

}  // namespace occlude::kernel
