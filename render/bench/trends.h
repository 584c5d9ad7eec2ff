// SPDX-License-Identifier: MIT
// What a row of measurements says: where it bends, and how fast it grows.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace occlude::experiments {

/// The place in `values`, an ascending curve of decreasing returns, of the first that reaches nine tenths of the last: where
/// all that is beyond would add a tenth at most. REQUIRES: not empty, no value negative.
[[nodiscard]] std::size_t knee(std::span<const double> values);

/// The exponent e of the power law y = c x^e that fits best, by least squares of the logarithms; none for fewer than two
/// different x. REQUIRES: as many y as x, all of them positive.
[[nodiscard]] std::optional<double> fitted_exponent(std::span<const double> x, std::span<const double> y);

}  // namespace occlude::experiments
