// SPDX-License-Identifier: MIT
// What is seen at each pixel: which polygon, and where it is there.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>

#include "occlude/culler/polygon_soup.h"
#include "occlude/render/image.h"
#include "occlude/render/pixel_rays.h"

namespace occlude::render {

/// Items, with depths from the planes of the polygons.
class SeenSurface {
 public:
  /// `offset` is that of the item buffer, and `normals` are those of the polygons.
  SeenSurface(const Items& items, const glm::dvec2& offset, const PixelRays& rays, culler::SoupView soup,
              std::span<const glm::dvec3> normals);

  [[nodiscard]] int width() const { return items_.width; }
  [[nodiscard]] int height() const { return items_.height; }
  [[nodiscard]] bool holds(int x, int y) const { return x >= 0 && y >= 0 && x < width() && y < height(); }
  /// The polygon, or kNothing.
  [[nodiscard]] std::uint32_t polygon(int x, int y) const { return items_.at(x, y); }
  /// REQUIRES: there is a polygon at the pixel. The same holds of position() and normal().
  [[nodiscard]] double depth(int x, int y) const { return static_cast<double>(depths_.at(x, y)); }
  [[nodiscard]] glm::dvec3 position(int x, int y) const { return ray(x, y).at(depth(x, y)); }
  /// Turned to the eye.
  [[nodiscard]] glm::dvec3 normal(int x, int y) const;
  [[nodiscard]] const PixelRays& rays() const { return rays_; }
  /// An angle in [0, 2 pi) that looks random from pixel to pixel, and from one offset to the next.
  [[nodiscard]] double noise(int x, int y) const;

 private:
  [[nodiscard]] PixelRays::Ray ray(int x, int y) const { return rays_.ray(x + 0.5 - offset_.x, y + 0.5 + offset_.y); }

  const Items& items_;
  glm::dvec2 offset_;
  const PixelRays& rays_;
  std::span<const glm::dvec3> normals_;
  Raster<float> depths_;
};

/// Half of what is seen is nearer; 0 if nothing is seen. Looks at one pixel in 64.
[[nodiscard]] double middle_depth(const SeenSurface& seen);

/// Calls visit(x, y) for one pixel in 64, if there is a polygon.
template <class Visit>
void visit_some(const SeenSurface& seen, const Visit& visit) {
  constexpr int kStep = 8;
  for (int y = kStep / 2; y < seen.height(); y += kStep) {
    for (int x = kStep / 2; x < seen.width(); x += kStep) {
      if (seen.polygon(x, y) != kNothing) visit(x, y);
    }
  }
}

}  // namespace occlude::render
