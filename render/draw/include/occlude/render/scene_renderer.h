// SPDX-License-Identifier: MIT
// Draws ranges of a polygon soup off screen: shaded pictures and item buffers.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "occlude/culler/camera.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/render/image.h"

namespace occlude::render {

using culler::PolygonRange;

/// A set of ranges drawn in one style.
struct Layer {
  std::span<const PolygonRange> ranges;
  std::optional<Rgba> tint;  ///< blended over the polygon's own colour by its alpha; none: no tint
};

/// A straight line in model space, drawn over the picture; its hidden parts are faint.
struct Line {
  glm::dvec3 from{0, 0, 0}, to{0, 0, 0};
  Rgba colour;
};

class SceneRenderer {
 public:
  /// Uploads the polygons in their order; an item buffer holds their indices. Coordinates are recentred before they are
  /// converted to float. Throws std::runtime_error if the picture or the model is larger than OpenGL allows.
  /// REQUIRES: an OffscreenContext current on this thread, for the lifetime of the object.
  SceneRenderer(const culler::PolygonSoup& soup, int width, int height);
  ~SceneRenderer();
  SceneRenderer(const SceneRenderer&) = delete;
  SceneRenderer& operator=(const SceneRenderer&) = delete;

  /// Clears and draws. Returns when the picture is finished (glFinish), so that callers can time it. Of polygons at equal
  /// depth the first one drawn is visible, so leaving out hidden polygons changes no pixel.
  void draw(const culler::Camera& camera, std::span<const Layer> layers, std::span<const Line> lines = {});

  /// The picture of the last draw().
  [[nodiscard]] Image image() const;

  /// The polygon that draw() shows at each pixel, from the same vertices and rasterisation, in a separate pass: it does not
  /// slow draw() down and keeps the last picture. `offset` moves the picture right and up, in pixels, to sample points
  /// between the pixel centres.
  [[nodiscard]] ItemBuffer item_buffer(const culler::Camera& camera, std::span<const PolygonRange> ranges,
                                       const glm::dvec2& offset = {0, 0});

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace occlude::render
