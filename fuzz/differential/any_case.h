// SPDX-License-Identifier: MIT
// A case of any family, for experiments that are not about one.
#pragma once

#include "occlude/fuzz/cases.h"
#include "occlude/fuzz/random.h"

namespace occlude::fuzz {

[[nodiscard]] inline Case any_case(Random& random) {
  const Family family = families()[random.index(families().size())];
  return make_case(family, random.bits() >> 16U);
}

}  // namespace occlude::fuzz
