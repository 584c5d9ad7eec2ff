// SPDX-License-Identifier: MIT
#include "differential/exact_visibility.h"

#include <cmath>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "occlude/oracle/visibility.h"

namespace occlude::fuzz {
namespace {

oracle::Point point(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

/// Along the line of sight in parallel light: the direction that the culler has, whose numbers are exact for both.
oracle::Viewpoint viewpoint(const culler::Camera& camera) {
  if (camera.projection == culler::Projection::perspective) return {point(camera.eye)};
  return {point(camera.axes().forward), true};
}

/// The picture's planes are drawn in by this share of its opening, and by kInward of the numbers that they are computed
/// from: far more than those are rounded by, 2^-53, and far less than anybody sees. What shows in this picture shows in the
/// renderer's.
constexpr double kNarrower = 0x1p-40, kInward = 0x1p-48;

oracle::HalfSpaceCoefficients half_space(const glm::dvec3& inward, const glm::dvec3& at) {
  const glm::dvec3 normal = glm::normalize(inward);
  const double size = std::fabs(at.x) + std::fabs(at.y) + std::fabs(at.z);
  return {normal.x, normal.y, normal.z, -glm::dot(normal, at) - kInward * size};
}

/// Written apart from the culler's view frustum, which it is to find fault with.
oracle::Picture picture_of(const culler::Camera& camera) {
  const auto [right, up, forward] = camera.axes();
  oracle::Picture picture;
  const bool perspective = camera.projection == culler::Projection::perspective;
  const double opening = perspective ? std::tan(glm::radians(camera.fov_y_deg) / 2) : camera.height / 2;
  const double y = opening * (1 - kNarrower), x = y * camera.aspect;
  for (const auto& [half, across] : {std::pair{x, right}, {x, -right}, {y, up}, {y, -up}}) {
    picture.sides.push_back(perspective ? half_space(half * forward - across, camera.eye)
                                        : half_space(-across, camera.eye + half * across));
  }
  picture.depth.push_back(half_space(forward, camera.eye + camera.near * (1 + kNarrower) * forward));
  if (std::isfinite(camera.far)) {
    picture.depth.push_back(half_space(-forward, camera.eye + camera.far * (1 - kNarrower) * forward));
  }
  return picture;
}

}  // namespace

std::vector<bool> visible_triangles(const culler::PolygonSoup& soup, const culler::Camera& camera) {
  std::vector<oracle::Triangle> triangles;
  for (std::size_t p = 0; p < soup.size(); ++p) {
    const auto loop = soup.loop(p);
    for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
      triangles.push_back({point(soup.vertices[loop[0]]), point(soup.vertices[loop[i]]), point(soup.vertices[loop[i + 1]])});
    }
  }
  return oracle::visible_triangles(viewpoint(camera), triangles, picture_of(camera));
}

}  // namespace occlude::fuzz
