// SPDX-License-Identifier: MIT
#include "item_buffers.h"

#include <fmt/format.h>

#include <array>
#include <glm/vec2.hpp>

#include "occlude/render/plate_renderer.h"

namespace occlude::cli {
namespace {

constexpr int kLargest = 8192;  // longest side of a picture, as in all commands

/// The centres of the cells of a 4 by 4 grid over a pixel. No offset reaches half a pixel, so a pixel at the border does not
/// see beyond the picture.
glm::dvec2 offset_of(std::size_t turn) {
  const std::size_t cell = turn % ItemBuffers::kOffsets;
  return {(static_cast<double>(cell % 4) - 1.5) / 4, (static_cast<double>(cell / 4) - 1.5) / 4};
}

}  // namespace

/// Every size gets every offset: after each round of offsets the sizes move on by one.
std::size_t ItemBuffers::size_of(std::size_t turn) const { return (turn + turn / kOffsets) % sizes(); }

ItemBuffers::ItemBuffers(culler::SoupView soup, int width, int height)
    : soup_(soup), context_(render::make_offscreen_context()) {
  for (const int times : {1, 2, 3}) {
    if (times > 1 && (width * times > kLargest || height * times > kLargest)) break;
    renderers_.push_back(
        {width * times, height * times, std::make_unique<render::SceneRenderer>(soup, width * times, height * times)});
  }
}

render::ItemBuffer ItemBuffers::draw(std::size_t turn, const culler::Camera& camera,
                                     std::span<const culler::PolygonRange> ranges) {
  return renderers_[size_of(turn)].renderer->item_buffer(camera, ranges, offset_of(turn));
}

std::string ItemBuffers::describe(std::size_t turn) const {
  const Sized& sized = renderers_[size_of(turn)];
  const glm::dvec2 offset = offset_of(turn);
  return fmt::format("{}x{} pixels, moved by {:g}, {:g}", sized.width, sized.height, offset.x, offset.y);
}

render::Image ItemBuffers::picture(const culler::Camera& camera, const std::vector<culler::PolygonRange>& marked) {
  constexpr render::Rgba kMagenta{200, 0, 170, 255};
  std::vector<render::Line> outlines;  // lines stay visible where polygons are far and small
  for (const culler::PolygonRange& range : marked) {
    for (std::uint32_t p = range.first; p < range.first + range.count; ++p) {
      const auto loop = soup_.loop(p);
      for (std::size_t i = 0; i < loop.size(); ++i) {
        outlines.push_back({soup_.vertices[loop[i]], soup_.vertices[loop[(i + 1) % loop.size()]], kMagenta});
      }
    }
  }
  const culler::PolygonRange all = soup_.all();
  const std::array<render::PlateLayer, 2> layers{render::PlateLayer{marked, render::Style::marked},
                                                 render::PlateLayer{std::span(&all, 1), render::Style::plain}};
  return render::PlateRenderer(soup_, *renderers_[0].renderer).draw(camera, layers, {.lines = outlines});
}

}  // namespace occlude::cli
