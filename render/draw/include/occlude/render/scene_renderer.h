// SPDX-License-Identifier: MIT
// Draws ranges of a polygon soup off screen, to be timed and compared: pictures and item buffers.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "occlude/culler/camera.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/render/image.h"

namespace occlude::render {

using culler::PolygonRange;

/// What is higher along `up`, a unit vector, is left out.
struct Cut {
  glm::dvec3 up{0, 0, 1};
  double height = 0;
};

class SceneRenderer {
 public:
  /// Uploads the polygons in their order; an item buffer holds their indices. Coordinates are recentred before they are
  /// converted to float. Throws std::runtime_error if the picture or the model is larger than OpenGL allows.
  /// REQUIRES: an OffscreenContext current on this thread, for the lifetime of the object.
  SceneRenderer(culler::SoupView soup, int width, int height);
  ~SceneRenderer();
  SceneRenderer(const SceneRenderer&) = delete;
  SceneRenderer& operator=(const SceneRenderer&) = delete;

  [[nodiscard]] int width() const;
  [[nodiscard]] int height() const;
  /// The depth at which a surface has half the colour of the sky: half the diagonal of the box around the vertices. Infinity
  /// in a parallel projection, which has no distance from the eye.
  [[nodiscard]] double haze_depth(const culler::Camera& camera) const;

  /// Clears and draws, each polygon in a colour of its own. Returns when the picture is finished (glFinish), so that callers
  /// can time it. See-through polygons are drawn over the opaque ones, as tinted glass. Of polygons at equal depth the first
  /// one drawn is visible, so leaving out hidden polygons changes no pixel.
  void draw(const culler::Camera& camera, std::span<const PolygonRange> ranges);

  /// The picture of the last draw().
  [[nodiscard]] Image image() const;

  /// The polygons that draw() shows at each pixel, from the same vertices and rasterisation, in a separate pass: it does not
  /// slow draw() down and keeps the last picture. `offset` moves the picture right and up, in pixels, to sample points
  /// between the pixel centres. `cut` opens the model: then it is no longer what draw() shows.
  [[nodiscard]] ItemBuffer item_buffer(const culler::Camera& camera, std::span<const PolygonRange> ranges,
                                       const glm::dvec2& offset = {0, 0}, const std::optional<Cut>& cut = {});

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace occlude::render
