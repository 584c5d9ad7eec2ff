// SPDX-License-Identifier: MIT
#include "occlude/kernel/half_space.h"

#include <cmath>

#include "box_plane.h"

namespace occlude::kernel {
namespace {

/// Exact sign of the half-space's value at x.
int exact_sign(const HalfSpace& h, const Vec3& x) {
  return certified([&]<class A>(A& arithmetic) {
    return arithmetic.sign(dot(constants<A>(h.normal), constants<A>(x)) + A::constant(h.offset));
  });
}

/// Sign of the value at x. The certified sign is decided by the bound kHalfSpaceError where it suffices, else exactly.
int sign_at(const HalfSpace& h, const Vec3& x, Arithmetic arithmetic) {
  const double px = h.normal.x * x.x, py = h.normal.y * x.y, pz = h.normal.z * x.z;
  const double value = px + py + pz + h.offset;
  if (arithmetic == Arithmetic::plain) return PlainArithmetic::sign(value);
  const double magnitude = std::fabs(px) + std::fabs(py) + std::fabs(pz);
  if (std::fabs(value) > kHalfSpaceError * magnitude) return value > 0 ? 1 : -1;
  return exact_sign(h, x);
}

/// Sign of the value at the extremal vertex of the box along the normal: the nearest (`direction` = -1) or the farthest (1).
int extremal_sign(const HalfSpace& h, const Obb& box, int direction, Arithmetic arithmetic) {
  const auto question = [&]<class A>(A& a) {
    const PlaneCoefficients<A> plane{constants<A>(h.normal), A::constant(h.offset)};
    return extremal_sign(a, plane, {}, box, direction);
  };
  PlainArithmetic plain;
  return arithmetic == Arithmetic::plain ? question(plain) : certified(question);
}

}  // namespace

Relation relation(const HalfSpace& h, const Aabb& box, Arithmetic arithmetic) {
  const bool x = h.normal.x >= 0, y = h.normal.y >= 0, z = h.normal.z >= 0;
  if (sign_at(h, extremal_vertex(box, x, y, z), arithmetic) < 0) return Relation::outside;
  return sign_at(h, extremal_vertex(box, !x, !y, !z), arithmetic) >= 0 ? Relation::inside : Relation::partial;
}

Relation relation(const HalfSpace& h, const Obb& box, Arithmetic arithmetic) {
  if (extremal_sign(h, box, 1, arithmetic) < 0) return Relation::outside;
  return extremal_sign(h, box, -1, arithmetic) >= 0 ? Relation::inside : Relation::partial;
}

}  // namespace occlude::kernel
