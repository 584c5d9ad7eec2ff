// SPDX-License-Identifier: MIT
// A case of any family, for experiments that are not about one.
#pragma once

#include <stdexcept>

#include "occlude/fuzz/ask.h"
#include "occlude/fuzz/cases.h"
#include "occlude/fuzz/random.h"

namespace occlude::fuzz {

[[nodiscard]] inline Case any_case(Random& random) {
  const Family family = families()[random.index(families().size())];
  return make_case(family, random.bits() >> 16U);
}

/// One whose occluder the kernel takes. Nearly all are such; throws std::runtime_error when a thousand are not.
[[nodiscard]] inline Case any_legal_case(Random& random) {
  for (int tries = 0; tries < 1000; ++tries) {
    Case c = any_case(random);
    if (make_frustum(c).frustum) return c;
  }
  throw std::runtime_error("the kernel refuses a thousand cases in a row");
}

}  // namespace occlude::fuzz
