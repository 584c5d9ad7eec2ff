// SPDX-License-Identifier: MIT
#include "marked_picture.h"

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <span>
#include <utility>

#include "occlude/render/plate_renderer.h"

namespace occlude::cli {
namespace {

constexpr render::Rgba kMagenta{200, 0, 170, 255};

void add_ring(render::Image& picture, const glm::dvec2& around, double radius, double width) {
  const auto range = [&](double middle, int side) {
    const auto clamped = [&](double at) { return static_cast<int>(std::clamp(at, 0.0, static_cast<double>(side))); };
    return std::pair{clamped(middle - radius), clamped(middle + radius + 1)};
  };
  const auto [left, right] = range(around.x, picture.width);
  const auto [top, bottom] = range(around.y, picture.height);
  for (int y = top; y < bottom; ++y) {
    for (int x = left; x < right; ++x) {
      const double distance = glm::distance(around, glm::dvec2(x + 0.5, y + 0.5));
      if (distance <= radius && distance > radius - width) picture.at(x, y) = kMagenta;
    }
  }
}

}  // namespace

render::Image marked_picture(const culler::SoupView& soup, render::SceneRenderer& renderer, const culler::Camera& camera,
                             const std::vector<culler::PolygonRange>& marked) {
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

void add_rings(render::Image& picture, std::span<const glm::dvec2> around) {
  const double radius = std::max(picture.height / 40.0, 4.0), width = radius / 6;
  std::vector<glm::dvec2> ringed;
  for (const glm::dvec2& place : around) {
    if (std::ranges::any_of(ringed, [&](const glm::dvec2& r) { return glm::distance(r, place) < 2 * radius; })) continue;
    add_ring(picture, place, radius, width);
    ringed.push_back(place);
  }
}

}  // namespace occlude::cli
