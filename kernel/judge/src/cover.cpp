// SPDX-License-Identifier: MIT
#include "occlude/kernel/cover.h"

#include <algorithm>
#include <array>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

#include "certain_sign.h"
#include "cover_face.h"
#include "cover_hidden.h"
#include "cover_parts.h"

namespace occlude::kernel {
namespace {

using ExactPoint = RayPoint<BigInteger>;

/// A corner of a box as the sum of these terms: the corner of an oriented box need not be a double.
struct Corner {
  std::array<Vec3, 4> terms;
  std::size_t count;

  [[nodiscard]] std::span<const Vec3> sum() const { return {terms.data(), count}; }
};

/// Bit k of `i` tells the end of axis k: 0 the lower, 1 the upper.
Corner corner(const Aabb& box, unsigned i) {
  return {{Vec3{i & 1U ? box.max.x : box.min.x, i & 2U ? box.max.y : box.min.y, i & 4U ? box.max.z : box.min.z}}, 1};
}
Corner corner(const Obb& box, unsigned i) {
  Corner result{{box.center}, 4};
  for (std::size_t k = 0; k < 3; ++k) result.terms[k + 1] = times(i >> k & 1U ? 1 : -1, box.half_edges[k]);
  return result;
}

/// No coordinate of a point of the box has a larger magnitude, up to rounding.
double extent(const Aabb& box) { return std::max(largest(box.min), largest(box.max)); }
double extent(const Obb& box) {
  return largest(box.center) + largest(box.half_edges[0]) + largest(box.half_edges[1]) + largest(box.half_edges[2]);
}

class BoxBehindCover {
 public:
  template <class Box>
  BoxBehindCover(const CoverParts& parts, const Box& box) : parts_(parts), cover_(parts, shift_for(parts, box)) {
    // Numbers far larger than those of the cover would overflow, or magnify what is lost to underflow.
    constexpr double kMuch = 64;
    if (extent(box) * parts.factor > kMuch) {
      own_parts_ = in_units_for(parts, extent(box));
    }
    for (unsigned i = 0; i < 8; ++i) {
      corners_[i] = corner(box, i);
      rounded_[i] = this->parts().rays.point(RoundedUnits(this->parts().factor), corners_[i].sum());
    }
  }

  [[nodiscard]] Decision decide() {
    const bool is_hidden = is_box_hidden();
    return {is_hidden ? Relation::inside : Relation::partial, was_exact_ ? Stage::exact : Stage::filter};
  }

 private:
  template <class Box>
  static int shift_for(const CoverParts& parts, const Box& box) {
    int shift = parts.shift;
    for (unsigned i = 0; i < 8; ++i) {
      const Corner terms = corner(box, i);
      for (const Vec3& term : terms.sum()) shift = std::max(shift, kernel::shift_for(term));
    }
    return shift;
  }

  [[nodiscard]] const CoverParts& parts() const { return own_parts_ ? *own_parts_ : parts_; }

  [[nodiscard]] const RayPoint<RunningError>& rounded(unsigned i) const { return rounded_[i]; }
  [[nodiscard]] const ExactPoint& exact(unsigned i) {
    if (!exact_[i]) exact_[i] = parts_.rays.point(cover_.units(), corners_[i].sum());
    return *exact_[i];
  }

  /// The corners at one end of an axis, in order round the face.
  using Corners = std::array<unsigned, 4>;
  static Corners face(unsigned axis, bool is_max) {
    const unsigned u = 1U << (axis + 1) % 3, v = 1U << (axis + 2) % 3, base = is_max ? 1U << axis : 0;
    return {base, base | u, base | u | v, base | v};
  }

  /// The way a face turns in the plane of rays: 1 counter-clockwise, -1 clockwise, 0 edge-on.
  [[nodiscard]] int turn(const Corners& c) {
    const auto unit = [](const auto& p, const auto& q, const auto& r) { return dot(cross(p.ray, q.ray), r.ray); };
    if (const int sign = certain_sign(unit(rounded(c[0]), rounded(c[1]), rounded(c[2]))); sign != 0) return sign;
    was_exact_ = true;
    return unit(exact(c[0]), exact(c[1]), exact(c[2])).sign();
  }

  /// 1 where the opposite face is behind this one, -1 where it is in front, 0 where they coincide, so that the box is flat.
  [[nodiscard]] int side_of_opposite(const Corners& c, unsigned axis) {
    const unsigned across = c[0] ^ 1U << axis;
    const auto behind = [](const auto& p, const auto& q, const auto& r, const auto& other) {
      const auto plane = triangle_forms<std::decay_t<decltype(p.nearness)>>({p, q, r}).plane;
      return dot(plane.of_ray, other.ray) - plane.unit * other.nearness;
    };
    const int sign = certain_sign(behind(rounded(c[0]), rounded(c[1]), rounded(c[2]), rounded(across)));
    if (sign != 0) return sign;
    was_exact_ = true;
    return behind(exact(c[0]), exact(c[1]), exact(c[2]), exact(across)).sign();
  }

