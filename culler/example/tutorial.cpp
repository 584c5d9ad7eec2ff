// SPDX-License-Identifier: MIT
// The program of docs/tutorial.md: a town of blocks and a camera that walks down a street. It prints how much of the town
// must be drawn, what hides the rest, and when a bus behind the houses is seen.
#include <occlude/culler/culler.h>
#include <occlude/culler/scene.h>

#include <array>
#include <cstddef>
#include <cstdio>
#include <memory>
#include <vector>

using namespace occlude::culler;
using occlude::kernel::Aabb;

namespace {

/// Blocks of 16 by 16 metres, 4 metres apart, of heights between 6 and 18.
std::vector<Aabb> make_town() {
  std::vector<Aabb> town;
  for (int row = 0; row < 20; ++row) {
    for (int column = 0; column < 20; ++column) {
      const double x = 20 * column, y = 20 * row, height = 6 + (7 * row + 5 * column) % 13;
      town.push_back({{x, y, 0}, {x + 16, y + 16, height}});
    }
  }
  return town;
}

PolygonSoup make_model(const std::vector<Aabb>& town) {
  PolygonSoup model;
  for (const auto& [low, high] : town) model.add_box({low.x, low.y, low.z}, {high.x, high.y, high.z});
  return model;
}

/// Pictures are 1080 pixels high. Shadows are taken 1/128 pixel smaller, so that no rounding of the renderer shows.
constexpr double kMargin = margin_for(1080);

void cull_model(const PolygonSoup& model) {
  // Once, when the model is loaded.
  const Culler culler(model);
  culler.prepare();  // otherwise the first frame does

  // Once for each camera.
  View view;
  Camera camera;
  CullOptions options;
  options.margin = kMargin;

  for (int frame = 0; frame < 5; ++frame) {
    camera.eye = {20 * frame - 10, 18, 1.7};
    camera.target = camera.eye + glm::dvec3{1, 0.2, 0};
    const CullResult& result = culler.cull(camera, options, view);
    // Draw result.drawn: ranges of the polygons in the order of culler.hierarchy().soup().
    std::printf("frame %d: %3zu of %zu polygons drawn, %4zu hidden, %4zu out of view\n", frame, result.stats.drawn_polygons,
                model.size(), result.stats.shadow_culled_polygons, result.stats.view_culled_polygons);
  }

  std::vector<CoverWitness> proofs;
  culler.append_covers(view.result(), camera, options, 1000, proofs);
  std::printf("%zu proofs; in the first, %u polygons are hidden by %zu others\n", proofs.size(), proofs.front().range.count,
              proofs.front().polygons.size());
}

void cull_scene(const std::vector<Aabb>& town) {
  Scene scene;
  scene.add(std::make_shared<OccluderMesh>(make_model(town)));  // what hides
  for (const Aabb& block : town) scene.add(block);              // what is drawn
  const ObjectId bus = scene.add(Aabb{}, {.moves = true});

  SceneView view;
  Camera camera;
  camera.eye = {-10, 18, 1.7};
  camera.target = {0, 18.5, 1.7};
  const SceneOptions options{.margin = kMargin};
  for (int frame = 0; frame < 4; ++frame) {
    const double y = 54 - 12 * frame;
    scene.move(bus, Aabb{{36.5, y, 0}, {39.5, y + 10, 3}});
    scene.update();
    const SceneResult& result = scene.cull(camera, options, view);
    // Draw the objects of result.drawn.
    const std::vector<ObjectFate> fates = scene.why(camera, options, view, std::array{bus});
    std::printf("frame %d: %2zu of %zu objects drawn; ", frame, result.drawn.size(), scene.objects());
    if (fates[0].reason == ObjectFate::Reason::hidden) {
      std::printf("%zu polygons hide the bus\n", fates[0].by.size());
    } else {
      std::printf("the bus is drawn\n");
    }
  }
}

}  // namespace

int main() {
  const std::vector<Aabb> town = make_town();
  cull_model(make_model(town));
  cull_scene(town);
}
