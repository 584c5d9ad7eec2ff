// SPDX-License-Identifier: MIT
// Recomputes the constants of error bounds by following the roundings of what they bound.
#pragma once

#include <string>
#include <vector>

#include "exact.h"

namespace occlude::bound_check {

/// A constant, the place where it is needed, and how large it must be there.
struct Constant {
  std::string name, where;
  Exact needed, stated;
  int degree = 1;  ///< the constant is of the order of this power of u,
  int bits = 53;   ///< which is 2^-bits
};

/// Every constant of the kernel's error_bounds.h, once for each use.
[[nodiscard]] std::vector<Constant> recomputed_constants();
/// The constants of the culler whose expressions are short enough to be followed. They are no templates: the expressions
/// stand in recompute_culler.cpp again.
[[nodiscard]] std::vector<Constant> recomputed_culler_constants();

}  // namespace occlude::bound_check
