// SPDX-License-Identifier: MIT
#include "comparison.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <map>
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

/// Finds out what the pixels tell at which two pictures differ.
class Differences {
 public:
  Differences(const ItemBuffer& full, const culler::Culler& culler, const culler::Camera& camera,
              const culler::CullResult& result)
      : culler_(culler), result_(result), project_(camera, full.width, full.height) {
    for (std::uint32_t p = 0; p < full.see_through.size(); ++p) {
      if (full.see_through[p] != 0 && culler.cull_of(result, p) != nullptr) missing_.emplace(p, full.see_through[p]);
    }
  }

  /// Whether rounding explains a pixel in which this polygon shows without culling.
  bool is_explained(const glm::dvec2& centre, std::uint32_t polygon) {
    const culler::Culled* const cull = polygon == kNothing ? nullptr : culler_.cull_of(result_, polygon);
    bool is_explained = cull && is_snapping_at(centre, *cull);
    if (cull && !is_explained) falsely_culled_.insert(polygon);
    for (auto& [see_through, pixels] : missing_) {
      if (pixels == 0 || !is_snapping_at(centre, *culler_.cull_of(result_, see_through))) continue;
      --pixels;
      is_explained |= cull == nullptr;
    }
    return is_explained;
  }
  /// After all pixels.
  [[nodiscard]] std::size_t false_culls() const {
    const auto is_seen = [](const auto& missing) { return missing.second != 0; };
    return falsely_culled_.size() + static_cast<std::size_t>(std::ranges::count_if(missing_, is_seen));
  }

 private:
  [[nodiscard]] bool is_snapping_at(const glm::dvec2& centre, const culler::Culled& cull) const {
    return cull.by == culler::Culled::By::shadow && is_snapping(centre, project_, result_, cull);
  }

  const culler::Culler& culler_;
  const culler::CullResult& result_;
  Projector project_;
  std::set<std::uint32_t> falsely_culled_;          ///< opaque ones
  std::map<std::uint32_t, std::uint32_t> missing_;  ///< culled see-through polygons that show; their unexplained pixels
};

}  // namespace

std::vector<std::uint32_t> compare(const Picture& full, const Picture& culled, const culler::Culler& culler,
                                   const culler::Camera& camera, const culler::CullResult& result, FrameRecord& record) {
  Differences differences(full.items, culler, camera, result);
  for (int y = 0; y < full.items.height; ++y) {
    for (int x = 0; x < full.items.width; ++x) {
      const std::uint32_t polygon = full.items.at(x, y);
      if (full.image.at(x, y) == culled.image.at(x, y) && polygon == culled.items.at(x, y)) continue;
      ++record.wrong_pixels;
      if (differences.is_explained({x + 0.5, y + 0.5}, polygon)) ++record.snapped_pixels;
    }
  }
  const std::vector<std::uint32_t> pixels = full.items.pixels_of(culler.hierarchy().soup().size());
  std::vector<std::uint32_t> visible;
  for (std::uint32_t p = 0; p < pixels.size(); ++p) {
    if (pixels[p] != 0) visible.push_back(p);
  }
  record.visible_polygons = visible.size();
  record.false_culls += differences.false_culls();
  return visible;
}

}  // namespace occlude::render
