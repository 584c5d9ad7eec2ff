// SPDX-License-Identifier: MIT
// The judge answers the kernel's questions in exact arithmetic and is written from the definitions alone. It shares no code
// with the kernel. No type of the arithmetic library appears in this header.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <variant>
#include <vector>

namespace occlude::oracle {

using Point = std::array<double, 3>;

struct Viewpoint {
  Point value{};  ///< the eye, or the direction of view when at_infinity
  bool at_infinity = false;
};

/// The vertices of a convex polygon in order, in either direction.
using Loop = std::vector<Point>;

/// A convex polytope. Faces are loops of indices into `vertices`, in either direction.
struct Polytope {
  std::vector<Point> vertices;
  std::vector<std::vector<std::uint32_t>> faces;
};

using Occluder = std::variant<Loop, Polytope>;

/// The near side of a shadow frustum.
struct Near {
  enum class Kind { farthest, surface, plane };
  Kind kind = Kind::farthest;
  Point normal{}, point{};  ///< for `plane` only: the shadow is where normal . (x - point) >= 0
};

/// Axis-aligned box.
struct Aabb {
  Point min{}, max{};
};

/// Oriented box {center + a half_edges[0] + b half_edges[1] + g half_edges[2] : |a|, |b|, |g| <= 1}. The half edges may be
/// any vectors.
struct Obb {
  Point center{};
  std::array<Point, 3> half_edges{};

  friend bool operator==(const Obb&, const Obb&) = default;
};

using Box = std::variant<Aabb, Obb>;

enum class Relation { inside, partial, outside };

struct Answer {
  std::string refusal;  ///< empty when there is an answer, else the reason why there is none
  Relation relation = Relation::partial;
};

struct Prepared;

/// The shadow frustum of an occluder, prepared for many boxes: what one box needs is computed once and kept for the next.
/// Several threads may use different shadows. Only one thread at a time may use a shadow.
class Shadow {
 public:
  /// Near `surface` is refused for a polygon that is not exactly coplanar, because the definition does not fix its plane.
  /// Pass a `plane` instead.
  Shadow(const Viewpoint& view, const Occluder& occluder, const Near& near);
  ~Shadow();
  Shadow(Shadow&& other) noexcept;
  Shadow& operator=(Shadow&& other) noexcept;

  /// Why there is no frustum. Empty when there is one.
  [[nodiscard]] const std::string& refusal() const;

  /// Relation of `box` to the frustum, or the reason why the occluder or the box is refused.
  [[nodiscard]] Answer relation(const Box& box);

  /// Relation of a convex polytope to the frustum. The viewpoint may be in the polytope.
  [[nodiscard]] Answer relation(const Polytope& occludee);

  /// Relation of `box` to the union of this frustum and the other: inside when every point is in at least one of them.
  [[nodiscard]] Answer relation_to_union(Shadow& other, const Box& box);

  /// Proves that `box` is in the frustum and strictly beyond its near planes, and that no corner is nearer than `margin` to
  /// any plane of the frustum. A near `plane` must be sound for the occluder: normal . vertex <= normal . point for every
  /// vertex, and the viewpoint is strictly on the near side. Returns an empty string when all of this holds, else what
  /// failed. REQUIRES: `margin` is finite and >= 0.
  [[nodiscard]] std::string refute_cull(const Box& box, double margin = 0);

  /// Proves that every point of `box` is in one of the two frusta and strictly beyond the near planes of that one. Near
  /// planes must be sound as above. Returns an empty string when this holds, else what failed. REQUIRES: both shadows are of
  /// one viewpoint.
  [[nodiscard]] std::string refute_union_cull(Shadow& other, const Box& box);

 private:
  std::unique_ptr<Prepared> prepared_;
};

/// Shadow::relation() for one box.
[[nodiscard]] Answer relation(const Viewpoint& view, const Occluder& occluder, const Near& near, const Box& box);

/// Shadow::refute_cull() for one box.
[[nodiscard]] std::string refute_shadow_cull(const Viewpoint& view, const Occluder& occluder, const Near& near,
                                             const Box& box);

/// Proves that every point of `box` has a*x + b*y + c*z + d < 0, and that no corner is nearer than `margin` to that plane.
/// The numbers of the plane are 0 or of a magnitude in [2^-100, 2^100]. Returns an empty string when all of this holds, else
/// what failed. REQUIRES: `margin` is finite and >= 0.
[[nodiscard]] std::string refute_view_cull(const std::array<double, 4>& plane, const Box& box, double margin = 0);

/// Whether `point` is in `box`, exactly. A box with min > max or with a number that is not finite contains nothing.
/// REQUIRES: the point is finite.
[[nodiscard]] bool contains(const Box& box, const Point& point);

}  // namespace occlude::oracle
