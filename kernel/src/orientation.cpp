// SPDX-License-Identifier: MIT
#include "occlude/kernel/orientation.h"

#include "arithmetic.h"
#include "vector3.h"

namespace occlude::kernel {

int orientation(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  return certified([&]<class A>(A& arithmetic) {
    return arithmetic.sign(dot(cross_of_differences(difference<A>(b, a), difference<A>(c, a)), difference<A>(d, a)));
  });
}

int turn(int axis, const Vec3& a, const Vec3& b, const Vec3& c) {
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  return certified([&]<class A>(A& arithmetic) {
    const auto side = [&](const Vec3& to, int k) { return A::difference(to[k], a[k]); };
    return arithmetic.sign(side(b, i) * side(c, j) - side(b, j) * side(c, i));
  });
}

}  // namespace occlude::kernel
