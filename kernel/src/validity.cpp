// SPDX-License-Identifier: MIT
#include "occlude/kernel/validity.h"

namespace occlude::kernel {

Refusal check_rounding() {
  // Less than a quarter of the last place of 1. Rounded to nearest, both sums are 1. Rounded upwards, the first is more than
  // 1. Rounded downwards or towards zero, the second is less than 1.
  constexpr double kLittle = 0x1p-60;
  volatile double one = 1;  // volatile, so that the compiler, which rounds to nearest, does not compute the sums
  return one + kLittle == one - kLittle ? Refusal::none : Refusal::rounding_mode;
}

}  // namespace occlude::kernel
