// SPDX-License-Identifier: MIT
// Whether linear inequalities and the bounds of a box have a common point. There are no divisions, so the code runs in both
// number types. In intervals it throws when they cannot decide (numbers.h).
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "numbers.h"

namespace occlude::oracle {

/// a . x <= b.
template <class N, std::size_t D>
struct Inequality {
  std::array<N, D> a;
  N b;
};

/// low <= x <= high, per axis.
template <class N, std::size_t D>
struct Bounds {
  std::array<N, D> low, high;
};

/// Whether some x within `bounds` satisfies all `inequalities`. Sets are closed, so touching counts as a common point.
template <class N>
[[nodiscard]] bool is_feasible(const Bounds<N, 3>& bounds, std::vector<Inequality<N, 3>> inequalities);

/// The point with the coordinates x[i] / w, w > 0.
template <class N, std::size_t D>
struct Ratios {
  std::array<N, D> x;
  N w;
};

/// A point within `bounds` that satisfies all `inequalities` and satisfies all of `strict` without equality. Empty when
/// there is none.
template <class N>
[[nodiscard]] std::optional<Ratios<N, 3>> feasible_point(const Bounds<N, 3>& bounds,
                                                         const std::vector<Inequality<N, 3>>& inequalities,
                                                         const std::vector<Inequality<N, 3>>& strict);

}  // namespace occlude::oracle
