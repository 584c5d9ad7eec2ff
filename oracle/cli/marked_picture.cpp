// SPDX-License-Identifier: MIT
#include "marked_picture.h"

#include <array>
#include <span>

#include "occlude/render/plate_renderer.h"

namespace occlude::cli {

render::Image marked_picture(const culler::SoupView& soup, render::SceneRenderer& renderer, const culler::Camera& camera,
                             const std::vector<culler::PolygonRange>& marked) {
  constexpr render::Rgba kMagenta{200, 0, 170, 255};
  std::vector<render::Line> outlines;  // lines stay visible where polygons are far and small
  for (const culler::PolygonRange& range : marked) {
    for (std::uint32_t p = range.first; p < range.first + range.count; ++p) {
      const auto loop = soup.loop(p);
      for (std::size_t i = 0; i < loop.size(); ++i) {
        outlines.push_back({soup.vertices[loop[i]], soup.vertices[loop[(i + 1) % loop.size()]], kMagenta});
      }
    }
  }
  const culler::PolygonRange all = soup.all();
  const std::array<render::PlateLayer, 2> layers{render::PlateLayer{marked, render::Style::marked},
                                                 render::PlateLayer{std::span(&all, 1), render::Style::plain}};
  return render::PlateRenderer(soup, renderer).draw(camera, layers, {.lines = outlines});
}

}  // namespace occlude::cli
