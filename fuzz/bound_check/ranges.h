// SPDX-License-Identifier: MIT
// Finds how small and how large the kernel's numbers can become: nothing may underflow or overflow.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace occlude::bound_check {

/// What is known about numbers, as exponents of two. They are multiples of 2^unit, at most 2^top in magnitude, and their
/// running errors are zero or at least 2^error. Unit and error also cover all that rounding leaves, tails included:
/// multiples of a unit stay multiples when they are rounded.
struct Extent {
  double unit = std::numeric_limits<double>::infinity();
  double top = -std::numeric_limits<double>::infinity();
  double error = std::numeric_limits<double>::infinity();

  void include(const Extent& other);
  [[nodiscard]] bool is_safe() const;
};

struct Expressions {
  std::string name;
  Extent extent;
};

/// The extents of all numbers that the kernel's templates compute, for all legal coordinates at once.
[[nodiscard]] std::vector<Expressions> ranges();

}  // namespace occlude::bound_check
