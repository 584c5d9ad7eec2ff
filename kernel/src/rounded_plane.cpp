// SPDX-License-Identifier: MIT
#include "rounded_plane.h"

#include <cmath>

namespace occlude::kernel {
namespace {

double uncertainty(const DoubleDouble& x) { return std::fabs(x.low.value) + x.low.error; }

}  // namespace

RoundedPlane rounded(const PlaneCoefficients<DoubleDoubleArithmetic>& plane) {
  const auto& [n, w] = plane;
  RoundedPlane result;
  FilterPlane& filter = result.filter;
  filter.normal = {n.x.high, n.y.high, n.z.high};
  filter.offset = w.high;
  const double magnitudes = std::fabs(n.x.high) + std::fabs(n.y.high) + std::fabs(n.z.high);
  filter.slope = (kPlaneError * magnitudes + (uncertainty(n.x) + uncertainty(n.y) + uncertainty(n.z))) * kBoundInflation;
  filter.base = (kOffsetError * std::fabs(w.high) + uncertainty(w)) * kBoundInflation;
  for (int k = 0; k < 3; ++k) {
    filter.farther[static_cast<std::size_t>(k)] = static_cast<std::uint8_t>(k + (filter.normal[k] >= 0 ? 4 : 0));
  }
  result.refined.normal = {n.x.low.value, n.y.low.value, n.z.low.value};
  result.refined.offset = w.low.value;
  result.refined.slope = (n.x.low.error + n.y.low.error + n.z.low.error) * kBoundInflation;
  result.refined.base = w.low.error;
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
