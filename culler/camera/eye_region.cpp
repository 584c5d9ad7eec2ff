// SPDX-License-Identifier: MIT
#include "camera/eye_region.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "camera/legal_numbers.h"

namespace occlude::culler {
namespace {

/// Half-edges of a box, those that are 0 at the end and replaced by others that are independent of the first `count`.
struct Edges {
  std::array<glm::dvec3, 3> edges{};
  int count = 0;

  explicit Edges(const std::array<glm::dvec3, 3>& half_edges) {
    for (const glm::dvec3& h : half_edges) {
      if (h != glm::dvec3(0)) edges[static_cast<std::size_t>(count++)] = h;
    }
    if (count == 2) edges[2] = glm::cross(edges[0], edges[1]);
    if (count != 1) return;
    // The two axes along which it is not longest.
    const glm::dvec3 size = glm::abs(edges[0]);
    const int longest = size.x >= size.y && size.x >= size.z ? 0 : size.y >= size.z ? 1 : 2;
    edges[1][(longest + 1) % 3] = edges[2][(longest + 2) % 3] = 1;
  }
};

/// A number, up to an error.
struct Rounded {
  double value, error;
};

/// det(a, b, c). The products of two coordinates and the sums round by four 2^-53 of their terms, c by one. Nothing is lost
/// where all terms are 0.
Rounded rounded_determinant(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 x = glm::abs(a), y = glm::abs(b);
  const glm::dvec3 terms{x.y * y.z + x.z * y.y, x.z * y.x + x.x * y.z, x.x * y.y + x.y * y.x};
  return {glm::dot(glm::cross(a, b), c), 0x1p-49 * glm::dot(terms, glm::abs(c))};
}

}  // namespace

/// With independent half-edges a, b and c, d = s a + t b + u c where s det(a, b, c) = det(d, b, c), and so on. Each of s, t
/// and u must be no more than 1; it must be 0 of half-edges that are not there, whatever stands in their place.
bool contains(const EyeRegion& eyes, const glm::dvec3& d, double error) {
  if (d == glm::dvec3(0) && error == 0) return true;
  if (eyes.radius > 0) return glm::length(d) * (1 + 0x1p-50) + error <= eyes.radius;
  const auto& [edges, count] = Edges(eyes.half_edges);
  const Rounded volume = rounded_determinant(edges[0], edges[1], edges[2]);
  const double least = std::fabs(volume.value) - volume.error;
  if (count == 0 || !(least > 0)) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3 &a = edges[(i + 1) % 3], &b = edges[(i + 2) % 3];
    const Rounded part = rounded_determinant(a, b, d);
    const double moved = error == 0 ? 0 : (1 + 0x1p-48) * error * glm::length(a) * glm::length(b);
    const double limit = static_cast<int>(i) < count ? (1 - 0x1p-50) * least : 0;
    if (!(std::fabs(part.value) + part.error + moved <= limit)) return false;
  }
  return true;
}

double EyeRegion::reach(const glm::dvec3& direction) const {
  double most = radius * glm::length(direction);
  for (const glm::dvec3& half_edge : half_edges) most += std::fabs(glm::dot(half_edge, direction));
  return most;
}

std::string_view fault(const EyeRegion& eyes) {
  if (!(eyes.radius == 0 || is_legal_length(eyes.radius)))
    return "the radius of the eyes must be 0, or positive and in range";
  if (!std::ranges::all_of(eyes.half_edges, is_legal)) return "a half-edge of the eyes is not finite or out of range";
  if (eyes.radius != 0 && eyes.half_edges != EyeRegion{}.half_edges) return "the eyes are in a ball or in a box, not both";
  return "";
}

}  // namespace occlude::culler
