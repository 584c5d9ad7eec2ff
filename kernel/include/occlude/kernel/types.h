// SPDX-License-Identifier: MIT
// The geometry of the kernel's questions: points, boxes, viewpoints, answers. Reading order: 1.
//
// Every number is an IEEE double taken as exactly the real number it represents. Units are the scene's own; the kernel has
// none. All sets are closed: sharing a single point is touching.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

namespace occlude::kernel {

struct Vec3 {
  double x = 0, y = 0, z = 0;

  double& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  double operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
  friend bool operator==(const Vec3&, const Vec3&) = default;
};

/// Axis-aligned box {x : min <= x <= max, per axis}; min = max on an axis is allowed.
struct Aabb {
  Vec3 min, max;

  friend bool operator==(const Aabb&, const Aabb&) = default;
};

/// Oriented box {center + a half_edges[0] + b half_edges[1] + g half_edges[2] : |a|, |b|, |g| <= 1}: exactly that
/// parallelepiped, whatever the angles between the half edges; they may be zero or dependent.
struct Obb {
  Vec3 center;
  std::array<Vec3, 3> half_edges;

  friend bool operator==(const Obb&, const Obb&) = default;
};

/// A polytope as given: faces are loops of indices into `vertices`, either way round.
struct Polytope {
  std::vector<Vec3> vertices;
  std::vector<std::vector<std::uint32_t>> faces;
};

/// Where the scene is seen from: a point, or a direction of view (orthographic: the eye at infinity along -direction).
struct Viewpoint {
  enum class Kind { eye, direction };
  Kind kind = Kind::eye;
  Vec3 value;

  static Viewpoint eye(const Vec3& point) { return {Kind::eye, point}; }
  static Viewpoint direction(const Vec3& d) { return {Kind::direction, d}; }
  [[nodiscard]] bool is_eye() const { return kind == Kind::eye; }
};

/// Relation of a box B to a shadow frustum F: `inside` when B is a subset of F, `outside` when they share no point.
enum class Relation { inside, partial, outside };

/// `plain` is the paper's double arithmetic with its rounding; `certified` is never wrong.
enum class Arithmetic { plain, certified };

/// Which stage of `certified` decided.
enum class Stage { filter, exact };

/// `overlap` decides all three relations; `conservative` is its box-plane stage alone (section 5.3): `inside` only when
/// true, and otherwise a true `outside` or `partial`.
enum class Test { overlap, conservative };

[[nodiscard]] constexpr std::string_view to_string(Relation relation) {
  return relation == Relation::inside ? "inside" : relation == Relation::partial ? "partial" : "outside";
}

}  // namespace occlude::kernel
