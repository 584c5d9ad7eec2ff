// SPDX-License-Identifier: MIT
#include "occlude/render/frame_painter.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <vector>

#include "occlude/render/frame_layers.h"
#include "outside_view.h"

namespace occlude::render {

Image FramePainter::view(const culler::Camera& camera, std::span<const PolygonRange> ranges,
                         const std::optional<PolygonRange>& marked, std::span<const Line> lines) {
  std::vector<PlateLayer> layers;
  if (marked) layers.push_back({std::span(&*marked, 1), Style::marked});
  layers.push_back({ranges, Style::plain});
  return plates_.draw(camera, layers,
                      {.lines = lines, .casters = culler_.hierarchy().soup().all()});  // what is culled casts shadows
}

Image FramePainter::whole(const culler::Camera& camera) {
  const PolygonRange all = culler_.hierarchy().soup().all();
  return view(camera, std::span(&all, 1));
}

Image FramePainter::outside(const culler::Camera& camera, const culler::CullResult& result,
                            const std::optional<PolygonRange>& marked, std::span<const Line> lines) {
  const culler::SoupView soup = culler_.hierarchy().soup();
  const FrameLayers layers = layers_of(culler_, camera, result, plates_);
  const std::vector<LegendEntry> legend = layers.legend();
  double depth = depth_of_scene(culler_, camera, result.drawn);
  if (marked) depth = std::max(depth, glm::distance(soup.vertices[soup.loop(marked->first)[0]], camera.eye));
  const culler::Camera above = outside_camera(camera, depth);
  std::vector<PlateLayer> shown = layers.all();
  if (marked) shown.insert(shown.begin(), {std::span(&*marked, 1), Style::marked});
  std::vector<Line> drawn(lines.begin(), lines.end());
  add_frustum(drawn, camera, depth);
  for (const culler::Occluder& occluder : result.occluders) add_shadow(drawn, occluder, camera, depth);
  return plates_.draw(above, shown, {.lines = drawn, .legend = legend, .cut = cut_between(camera, above, scene_, soup)});
}

Image FramePainter::fates(const culler::Camera& camera, const culler::CullResult& result) {
  const FrameLayers layers = layers_of(culler_, camera, result, plates_);
  const std::vector<LegendEntry> legend = layers.legend();
  return plates_.draw(camera, layers.all(), {.legend = legend});
}

Image FramePainter::layer(Style style, const culler::Camera& camera, const culler::CullResult& result) {
  const FrameLayers layers = layers_of(culler_, camera, result, plates_);
  const std::vector<PlateLayer> all = layers.all();
  const auto layer = std::ranges::find(all, style, &PlateLayer::style);
  const std::vector<LegendEntry> legend = layers.legend();
  return plates_.draw(camera, std::span(&*layer, 1), {.legend = legend});
}

}  // namespace occlude::render
