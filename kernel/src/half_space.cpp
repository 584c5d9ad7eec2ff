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

/// Sign of the value at x, by the bound kHalfSpaceError where it suffices.
int sign_at(const HalfSpace& h, const Vec3& x, Arithmetic arithmetic) {
  const double px = h.normal.x * x.x, py = h.normal.y * x.y, pz = h.normal.z * x.z;
  const double value = px + py + pz + h.offset;
  if (arithmetic == Arithmetic::plain) return PlainArithmetic::sign(value);
  const double magnitude = std::fabs(px) + std::fabs(py) + std::fabs(pz);
  if (std::fabs(value) > kHalfSpaceError * magnitude) return value > 0 ? 1 : -1;
  return exact_sign(h, x);
}

/// Sign of the value at the vertex of the box nearest (`direction` = -1) or farthest (1) along the normal.
template <class A>
int extremal_sign(A& arithmetic, const HalfSpace& h, const Obb& box, int direction) {
  const auto normal = constants<A>(h.normal);
  auto value = dot(normal, constants<A>(box.center)) + A::constant(h.offset);
  for (const Vec3& half_edge : box.half_edges) {
    const auto spread = A::magnitude(dot(normal, constants<A>(half_edge)));
    value = direction > 0 ? value + spread : value - spread;
  }
  return arithmetic.sign(value);
}

int extremal_sign(const HalfSpace& h, const Obb& box, int direction, Arithmetic arithmetic) {
  PlainArithmetic plain;
  if (arithmetic == Arithmetic::plain) return extremal_sign(plain, h, box, direction);
  return certified([&](auto& a) { return extremal_sign(a, h, box, direction); });
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
