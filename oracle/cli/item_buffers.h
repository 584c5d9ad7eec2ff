// SPDX-License-Identifier: MIT
// Item buffers of a frame in several sizes and at several sub-pixel offsets, so that small gaps are hit.
#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <memory>
#include <string>
#include <vector>

#include "occlude/culler/camera.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/render/image.h"
#include "occlude/render/offscreen_context.h"
#include "occlude/render/scene_renderer.h"

namespace occlude::cli {

class ItemBuffers {
 public:
  /// The sizes are one, two and three times `width` by `height` pixels, as far as they are within the limit for pictures.
  ItemBuffers(culler::SoupView soup, int width, int height);

  static constexpr std::size_t kOffsets = 16;  ///< a quarter of a pixel apart
  /// Right and up, in pixels. None reaches half a pixel, so a pixel at the border does not see beyond the picture.
  [[nodiscard]] static glm::dvec2 offset_of(std::size_t turn);
  [[nodiscard]] std::size_t sizes() const { return renderers_.size(); }

  /// The polygon at each pixel. Consecutive turns go through the sizes and offsets. Any sizes() * kOffsets consecutive turns
  /// have every pair once.
  [[nodiscard]] render::ItemBuffer draw(std::size_t turn, const culler::Camera& camera);

  /// Describes the size and the offset of draw(), as text.
  [[nodiscard]] std::string describe(std::size_t turn) const;

  /// The frame as it is drawn in the smallest size, with the `marked` polygons in magenta.
  [[nodiscard]] render::Image picture(const culler::Camera& camera, const std::vector<culler::PolygonRange>& marked);

 private:
  struct Sized {
    int width, height;
    std::unique_ptr<render::SceneRenderer> renderer;
  };

  [[nodiscard]] std::size_t size_of(std::size_t turn) const;

  culler::SoupView soup_;
  std::unique_ptr<render::OffscreenContext> context_;
  std::vector<Sized> renderers_;
  std::vector<culler::PolygonRange> drawn_;
};

}  // namespace occlude::cli
