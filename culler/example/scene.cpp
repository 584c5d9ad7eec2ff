// SPDX-License-Identifier: MIT
// A street between two rows of houses, things in the courts behind them, and a bus that drives along behind one row. The
// example walks down the street and prints what must be drawn.
#include <occlude/culler/scene.h>

#include <cstdio>
#include <memory>
#include <utility>

using namespace occlude::culler;
using occlude::kernel::Aabb;

namespace {

/// A box as six polygons.
std::shared_ptr<const OccluderMesh> solid(const glm::dvec3& low, const glm::dvec3& high) {
  PolygonSoup soup;
  soup.add_box(low, high);
  return std::make_shared<OccluderMesh>(std::move(soup));
}

}  // namespace

int main() {
  Scene scene;
  // Each house is an object with a box. Its walls, half a metre inside the box, are an occluder; all houses share one mesh.
  const auto walls = solid({0.5, 0.5, 0.5}, {17.5, 15.5, 9});
  for (double x = 0; x < 200; x += 20) {
    for (const double y : {-20.0, 20.0}) {
      const ObjectId house = scene.add(Aabb{{x, y - 8, 0}, {x + 18, y + 8, 12}});
      scene.add(walls, {.origin = {x, y - 8, 0}}, {.object = house});
      for (int i = 0; i < 8; ++i) {
        const double court = y < 0 ? y - 15 : y + 12;
        scene.add(Aabb{{x + 2 * i, court, 0}, {x + 2 * i + 1, court + 3, 2}});
      }
    }
  }
  // The bus moves, and hides what is behind it.
  const ObjectId bus = scene.add(Aabb{}, {.moves = true});
  const OccluderId body = scene.add(solid({0, 0, 0.3}, {12, 2.5, 3}), {}, {.moves = true, .object = bus});

  SceneView view;  // one for each camera; several may be culled at once, each on its own thread
  Camera camera;
  for (int frame = 0; frame < 10; ++frame) {
    const double x = 18.0 * frame;
    scene.move(bus, Aabb{{x, 34, 0}, {x + 12, 36.5, 3}});
    scene.move(body, {.origin = {x, 34, 0}});
    scene.update();
    camera.eye = {15.0 * frame - 10, 0, 2};
    camera.target = camera.eye + glm::dvec3{1, 0.5, 0};
    const SceneResult& result = scene.cull(camera, {.is_front_to_back = true}, view);
    bool is_bus_drawn = false;
    for (const DrawnObject& object : result.drawn) is_bus_drawn = is_bus_drawn || object.id == bus;
    const Visibility spawn = view.visibility(Aabb{{60, 40, 0}, {61, 41, 2}});  // any box, whether or not it is an object
    std::printf("frame %d: %3zu of %zu objects, %3zu hidden; the bus is %s, the spawn point %s\n", frame, result.stats.drawn,
                scene.objects(), result.stats.hidden, is_bus_drawn ? "drawn" : "not drawn",
                spawn == Visibility::visible    ? "visible"
                : spawn == Visibility::occluded ? "hidden"
                                                : "out of view");
  }
}