  /// A ray that meets the box meets it first on a face turned to the viewpoint. A ray that meets a flat box meets every face
  /// that is not edge-on; if all are edge-on, it meets an edge.
  [[nodiscard]] bool is_box_hidden() {
    std::vector<Corners> front, flat;
    bool is_solid = false;
    for (unsigned axis = 0; axis < 3; ++axis) {
      for (const bool is_max : {false, true}) {
        Corners corners = face(axis, is_max);
        const int turned = turn(corners);
        if (turned == 0) continue;
        if (turned < 0) std::swap(corners[1], corners[3]);
        const int side = side_of_opposite(corners, axis);
        is_solid = is_solid || side != 0;
        if (side > 0) front.push_back(corners);
        if (side == 0) flat.push_back(corners);
      }
    }
    if (is_solid && front.empty()) return false;  // the box holds the viewpoint
    const std::vector<Corners>& faces = is_solid ? front : flat;
    if (faces.empty()) return are_edges_hidden();
    return std::ranges::all_of(faces, [&](const Corners& c) { return is_face_hidden(c); });
  }

  [[nodiscard]] bool is_face_hidden(const Corners& c) {
    const Face<RunningError> seen{rounded(c[0]), rounded(c[1]), rounded(c[2]), rounded(c[3])};
    const Face<BigInteger> truth{exact(c[0]), exact(c[1]), exact(c[2]), exact(c[3])};
    CoverFace face(parts(), cover_, seen, truth);
    const bool is_hidden = face.is_hidden();
    was_exact_ = was_exact_ || face.was_exact();
    return is_hidden;
  }

  [[nodiscard]] bool are_edges_hidden() {
    was_exact_ = true;
    if (holds_viewpoint()) return false;
    for (unsigned i = 0; i < 8; ++i) {
      for (const unsigned bit : {1U, 2U, 4U}) {
        if ((i & bit) == 0 && !is_edge_hidden(exact(i), exact(i | bit))) return false;
      }
    }
    return true;
  }

  [[nodiscard]] bool is_edge_hidden(const ExactPoint& a, const ExactPoint& b) {
    const ExactRay line = cross(a.ray, b.ray);
    if (!is_zero(line)) {
      const std::array<ExactRay, 2> ends{cross(line, a.ray), cross(b.ray, line)};
      return cover_.hides_all(line, ends, plane_through(a, b, line));
    }
    return std::ranges::all_of(std::array{&a, &b},
                               [&](const ExactPoint* end) { return cover_.hides(end->ray, plane_across(*end)); });
  }

  /// Whether a box holds the viewpoint. It does not when, for one of its corners, no corner is at the viewpoint or on the
  /// opposite ray, and all other rays to corners are on one side of the ray to this one. REQUIRES: all corners lie in one
  /// plane with the viewpoint.
  [[nodiscard]] bool holds_viewpoint() {
    const auto is_extreme = [&](unsigned i) {
      const ExactRay& ray = exact(i).ray;
      if (is_zero(ray)) return false;
      ExactRay normal{};
      for (unsigned k = 0; k < 8; ++k) {
        const ExactRay other = cross(ray, exact(k).ray);
        if (is_zero(other)) {
          if (dot(ray, exact(k).ray).sign() <= 0) return false;
          continue;
        }
        if (is_zero(normal)) normal = other;
        if (dot(normal, other).sign() < 0) return false;
      }
      return true;
    };
    for (unsigned i = 0; i < 8; ++i) {
      if (is_extreme(i)) return false;
    }
    return true;
  }

  const CoverParts& parts_;
  std::optional<CoverParts> own_parts_;  ///< for a box far larger than the cover: the cover in units for this box
  ExactCover cover_;
  std::array<Corner, 8> corners_{};
  std::array<RayPoint<RunningError>, 8> rounded_{};
  std::array<std::optional<ExactPoint>, 8> exact_;
  bool was_exact_ = false;
};

/// The integers are as long as the numbers of the box and the cover are far apart. Numbers that are not legal could fill the
/// memory, so they are refused here.
template <class Box>
Decision decide_legal(const Cover& cover, const Box& box) {
  if (check(box) != Refusal::none) return {Relation::partial, Stage::filter};
  return BoxBehindCover(cover.parts(), box).decide();
}

}  // namespace

Decision overlap_certified(const Cover& cover, const Aabb& box) { return decide_legal(cover, box); }
Decision overlap_certified(const Cover& cover, const Obb& box) { return decide_legal(cover, box); }

}  // namespace occlude::kernel
