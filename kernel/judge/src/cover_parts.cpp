// SPDX-License-Identifier: MIT
#include "cover_parts.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "certain_sign.h"
#include "cover_hidden.h"
#include "occlude/kernel/cover.h"

namespace occlude::kernel {
namespace {

/// Sorts the triangles of fans into those with an area in the plane of rays and those seen edge-on.
class Parts {
 public:
  Parts(const Viewpoint& view, const std::optional<HalfSpace>& drawn, std::span<const Cover::Polygon> polygons)
      : parts_{Rays(view), 1, 0, {}, {}, {}} {
    if (drawn) {
      const double factor = factor_to_about_1(drawn->normal);
      parts_.drawn = HalfSpace{times(factor, drawn->normal), factor * drawn->offset};
    }
    choose_units(polygons);
    for (const Cover::Polygon& polygon : polygons) {
      for (std::size_t i = 1; i + 1 < polygon.size(); ++i) add({polygon[0], polygon[i], polygon[i + 1]});
    }
  }

  [[nodiscard]] CoverParts take() { return std::move(parts_); }

 private:
  void choose_units(std::span<const Cover::Polygon> polygons) {
    const Viewpoint& view = parts_.rays.viewpoint();
    double extent = 0;
    parts_.shift = std::max(0, shift_for(view.value));
    for (const Cover::Polygon& polygon : polygons) {
      for (const Vec3& v : polygon) {
        extent = std::max(extent, largest(v) + (view.is_eye() ? largest(view.value) : 0));
        parts_.shift = std::max(parts_.shift, shift_for(v));
      }
    }
    if (parts_.drawn) {
      parts_.shift = std::max({parts_.shift, shift_for(parts_.drawn->normal), shift_for(parts_.drawn->offset)});
    }
    if (extent > 0) parts_.factor = std::ldexp(1, -std::ilogb(extent));
  }

  void add(std::array<Vec3, 3> corners) {
    const RoundedUnits rounded(parts_.factor);
    auto seen = triangle_forms(parts_.rays, rounded, corners);
    int turn = certain_sign(seen.plane.unit);
    if (turn == 0) turn = triangle_forms(parts_.rays, IntegerUnits(parts_.shift), corners).plane.unit.sign();
    if (turn == 0) return parts_.drawn ? void() : add_edge_on(corners);
    if (turn < 0) {
      std::swap(corners[1], corners[2]);
      seen = triangle_forms(parts_.rays, rounded, corners);
    }
    CoverTriangle& triangle = parts_.triangles.emplace_back(CoverTriangle{corners, seen, {}});
    if (parts_.drawn) triangle.drawn = side_of(seen.plane, parts_.rays.form(rounded, *parts_.drawn));
  }

  /// A ray that meets a triangle seen edge-on meets it first on its edges, unless the triangle holds the viewpoint. A
  /// triangle that does hides every ray in its plane that meets it: the rays to its corners and to those of its edges that
  /// do not hold the viewpoint.
  void add_edge_on(const std::array<Vec3, 3>& corners) {
    std::array<ExactRay, 3> rays;
    for (std::size_t i = 0; i < 3; ++i) {
      rays[i] = parts_.rays.point(IntegerUnits(parts_.shift), corners[i]).ray;
    }
    const auto holds_viewpoint = [&](std::size_t i, std::size_t j) {
      return is_zero(cross(rays[i], rays[j])) && dot(rays[i], rays[j]).sign() <= 0;
    };
    const bool is_at_viewpoint =
        holds_viewpoint(0, 1) || holds_viewpoint(1, 2) || holds_viewpoint(2, 0) || surround_viewpoint(rays);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t next = (i + 1) % 3;
      if (!holds_viewpoint(i, next)) parts_.arcs.push_back({corners[i], corners[next], is_at_viewpoint});
      if (is_at_viewpoint && !is_zero(rays[i])) parts_.arcs.push_back({corners[i], corners[i], true});
    }
  }

  /// Whether three rays in one plane go all the way round. REQUIRES: no two of them are opposite.
  static bool surround_viewpoint(const std::array<ExactRay, 3>& rays) {
    const ExactRay a = cross(rays[0], rays[1]), b = cross(rays[1], rays[2]), c = cross(rays[2], rays[0]);
    return dot(a, b).sign() > 0 && dot(b, c).sign() > 0;
  }

  CoverParts parts_;
};

}  // namespace

CoverParts in_units_for(const CoverParts& parts, double extent) {
  CoverParts result = parts;
  result.factor = std::ldexp(1, -std::ilogb(extent));
  const RoundedUnits rounded(result.factor);
  for (CoverTriangle& triangle : result.triangles) {
    triangle.forms = triangle_forms(parts.rays, rounded, triangle.corners);
    if (parts.drawn) triangle.drawn = side_of(triangle.forms.plane, parts.rays.form(rounded, *parts.drawn));
  }
  return result;
}

CoverResult Cover::make(const Viewpoint& viewpoint, std::span<const Polygon> polygons,
                        const std::optional<HalfSpace>& drawn) {
  const auto refused = [](Refusal refusal) { return CoverResult{std::nullopt, refusal}; };
  if (const Refusal refusal = check_rounding(); refusal != Refusal::none) return refused(refusal);
  if (const Refusal refusal = check(viewpoint); refusal != Refusal::none) return refused(refusal);
  for (const Polygon& polygon : polygons) {
    if (const Refusal refusal = check(polygon); refusal != Refusal::none) return refused(refusal);
    if (polygon.size() < 3) return refused(Refusal::too_few_vertices);
  }
  if (drawn) {
    if (const Refusal refusal = check(drawn->normal); refusal != Refusal::none) return refused(refusal);
    if (const Refusal refusal = check(drawn->offset); refusal != Refusal::none) return refused(refusal);
    if (drawn->normal == Vec3{}) return refused(Refusal::zero_direction);
  }
  return {Cover(std::make_shared<const CoverParts>(Parts(viewpoint, drawn, polygons).take())), Refusal::none};
}

}  // namespace occlude::kernel
