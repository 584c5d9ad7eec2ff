// SPDX-License-Identifier: MIT
// Recomputes the constants of the kernel's error_bounds.h.
#pragma once

#include <string>
#include <vector>

#include "exact.h"

namespace occlude::bound_check {

/// A constant, the place where it is needed, and how large it must be there.
struct Constant {
  std::string name, where;
  Exact needed, in_kernel;
  int degree;  ///< the constant is of the order of this power of u
};

/// Every constant of the kernel, once for each use.
[[nodiscard]] std::vector<Constant> recomputed_constants();

}  // namespace occlude::bound_check
