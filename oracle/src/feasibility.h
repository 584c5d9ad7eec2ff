// SPDX-License-Identifier: MIT
// Whether linear inequalities and the bounds of a box have a common point, in exact rationals.
#pragma once

#include <array>
#include <vector>

#include "numbers.h"

namespace occlude::oracle {

/// a . x <= b.
template <std::size_t D>
struct Inequality {
  std::array<Exact, D> a;
  Exact b;
};

/// low <= x <= high, per axis.
template <std::size_t D>
struct Bounds {
  std::array<Exact, D> low, high;
};

/// Whether some x within `bounds` satisfies all of `inequalities`. Closed: touching is a common point.
[[nodiscard]] bool is_feasible(const Bounds<3>& bounds, std::vector<Inequality<3>> inequalities);

}  // namespace occlude::oracle
