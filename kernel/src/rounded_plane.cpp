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
  const TwoTerms x = two_difference(vertex.x, origin.x), y = two_difference(vertex.y, origin.y),
                 z = two_difference(vertex.z, origin.z);
  const Vec3 &n = plane.normal, &m = tail.normal;
  const TwoTerms px = two_product(n.x, x.high), py = two_product(n.y, y.high), pz = two_product(n.z, z.high);
  const TwoTerms xy = two_sum(px.high, py.high), xyz = two_sum(xy.high, pz.high), sum = two_sum(xyz.high, plane.offset);
  const double lost = ((px.low + py.low) + (pz.low + xy.low)) + (xyz.low + sum.low);
  const double tails =
      ((n.x * x.low + m.x * x.high) + (n.y * y.low + m.y * y.high)) + ((n.z * z.low + m.z * z.high) + tail.offset);
  const double value = sum.high + (lost + tails);
  const double magnitude = (std::fabs(px.high) + std::fabs(py.high)) + (std::fabs(pz.high) + std::fabs(plane.offset));
  const double error = kRefinedError * magnitude + (tail.slope * reach + tail.base) * kBoundInflation;
  if (std::fabs(value) > error) return {value > 0 ? 1 : -1, true};
  const bool nothing_lost = px.low == 0 && py.low == 0 && pz.low == 0 && xy.low == 0 && xyz.low == 0 && sum.low == 0;
  const bool no_tails = x.low == 0 && y.low == 0 && z.low == 0 && m == Vec3{} && tail.offset == 0;
  if (nothing_lost && no_tails && tail.slope == 0 && tail.base == 0) return {(value > 0) - (value < 0), true};
  return {};
}

}  // namespace occlude::kernel
