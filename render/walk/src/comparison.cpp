// SPDX-License-Identifier: MIT
#include "comparison.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <set>
#include <span>

namespace occlude::render {
namespace {

/// The rasteriser rounds the vertices of each polygon to 1/256 pixel, so a border moves by at most 1/512 on each axis,
/// sqrt(2)/512 in all. The borders of the occluder and of the hidden polygon can move towards each other.
const double kSnapping = 2 * std::sqrt(2.0) / 512;

/// Maps points of the model to the picture.
class Projector {
 public:
  Projector(const culler::Camera& camera, int width, int height)
      : camera_(camera), axes_(camera.axes()), width_(width), height_(height) {}

  /// In pixels from the top left corner. REQUIRES: the point is in front of the camera.
  [[nodiscard]] glm::dvec2 operator()(const glm::dvec3& point) const {
    const glm::dvec3 v = point - camera_.eye;
    const double half_height = camera_.projection == culler::Projection::perspective
                                   ? std::tan(glm::radians(camera_.fov_y_deg) / 2) * glm::dot(v, axes_.forward)
                                   : camera_.height / 2;
    const double x = glm::dot(v, axes_.right) / (half_height * camera_.aspect), y = glm::dot(v, axes_.up) / half_height;
    return {(1 + x) / 2 * width_, (1 - y) / 2 * height_};
  }

 private:
  const culler::Camera& camera_;
  culler::Camera::Axes axes_;
  double width_, height_;
};

double distance_to_segment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 ab = b - a;
  const double length = glm::dot(ab, ab);
  const double t = length == 0 ? 0 : std::clamp(glm::dot(p - a, ab) / length, 0.0, 1.0);
  return glm::distance(p, a + t * ab);
}

double distance_to_outline(const glm::dvec2& p, std::span<const glm::dvec2> outline) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < outline.size(); ++i) {
    nearest = std::min(nearest, distance_to_segment(p, outline[i], outline[(i + 1) % outline.size()]));
  }
  return nearest;
}

/// Whether the pixel's centre is within kSnapping of the occluder's silhouette.
bool is_on_silhouette(const glm::dvec2& centre, const Projector& project, const culler::Occluder& occluder) {
  std::vector<glm::dvec2> silhouette;
  for (const kernel::Vec3& c : occluder.frustum.silhouette()) silhouette.push_back(project({c.x, c.y, c.z}));
  return distance_to_outline(centre, silhouette) <= kSnapping;
}

/// Whether the rounding can make this pixel show a polygon culled by one shadow, or by two together.
bool is_snapping(const glm::dvec2& centre, const Projector& project, const culler::CullResult& result,
                 const culler::Culled& cull) {
  const auto is_on = [&](std::uint32_t i) { return is_on_silhouette(centre, project, result.occluders[i]); };
  return is_on(cull.index) || (cull.second != culler::Culled::kNone && is_on(cull.second));
}

}  // namespace

std::vector<std::uint32_t> compare(const Picture& full, const Picture& culled, const culler::Culler& culler,
                                   const culler::Camera& camera, const culler::CullResult& result, FrameRecord& record) {
  std::vector<std::uint32_t> visible;
  std::set<std::uint32_t> falsely_culled;
  const int width = full.items.width, height = full.items.height;
  const Projector project(camera, width, height);
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const std::uint32_t polygon = full.items.at(x, y);
      if (polygon != kNothing && (visible.empty() || visible.back() != polygon)) visible.push_back(polygon);
      const bool same = full.image.at(x, y) == culled.image.at(x, y) && polygon == culled.items.at(x, y);
      if (same) continue;
      ++record.wrong_pixels;
      const culler::Culled* cull = polygon == kNothing ? nullptr : culler.cull_of(result, polygon);
      if (cull && cull->by == culler::Culled::By::shadow && is_snapping({x + 0.5, y + 0.5}, project, result, *cull)) {
        ++record.snapped_pixels;
      } else if (cull) {
        falsely_culled.insert(polygon);
      }
    }
  }
  std::sort(visible.begin(), visible.end());
  visible.erase(std::unique(visible.begin(), visible.end()), visible.end());
  record.visible_polygons = visible.size();
  record.false_culls += falsely_culled.size();
  return visible;
}

}  // namespace occlude::render
