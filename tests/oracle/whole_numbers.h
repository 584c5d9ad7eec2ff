// SPDX-License-Identifier: MIT
// Vectors of integers that are small enough for 64 bits.
#pragma once

#include <array>
#include <cstdint>

#include "occlude/fuzz/random.h"
#include "occlude/oracle/oracle.h"

namespace occlude::oracle {

using Whole = std::int64_t;
using WholePoint = std::array<Whole, 3>;

inline Whole dot(const WholePoint& a, const WholePoint& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
inline WholePoint plus(const WholePoint& a, const WholePoint& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
inline WholePoint minus(const WholePoint& a, const WholePoint& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
inline WholePoint times(Whole factor, const WholePoint& a) { return {factor * a[0], factor * a[1], factor * a[2]}; }
inline WholePoint cross(const WholePoint& a, const WholePoint& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

inline WholePoint whole_point(fuzz::Random& random, int reach) {
  const auto next = [&] { return Whole{random.integer(-reach, reach)}; };
  const Whole x = next(), y = next(), z = next();
  return {x, y, z};
}

inline Point to_point(const WholePoint& p) {
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

}  // namespace occlude::oracle
