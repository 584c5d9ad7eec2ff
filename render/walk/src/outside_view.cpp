// SPDX-License-Identifier: MIT
#include "outside_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <limits>
#include <span>

#include "model/bounds.h"

namespace occlude::render {
namespace {

constexpr Rgba kFrustumLine{20, 60, 200, 255}, kShadowLine{255, 160, 0, 255};

}  // namespace

double depth_of_scene(const culler::Culler& culler, const culler::Camera& camera, const std::vector<PolygonRange>& drawn) {
  const culler::SoupView soup = culler.hierarchy().soup();
  std::vector<double> distances;
  for (const PolygonRange& range : drawn) {
    for (std::uint32_t p = range.first; p < range.first + range.count; ++p) {
      distances.push_back(glm::distance(soup.vertices[soup.loop(p)[0]], camera.eye));
    }
  }
  if (distances.empty()) return 1;
  const auto quantile = distances.begin() + static_cast<std::ptrdiff_t>(distances.size() * 2 / 5);
  std::nth_element(distances.begin(), quantile, distances.end());
  return std::max(*quantile, 100 * camera.near_plane);
}

culler::Camera outside_camera(const culler::Camera& camera, double depth) {
  culler::Camera outside = camera;
  const glm::dvec3 up = glm::normalize(camera.up);
  glm::dvec3 ahead = camera.axes().forward;
  ahead -= glm::dot(ahead, up) * up;
  ahead = glm::length(ahead) > 0 ? glm::normalize(ahead) : camera.axes().up;
  outside.projection = culler::Projection::perspective;
  outside.fov_y_deg = 50;
  outside.near_plane = depth / 1000;
  outside.far_plane = std::numeric_limits<double>::infinity();
  outside.eye = camera.eye - 0.55 * depth * ahead + 0.95 * depth * up;
  outside.target = camera.eye + 0.42 * depth * ahead;
  return outside;
}

std::optional<Cut> cut_between(const culler::Camera& camera, const culler::Camera& outside, SceneRenderer& renderer,
                               culler::SoupView soup) {
  culler::Camera back = outside;
  back.eye = camera.eye;
  back.target = outside.eye;
  back.near_plane = camera.near_plane;
  const PolygonRange all = soup.all();
  const ItemBuffer items = renderer.item_buffer(back, std::span(&all, 1));
  const std::uint32_t between = items.at(items.width / 2, items.height / 2);
  if (between == kNothing) return std::nullopt;
  const glm::dvec3 normal = culler::doubled_area(soup, soup.loop(between)), way = outside.eye - camera.eye;
  const double share = glm::dot(normal, soup.vertices[soup.loop(between)[0]] - camera.eye) / glm::dot(normal, way);
  if (!(share > 0 && share < 1)) return std::nullopt;
  const glm::dvec3 up = glm::normalize(camera.up);
  return Cut{up, glm::dot(up, camera.eye + share / 2 * way)};
}

void add_frustum(std::vector<Line>& lines, const culler::Camera& camera, double depth) {
  const auto [right, up, forward] = camera.axes();
  const bool perspective = camera.projection == culler::Projection::perspective;
  const double half = perspective ? std::tan(glm::radians(camera.fov_y_deg) / 2) * depth : camera.height / 2;
  std::array<glm::dvec3, 4> base, corner;
  for (std::size_t i = 0; i < 4; ++i) {
    const double x = i == 0 || i == 3 ? -1 : 1, y = i < 2 ? -1 : 1;
    const glm::dvec3 offset = half * (x * camera.aspect * right + y * up);
    base[i] = perspective ? camera.eye : camera.eye + offset;
    corner[i] = camera.eye + depth * forward + offset;
  }
  for (std::size_t i = 0; i < 4; ++i) {
    lines.push_back({base[i], corner[i], kFrustumLine});
    lines.push_back({corner[i], corner[(i + 1) % 4], kFrustumLine});
  }
}

void add_shadow(std::vector<Line>& lines, const culler::Occluder& occluder, const culler::Camera& camera, double depth) {
  for (const kernel::Vec3& c : occluder.frustum.silhouette()) {
    const glm::dvec3 corner{c.x, c.y, c.z};
    const glm::dvec3 along =
        camera.projection == culler::Projection::perspective ? glm::normalize(corner - camera.eye) : camera.axes().forward;
    lines.push_back({corner, corner + depth * along, kShadowLine});
  }
}

}  // namespace occlude::render
