// SPDX-License-Identifier: MIT
#include "occlude/kernel/validity.h"

namespace occlude::kernel {

Refusal check_rounding() {
  // Less than a quarter of the last place of 1: to nearest both sums are 1. Upwards the first is more, downwards and towards
  // zero the second is less.
  constexpr double kLittle = 0x1p-60;
  volatile double one = 1;  // not to be worked out by the compiler, which rounds to nearest
  return one + kLittle == one - kLittle ? Refusal::none : Refusal::rounding_mode;
}

}  // namespace occlude::kernel
