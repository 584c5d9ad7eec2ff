// SPDX-License-Identifier: MIT
// Draws plates of frames.
#pragma once

#include <optional>
#include <span>

#include "occlude/culler/culler.h"
#include "occlude/render/plate_renderer.h"
#include "occlude/render/scene_renderer.h"

namespace occlude::render {

class FramePainter {
 public:
  /// The culler must outlive this object. Throws as SceneRenderer. REQUIRES: an OffscreenContext current on this thread, for
  /// the lifetime of the object.
  FramePainter(const culler::Culler& culler, int width, int height)
      : culler_(culler), scene_(culler.hierarchy().soup(), width, height), plates_(culler.hierarchy().soup(), scene_) {}

  /// These polygons of the tree in the colours of their surfaces, as the camera sees them, but `marked` in magenta.
  [[nodiscard]] Image view(const culler::Camera& camera, std::span<const PolygonRange> ranges,
                           const std::optional<PolygonRange>& marked = std::nullopt, std::span<const Line> lines = {});

  /// The whole model in these colours, as the camera sees it.
  [[nodiscard]] Image whole(const culler::Camera& camera);

  /// All polygons, by what became of them, from above and behind the camera, cut open above it if it is inside of something,
  /// with the edges of the view frustum and of the shadows.
  [[nodiscard]] Image outside(const culler::Camera& camera, const culler::CullResult& result,
                              const std::optional<PolygonRange>& marked = std::nullopt, std::span<const Line> lines = {});

  /// All polygons, by what became of them, as the camera sees them.
  [[nodiscard]] Image fates(const culler::Camera& camera, const culler::CullResult& result);

  /// The polygons of one style of FrameLayers alone, as the camera sees them. REQUIRES: a style of FrameLayers::all().
  [[nodiscard]] Image layer(Style style, const culler::Camera& camera, const culler::CullResult& result);

 private:
  const culler::Culler& culler_;
  SceneRenderer scene_;
  PlateRenderer plates_;
};

}  // namespace occlude::render
