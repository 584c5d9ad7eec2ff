// SPDX-License-Identifier: MIT
// Runs the tests in an arithmetic that counts operations (Table 1).
#include "certified_overlap.h"
#include "counting.h"
#include "plain_overlap.h"

namespace occlude::kernel {
namespace {

template <class Box>
Operations count(const ShadowFrustum& frustum, const Box& box, Arithmetic arithmetic, Test test) {
  using A = CountingArithmetic;
  constexpr auto kNear = NearBoundary::closed;
  operation_counter = {.tests = 1};
  if (arithmetic == Arithmetic::plain) {
    static_cast<void>(test == Test::overlap ? plain_overlap<A>(frustum, box, kNear)
                                            : plain_conservative<A>(frustum, box, kNear));
  } else {
    static_cast<void>(test == Test::overlap ? certified_overlap<A>(frustum, box, kNear)
                                            : certified_conservative<A>(frustum, box, kNear));
  }
  return operation_counter;
}

}  // namespace

Operations count_operations(const ShadowFrustum& frustum, const Aabb& box, Arithmetic arithmetic, Test test) {
  return count(frustum, box, arithmetic, test);
}
Operations count_operations(const ShadowFrustum& frustum, const Obb& box, Arithmetic arithmetic, Test test) {
  return count(frustum, box, arithmetic, test);
}

}  // namespace occlude::kernel
