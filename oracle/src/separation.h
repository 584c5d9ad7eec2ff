// SPDX-License-Identifier: MIT
// Whether a plane through the origin has several balls strictly on one side.
#pragma once

#include <optional>
#include <vector>

#include "numbers.h"

namespace occlude::oracle {

/// The points no farther than `radius` from `center`.
template <class N>
struct Around {
  Vector<N> center;
  N radius = N(0);
};

struct Separation {
  bool exists = false;
  std::optional<Point> normal;  ///< one that separates, if one in doubles does
};

/// Whether some n has n . x > 0 for all points x of the balls. In intervals it throws when they cannot decide (numbers.h).
/// For points the answer is exact. For larger balls what is found is exact, but where only normals that agree to nearly all
/// their digits separate, none may be found.
template <class N>
[[nodiscard]] Separation separate(const std::vector<Around<N>>& balls);

}  // namespace occlude::oracle
