// SPDX-License-Identifier: MIT
// The planes of a frustum as exact numbers, from their definitions (kernel/src/planes.h).
#pragma once

#include <CGAL/Simple_cartesian.h>

#include "exact.h"
#include "stored_frustum.h"

namespace occlude::bound_check {

using Vector = CGAL::Simple_cartesian<Exact>::Vector_3;

template <class V>
[[nodiscard]] Vector vector_of(const V& v) {
  return {Exact(v.x), Exact(v.y), Exact(v.z)};
}

/// f(x) = normal . x + offset.
struct TruePlane {
  Vector normal;
  Exact offset;

  [[nodiscard]] Exact at(const kernel::Vec3& x) const { return normal * vector_of(x) + offset; }
};

[[nodiscard]] TruePlane true_plane(const kernel::StoredFrustum& frustum, const kernel::PlaneRecipe& recipe);

/// The same plane with its values multiplied by `factor`.
[[nodiscard]] TruePlane scaled(const TruePlane& plane, const Exact& factor);

/// The least and the greatest value of a plane over a box.
struct Range {
  Exact low, high;
};
[[nodiscard]] Range values(const TruePlane& plane, const kernel::Aabb& box);
[[nodiscard]] Range values(const TruePlane& plane, const kernel::Obb& box);

}  // namespace occlude::bound_check
