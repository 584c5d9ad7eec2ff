// SPDX-License-Identifier: MIT
// A street between two rows of houses, things in the courts behind them, and a car that drives along behind one row. The
// example walks down the street and prints what must be drawn.
#include <occlude/culler/scene.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <utility>
#include <vector>

using namespace occlude::culler;
using occlude::kernel::Aabb;
using occlude::kernel::Obb;
using occlude::kernel::Vec3;

namespace {

/// Adds the box as six polygons. They close a convex solid, so they hide as one occluder.
void add_solid(PolygonSoup& soup, const Aabb& box) {
  std::array<std::uint32_t, 8> corner{};
  for (std::uint32_t i = 0; i < 8; ++i) {
    const auto end = [&](int axis) { return (i >> axis & 1U) != 0 ? box.max[axis] : box.min[axis]; };
    corner[i] = soup.add_vertex({end(0), end(1), end(2)});
  }
  using Face = std::array<std::size_t, 4>;
  for (const auto& [a, b, c, d] : {Face{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    soup.add_polygon(std::array{corner[a], corner[b], corner[c], corner[d]});
  }
}

/// The box of a car on the road behind the row at y = 20, turned by atan(1/4) from the direction of the road.
Obb car(double x) { return {{x, 35, 0.75}, {{{2, 0.5, 0}, {-0.25, 1, 0}, {0, 0, 0.75}}}}; }

}  // namespace

int main() {
  // Each house is an object with a box. Its walls, at least half a metre inside the box, are the occluder.
  std::vector<Box> statics;
  PolygonSoup walls;
  for (double x = 0; x < 200; x += 20) {
    for (const double y : {-20.0, 20.0}) {
      statics.emplace_back(Aabb{{x, y - 8, 0}, {x + 18, y + 8, 12}});
      add_solid(walls, {{x + 0.5, y - 7.5, 0.5}, {x + 17.5, y + 7.5, 9}});
      for (int i = 0; i < 8; ++i) {
        const double court = y < 0 ? y - 15 : y + 12;
        statics.emplace_back(Aabb{{x + 2 * i, court, 0}, {x + 2 * i + 1, court + 3, 2}});
      }
    }
  }
  const std::vector<Box> dynamics{car(0)};
  Scene scene({.statics = statics, .dynamics = dynamics}, std::move(walls));

  SceneView view;  // one for each camera; several may be culled at once, each on its own thread
  Camera camera;
  for (int frame = 0; frame < 10; ++frame) {
    scene.set_bounds(0, car(18.0 * frame));
    scene.update();
    camera.eye = {15.0 * frame - 10, 0, 2};
    camera.target = camera.eye + glm::dvec3{1, 0.5, 0};
    const SceneResult& draw = scene.cull(camera, {.occluders = 8}, view);
    const Visibility spawn = view.visibility(Aabb{{60, 40, 0}, {61, 41, 2}});  // any box, whether or not it is an object
    std::printf("frame %d: %3zu of %zu objects in %zu ranges, %3zu hidden; the car is %s, the spawn point %s\n", frame,
                draw.statics.size(), statics.size(), draw.static_ranges.size(), view.frame().stats.shadow_culled_polygons,
                draw.dynamics.empty() ? "not drawn" : "drawn",
                spawn == Visibility::visible    ? "visible"
                : spawn == Visibility::occluded ? "hidden"
                                                : "out of view");
  }
}
