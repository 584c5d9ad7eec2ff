// SPDX-License-Identifier: MIT
// Whether a cover hides single rays, and the rays between two rays. This decides where only the border of a face is in
// doubt. It uses exact numbers alone, because hardly any box needs it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "cover_parts.h"

namespace occlude::kernel {

using ExactRay = Vector3<BigInteger>;

/// The cover in exact numbers. Each is computed when it is first needed.
class ExactCover {
 public:
  ExactCover(const CoverParts& parts, int shift);

  [[nodiscard]] const IntegerUnits& units() const { return units_; }
  [[nodiscard]] const TriangleForms<BigInteger>& triangle(std::size_t i);
  /// A form that is not negative where the triangle is drawn. REQUIRES: the cover is cut.
  [[nodiscard]] ExactRay drawn(std::size_t i);

  /// From now on only these triangles count. Before the first call all of them do.
  void consider(std::span<const std::uint32_t> triangles) { considered_.assign(triangles.begin(), triangles.end()); }

  /// Whether the point of the plane on this ray has a point of the cover before it.
  [[nodiscard]] bool hides(const ExactRay& ray, const PlaneForm<BigInteger>& plane);

  /// Whether this holds at all rays of `line` that are not negative on any of `sides`. REQUIRES: these rays are no more than
  /// half of the line.
  [[nodiscard]] bool hides_all(const ExactRay& line, std::span<const ExactRay> sides, const PlaneForm<BigInteger>& plane);

 private:
  struct Arc {
    RayPoint<BigInteger> from, to;
    ExactRay line;                ///< 0 where the arc is one ray
    PlaneForm<BigInteger> plane;  ///< a plane through the arc
    bool is_at_viewpoint = false;
  };

  [[nodiscard]] const std::vector<Arc>& arcs();
  [[nodiscard]] bool hides(std::size_t triangle, const ExactRay& ray, const PlaneForm<BigInteger>& plane);
  [[nodiscard]] static bool hides(const Arc& arc, const ExactRay& ray, const PlaneForm<BigInteger>& plane);
  /// All lines at which the answer may change along another line.
  [[nodiscard]] std::vector<ExactRay> lines(const PlaneForm<BigInteger>& plane);

  const CoverParts& parts_;
  IntegerUnits units_;
  std::vector<std::optional<TriangleForms<BigInteger>>> triangles_;
  std::vector<std::uint32_t> considered_;
  std::optional<std::vector<Arc>> arcs_;
};

[[nodiscard]] inline bool is_zero(const ExactRay& v) { return v.x.sign() == 0 && v.y.sign() == 0 && v.z.sign() == 0; }

/// A plane through the point. Any such plane will do, because it is only asked for the ray of the point.
[[nodiscard]] PlaneForm<BigInteger> plane_across(const RayPoint<BigInteger>& point);

/// A plane through two points. Any such plane will do, because it is only asked for rays between the two. `line` is the
/// cross product of their rays. REQUIRES: `line` is not 0.
[[nodiscard]] PlaneForm<BigInteger> plane_through(const RayPoint<BigInteger>& a, const RayPoint<BigInteger>& b,
                                                  const ExactRay& line);

}  // namespace occlude::kernel
