// SPDX-License-Identifier: MIT
#include "occlude/kernel/containment.h"

#include "arithmetic.h"
#include "vector3.h"

namespace occlude::kernel {
namespace {

/// With d = point - centre = a h0 + b h1 + g h2, Cramer's rule gives a = det(d, h1, h2) / det(h0, h1, h2), and so on. The
/// point lies in the box when no numerator exceeds the denominator in magnitude. Each determinant is a sum of six products
/// of three numbers.
template <class A>
bool is_in(A& arithmetic, const Obb& box, const Vec3& point) {
  const auto d = difference<A>(point, box.center);
  const auto h = [&](std::size_t i) { return constants<A>(box.half_edges[i % 3]); };
  const auto volume = A::magnitude(dot(h(0), cross(h(1), h(2))));
  if (arithmetic.sign(volume) <= 0) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    if (arithmetic.sign(volume - A::magnitude(dot(d, cross(h(i + 1), h(i + 2))))) < 0) return false;
  }
  return true;
}

}  // namespace

bool contains(const Obb& box, const Vec3& point) {
  return certified([&](auto& arithmetic) { return is_in(arithmetic, box, point); });
}

}  // namespace occlude::kernel
