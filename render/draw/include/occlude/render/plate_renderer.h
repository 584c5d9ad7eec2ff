// SPDX-License-Identifier: MIT
// Pictures to look at: with sun, shadows, edges and antialiasing, and with patterns that tell what a culler did.
#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "occlude/culler/camera.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/render/image.h"
#include "occlude/render/scene_renderer.h"

namespace occlude::render {

/// How polygons look. All differ in lightness or pattern, so that they can be told apart without colour.
enum class Style : std::uint8_t {
  plain,        ///< in the colours of their surfaces
  drawn,        ///< pale and nearly grey
  culled,       ///< dark red, hatched
  out_of_view,  ///< nearly white
  occluder,     ///< yellow, dotted
  missed,       ///< blue, hatched the other way
  marked        ///< magenta
};

/// Polygons in one style.
struct PlateLayer {
  std::span<const culler::PolygonRange> ranges;
  Style style = Style::plain;
};

/// A straight line in model space, drawn over the picture; its hidden parts are faint.
struct Line {
  glm::dvec3 from{0, 0, 0}, to{0, 0, 0};
  Rgba colour;
};

/// What stands in a corner of the picture.
struct LegendEntry {
  Style style;
  std::string text;
};

/// What a plate has besides polygons.
struct PlateExtras {
  std::span<const Line> lines = {};
  std::span<const LegendEntry> legend = {};
  /// The polygons that keep the sun out, if not those of the layers.
  std::optional<culler::PolygonRange> casters = {};
  /// The model is cut open, for the sun as well.
  std::optional<Cut> cut = {};
};

class PlateRenderer {
 public:
  /// `renderer` holds the polygons of the soup; its size is that of the pictures. Both must outlive this object.
  PlateRenderer(culler::SoupView soup, SceneRenderer& renderer);
  ~PlateRenderer();
  PlateRenderer(const PlateRenderer&) = delete;
  PlateRenderer& operator=(const PlateRenderer&) = delete;

  /// Of polygons at equal depth, those of the first layer are visible. The same arguments give the same picture.
  [[nodiscard]] Image draw(const culler::Camera& camera, std::span<const PlateLayer> layers, const PlateExtras& extras = {});

  /// For each polygon of the soup, whether a plate of these ranges shows it.
  [[nodiscard]] std::vector<bool> seen(const culler::Camera& camera, std::span<const culler::PolygonRange> ranges);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace occlude::render
