// SPDX-License-Identifier: MIT
#include "rounded_plane.h"

#include <cmath>

namespace occlude::kernel {
namespace {

double uncertainty(const DoubleDouble& x) { return std::fabs(x.low.value) + x.low.error; }

}  // namespace

RoundedPlane rounded(const PlaneCoefficients<DoubleDoubleArithmetic>& plane) {
  const auto& [n, w] = plane;
  const double magnitudes = std::fabs(n.x.high) + std::fabs(n.y.high) + std::fabs(n.z.high);
  const double slope =
      (kPlaneError * magnitudes + (uncertainty(n.x) + uncertainty(n.y) + uncertainty(n.z))) * kBoundInflation;
  const double base = (kOffsetError * std::fabs(w.high) + uncertainty(w)) * kBoundInflation;
  int exponent = 0;
  std::frexp(slope, &exponent);
  const double scale = std::ldexp(1.0, -exponent);  // exact, and so is all scaling by it

  RoundedPlane result;
  FilterPlane& filter = result.filter;
  filter.normal = {scale * n.x.high, scale * n.y.high, scale * n.z.high};
  filter.magnitudes = {std::fabs(filter.normal.x), std::fabs(filter.normal.y), std::fabs(filter.normal.z)};
  filter.offset = scale * w.high;
  for (int k = 0; k < 3; ++k) {
    filter.farther[static_cast<std::size_t>(k)] = static_cast<std::uint8_t>(k + (filter.normal[k] >= 0 ? 4 : 0));
  }
  result.bound = {scale * slope, scale * base};
  result.refined.normal = {scale * n.x.low.value, scale * n.y.low.value, scale * n.z.low.value};
  result.refined.offset = scale * w.low.value;
  result.refined.slope = scale * ((n.x.low.error + n.y.low.error + n.z.low.error) * kBoundInflation);
  result.refined.base = scale * w.low.error;
  return result;
}

CertainSign refined_sign(const FilterPlane& plane, const RefinedPlane& tail, const Vec3& vertex, const Vec3& origin,
                         double reach) {
  const auto real = [](const Vec3& v) { return constants<PlainArithmetic>(v); };
  const auto [value, error, is_exact] = refined_value(real(plane.normal), plane.offset, real(tail.normal), tail.offset,
                                                      tail.slope * reach + tail.base, real(vertex), real(origin));
  if (std::fabs(value) > error || is_exact) return {PlainArithmetic::sign(value), true};
  return {};
}

}  // namespace occlude::kernel
