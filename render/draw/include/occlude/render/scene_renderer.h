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

/// A set of ranges drawn in one manner.
struct Layer {
  std::span<const PolygonRange> ranges;
  std::optional<Rgba> tint;  ///< blends this colour (by its alpha) over the polygon's own; none: as it is
};

/// A straight line in model space, drawn over the picture: faintly where something hides it.
struct Line {
  glm::dvec3 from{0, 0, 0}, to{0, 0, 0};
  Rgba colour;
};

class SceneRenderer {
 public:
  /// Uploads the polygons in their order; pixels of an item buffer hold their index. Coordinates are recentred before they
  /// are narrowed to float. Throws std::runtime_error for a picture or model larger than OpenGL allows.
  /// REQUIRES: an OffscreenContext current on this thread, for the lifetime of the object.
  SceneRenderer(const culler::PolygonSoup& soup, int width, int height);
  ~SceneRenderer();
  SceneRenderer(const SceneRenderer&) = delete;
  SceneRenderer& operator=(const SceneRenderer&) = delete;

  /// Clears and draws; returns when the picture is finished (glFinish), so that the call can be timed. Of polygons at the
  /// same depth the one drawn first is seen, so leaving out hidden polygons changes no pixel.
  void draw(const culler::Camera& camera, std::span<const Layer> layers, std::span<const Line> lines = {});

  /// What the last draw left.
  [[nodiscard]] Image image() const;

  /// The polygon that draw() shows at each pixel, by the same vertices and the same rasterisation, in a pass of its own: a
  /// picture costs nothing for it, and the last one stays. `offset` moves the picture by so many pixels to the right and up,
  /// so that pixels meet what lies between their centres.
  [[nodiscard]] ItemBuffer item_buffer(const culler::Camera& camera, std::span<const PolygonRange> ranges,
                                       const glm::dvec2& offset = {0, 0});

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace occlude::render
