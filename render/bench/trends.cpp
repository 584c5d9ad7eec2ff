// SPDX-License-Identifier: MIT
#include "trends.h"

#include <algorithm>
#include <cmath>

namespace occlude::experiments {

std::size_t knee(std::span<const double> values) {
  const auto reaches = [&](double value) { return value >= 0.9 * values.back(); };
  return static_cast<std::size_t>(std::ranges::find_if(values, reaches) - values.begin());
}

std::optional<double> fitted_exponent(std::span<const double> x, std::span<const double> y) {
  double mean_x = 0, mean_y = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    mean_x += std::log(x[i]) / static_cast<double>(x.size());
    mean_y += std::log(y[i]) / static_cast<double>(x.size());
  }
  double covariance = 0, variance = 0;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double dx = std::log(x[i]) - mean_x;
    covariance += dx * (std::log(y[i]) - mean_y);
    variance += dx * dx;
  }
  if (x.empty() || std::ranges::min(x) == std::ranges::max(x)) return std::nullopt;
  return covariance / variance;
}

}  // namespace occlude::experiments
