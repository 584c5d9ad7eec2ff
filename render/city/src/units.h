// SPDX-License-Identifier: MIT
// Lengths and points of the model as integers, so that every compiler gives the same model.
#pragma once

#include <cstdint>

namespace occlude::render::city {

/// A length in units of 2^-10 m. All construction is integer arithmetic; the doubles of the finished model are exact
/// multiples of the unit, and floats up to 2^14 m are too.
using Length = std::int64_t;

inline constexpr Length kUnitsPerMetre = 1024;

/// The multiple of the unit nearest to `metres`. Multiplying by a power of two is exact, so no rounding mode matters.
[[nodiscard]] constexpr Length m(double metres) {
  const double scaled = metres * 1024.0;
  return static_cast<Length>(scaled < 0 ? scaled - 0.5 : scaled + 0.5);
}

/// The integer square root of `value`, rounded down. REQUIRES: 0 <= value < 2^62.
[[nodiscard]] constexpr Length integer_sqrt(Length value) {
  Length root = 0;
  for (Length bit = Length{1} << 30; bit > 0; bit >>= 1) {
    if ((root + bit) * (root + bit) <= value) root += bit;
  }
  return root;
}

/// A quotient rounded up. REQUIRES: a >= 0, b > 0.
[[nodiscard]] constexpr Length divide_up(Length a, Length b) { return (a + b - 1) / b; }

struct Point {
  Length x = 0, y = 0, z = 0;
};

/// A rectangle of ground with sides along the axes.
struct Rect {
  Length x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  [[nodiscard]] constexpr Length width() const { return x1 - x0; }
  [[nodiscard]] constexpr Length depth() const { return y1 - y0; }
  /// The rectangle with each side moved inwards by `margin` (outwards when negative).
  [[nodiscard]] constexpr Rect inset(Length margin) const { return {x0 + margin, y0 + margin, x1 - margin, y1 - margin}; }
  [[nodiscard]] constexpr bool meets(const Rect& other) const {
    return x0 <= other.x1 && other.x0 <= x1 && y0 <= other.y1 && other.y0 <= y1;
  }
};

}  // namespace occlude::render::city
