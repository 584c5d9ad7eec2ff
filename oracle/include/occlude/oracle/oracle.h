// SPDX-License-Identifier: MIT
// The judge: the kernel's questions answered in exact arithmetic, written from the definitions alone.
// It shares no code with the kernel, and no type of the arithmetic library shows here.
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

/// The vertices of a convex polygon in order, either way round.
using Loop = std::vector<Point>;

/// A convex polytope: faces are loops of indices into `vertices`, either way round.
struct Polytope {
  std::vector<Point> vertices;
  std::vector<std::vector<std::uint32_t>> faces;
};

using Occluder = std::variant<Loop, Polytope>;

/// The near side of a shadow frustum.
struct Near {
  enum class Kind { farthest, surface, plane };
  Kind kind = Kind::farthest;
  Point normal{}, point{};  ///< `plane` only: shadow where normal . (x - point) >= 0
};

/// Axis-aligned box.
struct Aabb {
  Point min{}, max{};
};

/// Oriented box {center + a half_edges[0] + b half_edges[1] + g half_edges[2] : |a|, |b|, |g| <= 1}, whatever the half
/// edges.
struct Obb {
  Point center{};
  std::array<Point, 3> half_edges{};
};

using Box = std::variant<Aabb, Obb>;

enum class Relation { inside, partial, outside };

struct Answer {
  std::string refusal;  ///< empty when there is an answer, else why there is none
  Relation relation = Relation::partial;
};

struct Prepared;

/// The shadow frustum of an occluder, prepared for many boxes: what is computed for one box is kept for the next. Different
/// shadows may be asked in different threads, one only by one thread at a time.
class Shadow {
 public:
  /// Near `surface` of a polygon that is not exactly coplanar is refused (the definition leaves the plane open: pass
  /// `plane`).
  Shadow(const Viewpoint& view, const Occluder& occluder, const Near& near);
  ~Shadow();
  Shadow(Shadow&& other) noexcept;
  Shadow& operator=(Shadow&& other) noexcept;

  /// Why there is no frustum; empty when there is one.
  [[nodiscard]] const std::string& refusal() const;

  /// Relation of `box` to the frustum, or the reason for refusing the case, the box's faults included.
  [[nodiscard]] Answer relation(const Box& box);

  /// Relation of a convex polytope to the frustum; the viewpoint may lie in it.
  [[nodiscard]] Answer relation(const Polytope& occludee);

  /// Relation of `box` to the union of this frustum and the other: inside when every point is in one of them or in both.
  [[nodiscard]] Answer relation_to_union(Shadow& other, const Box& box);

  /// Proof that `box` lies in the frustum and strictly beyond its near planes, a given `plane` being sound for the occluder
  /// (normal . vertex <= normal . point for every vertex, and the viewpoint strictly on the near side); and that no corner
  /// is nearer than `margin` to any of its planes. Empty when proved, else what failed. REQUIRES: margin >= 0, finite.
  [[nodiscard]] std::string refute_cull(const Box& box, double margin = 0);

  /// Proof that every point of `box` lies in one of the two frusta and strictly beyond the near planes of that one, given
  /// planes being sound as above. Empty when proved, else what failed. REQUIRES: the shadows are of one viewpoint.
  [[nodiscard]] std::string refute_union_cull(Shadow& other, const Box& box);

 private:
  std::unique_ptr<Prepared> prepared_;
};

/// Shadow::relation() of one box.
[[nodiscard]] Answer relation(const Viewpoint& view, const Occluder& occluder, const Near& near, const Box& box);

/// Shadow::refute_cull() of one box.
[[nodiscard]] std::string refute_shadow_cull(const Viewpoint& view, const Occluder& occluder, const Near& near,
                                             const Box& box);

/// Proof that every point of `box` has a*x + b*y + c*z + d < 0, and that none is nearer than `margin` to that plane, whose
/// numbers are 0 or of a magnitude in [2^-100, 2^100]. Empty when proved, else what failed. REQUIRES: margin >= 0, finite.
[[nodiscard]] std::string refute_view_cull(const std::array<double, 4>& plane, const Box& box, double margin = 0);

/// Whether `point` lies in `box`, exactly. Nothing lies in a box with min > max or a number that is not finite. REQUIRES:
/// the point is finite.
[[nodiscard]] bool contains(const Box& box, const Point& point);

}  // namespace occlude::oracle
