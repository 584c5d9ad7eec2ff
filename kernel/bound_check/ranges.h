// SPDX-License-Identifier: MIT
// How small and how large the kernel's numbers can become: nothing may underflow or overflow.
#pragma once

#include <limits>
#include <string>
#include <vector>

namespace occlude::bound_check {

/// What is known of a number, as exponents of two: it is a multiple of the unit, at most the top in magnitude, and its
/// running error is zero or at least the error. Unit and error stand for all that rounding leaves, tails included: multiples
/// of a unit stay so when they are rounded.
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

/// The extents of everything that the kernel's templates come across, for all legal coordinates at once.
[[nodiscard]] std::vector<Expressions> ranges();

}  // namespace occlude::bound_check
