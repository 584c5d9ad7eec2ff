// SPDX-License-Identifier: MIT
// The geometry of the kernel's questions: points, boxes, viewpoints, answers. Reading order: 1.
//
// Every number is an IEEE double and stands for exactly that real number. Coordinates have no unit. Axes are right-handed.
// Sets are closed unless a comment says otherwise, so two sets that share a single point are not disjoint. These types check
// nothing; validity.h does.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace occlude::kernel {

/// A point or a vector. operator[] REQUIRES: 0 <= axis <= 2.
struct Vec3 {
  double x = 0, y = 0, z = 0;

  double& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  friend bool operator==(const Vec3&, const Vec3&) = default;
};

/// The axis-aligned box {x : min <= x <= max on every axis}. It may be flat: min = max is allowed.
struct Aabb {
  Vec3 min, max;

  friend bool operator==(const Aabb&, const Aabb&) = default;
};

/// The oriented box {center + a half_edges[0] + b half_edges[1] + g half_edges[2] : |a|, |b|, |g| <= 1}. It is exactly this
/// parallelepiped: the half edges need not be orthogonal, and may be linearly dependent or zero.
struct Obb {
  Vec3 center;
  std::array<Vec3, 3> half_edges;

  friend bool operator==(const Obb&, const Obb&) = default;
};

/// A polytope as given: each face is a loop of indices into `vertices`, clockwise or counter-clockwise. See
/// ConvexPolytope::make().
struct Polytope {
  std::vector<Vec3> vertices;
  std::vector<std::vector<std::uint32_t>> faces;
};

/// Where the scene is seen from: an eye (a point), or a direction of view (orthographic). The direction points from the
/// viewer into the scene; its length does not matter, but it must not be zero.
struct Viewpoint {
  enum class Kind { eye, direction };
  Kind kind = Kind::eye;
  Vec3 value;

  static Viewpoint eye(const Vec3& point) { return {Kind::eye, point}; }
  static Viewpoint direction(const Vec3& d) { return {Kind::direction, d}; }
  [[nodiscard]] bool is_eye() const { return kind == Kind::eye; }
};

/// Relation of a set B (a box, a polytope) to a set F (a shadow): `inside` if B is a subset of F, `outside` if they share no
/// point, else `partial`.
enum class Relation { inside, partial, outside };

/// `certified` is never wrong. `plain` computes in doubles as the paper does: rounding may make its answers wrong.
enum class Arithmetic { plain, certified };

/// Which stage of `certified` decided. `filter`: doubles with an error bound sufficed. `exact`: some sign needed more
/// precision. Both are equally right.
enum class Stage { filter, exact };

/// `overlap` is the full three-way test. `conservative` is its box-plane stage alone (section 5.3): it finds every `inside`,
/// but only those boxes `outside` that a single plane of the frustum separates from it; others it calls `partial`.
enum class Test { overlap, conservative };

/// The name of the enumerator.
[[nodiscard]] constexpr std::string_view to_string(Relation relation) {
  return relation == Relation::inside ? "inside" : relation == Relation::partial ? "partial" : "outside";
}

}  // namespace occlude::kernel
