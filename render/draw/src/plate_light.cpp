// SPDX-License-Identifier: MIT
#include "plate_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>

namespace occlude::render {
namespace {

using glm::dvec3;

/// Places around a pixel that are looked at, and how far away they are: a share of the height of the picture.
constexpr std::size_t kPlaces = 7;
constexpr double kReach = 0.05;

/// Places spread evenly over a disc of radius 1 (Vogel 1979).
std::array<glm::dvec2, kPlaces> spread_places() {
  constexpr double kGoldenAngle = 2.399963;
  std::array<glm::dvec2, kPlaces> places;
  for (std::size_t i = 0; i < kPlaces; ++i) {
    const double radius = std::sqrt((static_cast<double>(i) + 0.5) / kPlaces), angle = static_cast<double>(i) * kGoldenAngle;
    places[i] = {radius * std::cos(angle), radius * std::sin(angle)};
  }
  return places;
}

/// Surfaces that bend by less than this, as the sine of the angle, do not darken each other.
constexpr double kFlat = 0.08;

/// How much darker a corner is than it would be by what was found.
constexpr double kStrength = 2.2;

}  // namespace

double seen_sky(const SeenSurface& seen, int x, int y) {
  const dvec3 at = seen.position(x, y), normal = seen.normal(x, y);
  const double reach = kReach * seen.height(), radius = reach * seen.rays().pixel_size(seen.depth(x, y));
  const double angle = seen.noise(x, y), cosine = reach * std::cos(angle), sine = reach * std::sin(angle);
  static const std::array<glm::dvec2, kPlaces> kDisc = spread_places();
  double hidden = 0;
  for (const glm::dvec2& place : kDisc) {
    const int px = static_cast<int>(std::floor(x + 0.5 + cosine * place.x - sine * place.y));
    const int py = static_cast<int>(std::floor(y + 0.5 + sine * place.x + cosine * place.y));
    if (!seen.holds(px, py) || seen.polygon(px, py) == kNothing) continue;
    const dvec3 to = seen.position(px, py) - at;
    const double length = glm::length(to);
    if (length == 0 || length > radius) continue;
    hidden += std::max(0.0, glm::dot(to, normal) / length - kFlat) * (1 - length / radius);
  }
  return std::max(0.0, 1 - kStrength * hidden / kPlaces);
}

std::optional<culler::Camera> sun_camera(const SeenSurface& seen, culler::SoupView soup, double aspect) {
  // What is beyond four times the middle depth is small in the picture, and would make its shadows coarse.
  const double most = 4 * middle_depth(seen);
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  dvec3 low(kInfinity), high(-kInfinity);
  visit_some(seen, [&](int x, int y) {
    if (seen.depth(x, y) > most) return;
    low = glm::min(low, seen.position(x, y));
    high = glm::max(high, seen.position(x, y));
  });
  if (low.x > high.x) return std::nullopt;
  double behind = 0;  // the whole model is before the sun
  const dvec3 middle = 0.5 * low + 0.5 * high, sun = glm::normalize(kSun);
  for (const dvec3& v : soup.vertices) behind = std::max(behind, glm::dot(v - middle, sun));
  culler::Camera camera;
  camera.projection = culler::Projection::orthographic;
  camera.height = std::max(glm::length(high - low), behind * 1e-6);
  camera.aspect = aspect;
  camera.near_plane = std::max(behind, camera.height) * 1e-3;
  camera.eye = middle + (behind + 2 * camera.near_plane) * sun;
  camera.target = middle;
  return camera;
}

bool is_in_sun(const SeenSurface& from_sun, const dvec3& point, double angle) {
  const double depth = from_sun.rays().depth(point);
  // Looking a little beside the place makes smooth edges of what would be steps.
  constexpr double kBeside = 1.2;
  const glm::dvec2 at = from_sun.rays().project(point, depth) + kBeside * glm::dvec2(std::cos(angle), std::sin(angle));
  if (!(at.x >= 0 && at.y >= 0 && at.x < from_sun.width() && at.y < from_sun.height())) return true;
  const int x = static_cast<int>(at.x), y = static_cast<int>(at.y);
  constexpr double kPixels = 2.5;
  return from_sun.polygon(x, y) == kNothing || depth - from_sun.depth(x, y) < kPixels * from_sun.rays().pixel_size(depth);
}

}  // namespace occlude::render
