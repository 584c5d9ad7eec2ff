// SPDX-License-Identifier: MIT
// Trends of a series of measurements: the knee, and the exponent of growth.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace occlude::experiments {

/// The index of the first of `values`, a curve of diminishing returns, that reaches nine tenths of the last: everything
/// beyond adds at most a tenth. REQUIRES: not empty, no negative value.
[[nodiscard]] std::size_t knee(std::span<const double> values);

/// The exponent e of the power law y = c x^e that fits best, by least squares of the logarithms; empty for fewer than two
/// different x. REQUIRES: as many y as x, all positive.
[[nodiscard]] std::optional<double> fitted_exponent(std::span<const double> x, std::span<const double> y);

}  // namespace occlude::experiments
