// SPDX-License-Identifier: MIT
// The constants of the kernel's error_bounds.h, worked out anew.
#pragma once

#include <string>
#include <vector>

#include "exact.h"

namespace occlude::bound_check {

/// A constant and where it is needed to be how large.
struct Constant {
  std::string name, where;
  Exact needed, in_kernel;
  int degree;  ///< it is in units of this power of u
};

/// Every constant of the kernel, once for each of its uses.
[[nodiscard]] std::vector<Constant> recomputed_constants();

}  // namespace occlude::bound_check
