// SPDX-License-Identifier: MIT
#include "comparison.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <set>

namespace occlude::render {
namespace {

/// The rasteriser rounds the vertices of each polygon to 1/256 pixel, so that a border moves by at most half of that on each
/// axis, sqrt(2)/512; the occluder's border and the hidden polygon's may move towards each other.
const double kSnapping = 2 * std::sqrt(2.0) / 512;

/// The position of a point in the picture, in pixels from the top left corner. REQUIRES: the point is before the camera.
glm::dvec2 project(const culler::Camera& camera, const culler::Camera::Axes& axes, const glm::dvec3& point, int width, int height) {
  const glm::dvec3 v = point - camera.eye;
  double x = glm::dot(v, axes.right), y = glm::dot(v, axes.up);
  double half_height = camera.height / 2;
  if (camera.projection == culler::Projection::perspective) {
    half_height = std::tan(glm::radians(camera.fov_y_deg) / 2) * glm::dot(v, axes.forward);
  }
  x /= half_height * camera.aspect;
  y /= half_height;
  return {(1 + x) / 2 * width, (1 - y) / 2 * height};
}

double distance_to_segment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 ab = b - a;
  const double length = glm::dot(ab, ab);
  const double t = length == 0 ? 0 : std::clamp(glm::dot(p - a, ab) / length, 0.0, 1.0);
  return glm::distance(p, a + t * ab);
}

/// What a frame did to each polygon.
class Fate {
 public:
  Fate(const culler::Culler& culler, const culler::CullResult& result) : culler_(culler), result_(result) {}

  /// The cull that took a polygon; none if it was drawn.
  [[nodiscard]] const culler::Culled* cull_of(std::uint32_t polygon) const {
    const auto& nodes = culler_.hierarchy().nodes();
    // Culled subtrees come in the order of the soup.
    const auto after = std::upper_bound(result_.culled.begin(), result_.culled.end(), polygon,
                                        [&](std::uint32_t p, const culler::Culled& c) { return p < nodes[c.node].first; });
    if (after == result_.culled.begin()) return nullptr;
    const culler::Culled& last = *std::prev(after);
    const auto& node = nodes[last.node];
    return polygon < node.first + node.count ? &last : nullptr;
  }

 private:
  const culler::Culler& culler_;
  const culler::CullResult& result_;
};

/// Whether the centre of the pixel is within snapping of the silhouette of the occluder that took the polygon.
bool is_snapping(const culler::Culled& cull, const culler::CullResult& result, const culler::Camera& camera,
                 const culler::Camera::Axes& axes, int x, int y, int width, int height) {
  if (cull.by != culler::Culled::By::shadow) return false;
  const auto corners = result.occluders[cull.index].frustum.silhouette();
  const glm::dvec2 centre{x + 0.5, y + 0.5};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const auto at = [&](std::size_t k) {
      const kernel::Vec3& c = corners[k % corners.size()];
      return project(camera, axes, {c.x, c.y, c.z}, width, height);
    };
    if (distance_to_segment(centre, at(i), at(i + 1)) <= kSnapping) return true;
  }
  return false;
}

}  // namespace

void compare(const Picture& full, const Picture& culled, const culler::Culler& culler, const culler::Camera& camera,
             const culler::CullResult& result, FrameRecord& record) {
  const Fate fate(culler, result);
  const auto axes = camera.axes();
  std::vector<std::uint32_t> visible;
  std::set<std::uint32_t> falsely_culled;
  const int width = full.items.width, height = full.items.height;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::uint32_t polygon = full.items.at(x, y);
      if (polygon != kNothing && (visible.empty() || visible.back() != polygon)) visible.push_back(polygon);
      const bool same = full.image.at(x, y) == culled.image.at(x, y) && polygon == culled.items.at(x, y);
      if (same) continue;
      ++record.wrong_pixels;
      const culler::Culled* cull = polygon == kNothing ? nullptr : fate.cull_of(polygon);
      if (cull && is_snapping(*cull, result, camera, axes, x, y, width, height)) {
        ++record.snapped_pixels;
      } else if (cull) {
        falsely_culled.insert(polygon);
      }
    }
  }
  std::sort(visible.begin(), visible.end());
  record.visible_polygons = static_cast<std::size_t>(std::unique(visible.begin(), visible.end()) - visible.begin());
  record.false_culls += falsely_culled.size();
}

}  // namespace occlude::render
