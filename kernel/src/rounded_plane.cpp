// SPDX-License-Identifier: MIT
#include "rounded_plane.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

namespace occlude::kernel {
namespace {

/// The power of two that brings the slope of a bound into [1/2, 1). Scaling by it is exact. Slopes lie in [2^-509, 2^257)
/// (error_bounds.h); a smaller one is scaled as 2^-509 is.
double scale_of(double slope) {
  constexpr std::uint64_t kMantissa = 52, kExponentOfOne = 1023;
  const std::uint64_t exponent = std::max(std::bit_cast<std::uint64_t>(slope) >> kMantissa, kExponentOfOne - 509);
  return std::bit_cast<double>((2 * kExponentOfOne - 1 - exponent) << kMantissa);
}

}  // namespace

RoundedPlane rounded(const PlaneCoefficients<DoubleDoubleArithmetic>& plane) {
  const auto& [n, w] = plane;
  const auto parts = [](const DoubleDouble& x) { return RoundedNumber<double>{x.high, x.low.value, x.low.error}; };
  const Vector3<RoundedNumber<double>> normal{parts(n.x), parts(n.y), parts(n.z)};
  const FilterBound bound = filter_bound(normal, parts(w)), uncertainty = refined_uncertainty(normal, parts(w));
  const double scale = scale_of(bound.slope);

  RoundedPlane result;
  FilterPlane& filter = result.filter;
  filter.normal = {scale * n.x.high, scale * n.y.high, scale * n.z.high};
  filter.magnitudes = {std::fabs(filter.normal.x), std::fabs(filter.normal.y), std::fabs(filter.normal.z)};
  filter.offset = scale * w.high;
  for (int k = 0; k < 3; ++k) {
    filter.farther[static_cast<std::size_t>(k)] = static_cast<std::uint8_t>(k + (filter.normal[k] >= 0 ? 4 : 0));
  }
  result.bound = {scale * bound.slope, scale * bound.base};
  result.refined.normal = {scale * n.x.low.value, scale * n.y.low.value, scale * n.z.low.value};
  result.refined.offset = scale * w.low.value;
  result.refined.uncertainty = {scale * uncertainty.slope, scale * uncertainty.base};
  return result;
}

}  // namespace occlude::kernel
