// SPDX-License-Identifier: MIT
#include "box_plane.h"

#include <cmath>
#include <optional>

#include "grid_sign.h"
#include "rounded_plane.h"

namespace occlude::kernel {
namespace {

/// Whether the components of the rounded normal have the signs of the true ones, so that both pick the same vertices.
bool has_certain_signs(const FilterPlane& plane, const RefinedPlane& tail) {
  const auto is_certain = [&](double n) { return tail.uncertainty.slope == 0 || std::fabs(n) > 2 * tail.uncertainty.slope; };
  return is_certain(plane.normal.x) && is_certain(plane.normal.y) && is_certain(plane.normal.z);
}

}  // namespace

int exact_extremal_sign(const StoredFrustum& frustum, std::size_t i, const Aabb& box, double reach, int direction) {
  // The rounded normal picks the vertex. Where the sign of a component is in doubt, the true normal may pick another, but
  // the value there is within the same bound.
  const FilterPlane& plane = frustum.filter_planes[i];
  const auto positive = [&](std::size_t k) { return (plane.farther[k] >= 4) == (direction > 0); };
  const Vec3 vertex = extremal_vertex(box, positive(0), positive(1), positive(2));
  const auto* const laid = std::get_if<ExactPlane>(&frustum.recipes[i]);
  if (laid && has_certain_signs(plane, frustum.refined_planes[i])) {
    if (is_defined_by(*laid, vertex)) return 0;
    if (const std::optional<int> sign = sign_across_axis(*laid, plane.normal, vertex)) return *sign;
  }
  const CertainSign refined = refined_sign(plane, frustum.refined_planes[i], vertex, frustum.origin, reach);
  if (refined.is_certain) return refined.sign;
  if (laid) {
    if (const std::optional<int> sign = grid_extremal_sign(*laid, box, direction)) return *sign;
  }
  ExactArithmetic exact;
  return extremal_sign(exact, coefficients<ExactArithmetic>(frustum, frustum.recipes[i]), frustum.origin, box, direction);
}

int exact_extremal_sign(const StoredFrustum& frustum, std::size_t i, const Obb& box, double, int direction) {
  return exactly([&]<class A>(A& arithmetic) {
    return extremal_sign(arithmetic, coefficients<A>(frustum, frustum.recipes[i]), frustum.origin, box, direction);
  });
}

}  // namespace occlude::kernel
