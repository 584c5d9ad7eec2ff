// SPDX-License-Identifier: MIT
#include "grid_sign.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "binary_parts.h"
#include "box_plane.h"

namespace occlude::kernel {

#ifdef __SIZEOF_INT128__
namespace {

__extension__ typedef __int128 Int128;  // NOLINT(modernize-use-using): __extension__ needs a declaration

/// A number is the sum of its digits times powers of 2^kDigit, lowest first. All but the last are in [0, 2^kDigit).
constexpr unsigned kDigit = 60;
constexpr Int128 kDigitMask = (Int128{1} << kDigit) - 1;
template <std::size_t size>
using Digits = std::array<std::int64_t, size>;

template <std::size_t size>
int sign(const Digits<size>& digits) {
  if (digits[size - 1] != 0) return digits[size - 1] > 0 ? 1 : -1;
  return std::ranges::any_of(digits, [](std::int64_t digit) { return digit != 0; }) ? 1 : 0;
}

/// Digits of a number whose coefficients need not be digits. REQUIRES: no coefficient is beyond 2^125, and the last is at
/// most 2^122, so that the last digit is at most 2^62 and a bit.
template <std::size_t size>
Digits<size + 1> carried(const std::array<Int128, size>& coefficients) {
  Digits<size + 1> digits;
  Int128 carry = 0;
  for (std::size_t i = 0; i < size; ++i) {
    carry += coefficients[i];
    digits[i] = static_cast<std::int64_t>(carry & kDigitMask);
    carry >>= kDigit;
  }
  digits[size] = static_cast<std::int64_t>(carry);
  return digits;
}

/// A power of two of which all numbers that it holds are multiples.
class Grid {
 public:
  void hold(double x) {
    if (x == 0) return;
    const BinaryParts parts(x);
    low_ = std::min(low_, parts.lowest());
    high_ = std::max(high_, parts.exponent + static_cast<int>(BinaryParts::kMantissaBits));
  }
  void hold(const Vec3& v) {
    for (int axis = 0; axis < 3; ++axis) hold(v[axis]);
  }
  void hold(const ExactPlane& plane) {
    for (const Vec3& v : {plane.a_to, plane.a_from, plane.origin}) hold(v);
    if (plane.direct) return;
    for (const Vec3& v : {plane.b_to, plane.b_from}) hold(v);
  }

  /// The numbers divided by the power are less than 2^bits() in magnitude. Negative if all are 0.
  [[nodiscard]] int bits() const { return high_ - low_; }

  /// x divided by the power. REQUIRES: it holds x; bits() <= 126.
  [[nodiscard]] Int128 integer(double x) const {
    if (x == 0) return 0;
    const BinaryParts parts(x);
    const Int128 magnitude = static_cast<Int128>(parts.odd()) << static_cast<unsigned>(parts.lowest() - low_);
    return x < 0 ? -magnitude : magnitude;
  }

 private:
  int low_ = 4096, high_ = -4096;  // beyond the exponents of doubles
};

/// A plane in integers whose differences have `size` digits. REQUIRES: the grid holds the plane and has kBits at most.
template <std::size_t size>
class GridPlane {
 public:
  /// Differences of numbers of this many bits are within ±2^(size * kDigit), so that their digits are within ±2^kDigit.
  static constexpr int kBits = static_cast<int>(size * kDigit) - 1;

  GridPlane(const Grid& grid, const ExactPlane& plane) : grid_(grid), origin_(plane.origin) {
    const Difference a = difference(plane.a_to, plane.a_from);
    if (plane.direct) {
      for (std::size_t i = 0; i < 3; ++i) normal_[i] = widened(a[i]);
      return;
    }
    const Difference b = difference(plane.b_to, plane.b_from);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t j = (i + 1) % 3, k = (i + 2) % 3;
      // Each coefficient is of at most 2 * size products within ±2^120.
      std::array<Int128, 2 * size - 1> coefficients{};
      for (std::size_t m = 0; m < size; ++m) {
        for (std::size_t n = 0; n < size; ++n) {
          coefficients[m + n] += Int128{a[j][m]} * b[k][n] - Int128{a[k][m]} * b[j][n];
        }
      }
      normal_[i] = carried(coefficients);
    }
  }

  [[nodiscard]] int normal_sign(std::size_t axis) const { return sign(normal_[axis]); }

  /// REQUIRES: the grid holds x.
  [[nodiscard]] int side_of(const Vec3& x) const {
    const Difference d = difference(x, origin_);
    // Each coefficient is of at most 3 * size products. Only those of the last digit of a normal exceed 2^120: they are
    // within ±2^122 and a bit.
    std::array<Int128, 3 * size - 1> coefficients{};
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t m = 0; m < 2 * size; ++m) {
        for (std::size_t n = 0; n < size; ++n) coefficients[m + n] += Int128{normal_[i][m]} * d[i][n];
      }
    }
    Int128 carry = 0;
    bool is_zero = true;
    for (const Int128 coefficient : coefficients) {
      carry += coefficient;
      is_zero = is_zero && (carry & kDigitMask) == 0;
      carry >>= kDigit;
    }
    if (carry != 0) return carry > 0 ? 1 : -1;
    return is_zero ? 0 : 1;
  }

 private:
  using Difference = std::array<Digits<size>, 3>;

  [[nodiscard]] Difference difference(const Vec3& to, const Vec3& from) const {
    Difference all;
    for (int axis = 0; axis < 3; ++axis) {
      Int128 left = grid_.integer(to[axis]) - grid_.integer(from[axis]);
      Digits<size>& digits = all[static_cast<std::size_t>(axis)];
      for (std::size_t i = 0; i + 1 < size; ++i) {
        digits[i] = static_cast<std::int64_t>(left & kDigitMask);
        left >>= kDigit;
      }
      digits[size - 1] = static_cast<std::int64_t>(left);
    }
    return all;
  }

  static Digits<2 * size> widened(const Digits<size>& digits) {
    std::array<Int128, 2 * size - 1> coefficients{};
    std::ranges::copy(digits, coefficients.begin());
    return carried(coefficients);
  }

  const Grid& grid_;
  Vec3 origin_;
  std::array<Digits<2 * size>, 3> normal_;
};

/// question(plane on the grid), in as few digits as the grid needs.
template <class Question>
std::optional<int> on_grid(const Grid& grid, const ExactPlane& plane, const Question& question) {
  if (grid.bits() <= GridPlane<1>::kBits) return question(GridPlane<1>(grid, plane));
  if (grid.bits() <= GridPlane<2>::kBits) return question(GridPlane<2>(grid, plane));
  return std::nullopt;
}

}  // namespace

std::optional<int> grid_sign(const ExactPlane& plane, const Vec3& x) {
  Grid grid;
  grid.hold(plane);
  grid.hold(x);
  return on_grid(grid, plane, [&](const auto& on) { return on.side_of(x); });
}

std::optional<int> grid_extremal_sign(const ExactPlane& plane, const Aabb& box, int direction) {
  Grid grid;
  grid.hold(plane);
  grid.hold(box.min);
  grid.hold(box.max);
  return on_grid(grid, plane, [&](const auto& on) {
    const auto positive = [&](std::size_t axis) { return direction * on.normal_sign(axis) >= 0; };
    return on.side_of(extremal_vertex(box, positive(0), positive(1), positive(2)));
  });
}

#else

// The other steps of the exact stage need no such integers.
std::optional<int> grid_sign(const ExactPlane&, const Vec3&) { return std::nullopt; }
std::optional<int> grid_extremal_sign(const ExactPlane&, const Aabb&, int) { return std::nullopt; }

#endif

}  // namespace occlude::kernel
