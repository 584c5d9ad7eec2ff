// SPDX-License-Identifier: MIT
// Signs of numbers with a running error bound whose expressions may underflow.
#pragma once

#include "running_error.h"

namespace occlude::kernel {

/// Numbers of about 1 and less underflow in products of many factors, and their error bounds with them. What is lost then is
/// less than 2^-1022 each time, and some hundred such losses are less than this.
inline constexpr double kLostToUnderflow = 0x1p-900;

/// What a value must exceed.
template <class Real>
[[nodiscard]] Real doubt(const BasicRunningError<Real>& x) {
  return x.error + kLostToUnderflow;
}

/// 0 where the bound does not tell, nor after an overflow.
[[nodiscard]] inline int certain_sign(const RunningError& x) {
  return x.value > doubt(x) ? 1 : x.value < -doubt(x) ? -1 : 0;
}

}  // namespace occlude::kernel
