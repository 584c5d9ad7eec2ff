// SPDX-License-Identifier: MIT
// The value of an oriented plane at a point, in any arithmetic.
#pragma once

#include "arithmetic.h"
#include "occlude/kernel/shadow_frustum.h"
#include "vector3.h"

namespace occlude::kernel {

template <class A>
[[nodiscard]] Vector3<typename A::Number> normal(const ExactPlane& plane) {
  const auto a = difference<A>(plane.a_to, plane.a_from);
  return plane.direct ? a : cross(a, difference<A>(plane.b_to, plane.b_from));
}

template <class A>
[[nodiscard]] typename A::Number value(const ExactPlane& plane, const Vec3& x) {
  return dot(normal<A>(plane), difference<A>(x, plane.origin));
}

/// Exact sign of the plane at x: 1 on the inner side, 0 on the plane, -1 on the outer side.
[[nodiscard]] inline int sign_at(const ExactPlane& plane, const Vec3& x) {
  return certified([&]<class A>(A& arithmetic) { return arithmetic.sign(value<A>(plane, x)); });
}

}  // namespace occlude::kernel
