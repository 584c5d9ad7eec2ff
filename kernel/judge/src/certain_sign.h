// SPDX-License-Identifier: MIT
// Signs of numbers with a running error bound whose expressions may underflow.
#pragma once

#include "running_error.h"

namespace occlude::kernel {

/// Numbers of about 1 and less can underflow in products of many factors, and so can their error bounds. Each such loss is
/// less than 2^-1022, and some hundred of them together are less than this.
inline constexpr double kLostToUnderflow = 0x1p-900;

/// The sign of a value is certain when its magnitude exceeds this.
template <class Real>
[[nodiscard]] Real doubt(const BasicRunningError<Real>& x) {
  return x.error + kLostToUnderflow;
}

/// 0 where the bound cannot tell the sign, and after an overflow.
[[nodiscard]] inline int certain_sign(const RunningError& x) {
  return x.value > doubt(x) ? 1 : x.value < -doubt(x) ? -1 : 0;
}

}  // namespace occlude::kernel
