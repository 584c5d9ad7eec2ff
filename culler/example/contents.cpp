// SPDX-License-Identifier: MIT
// The kinds of things that docs/contents.md is about, each as it is fed to a scene: a hedge and a window, instances, a door,
// a figure that walks, a tile of terrain, levels of detail, a mirror and a lamp. The example prints what a garden behind a
// wall takes of each frame.
#include <occlude/culler/scene.h>

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <utility>
#include <vector>

using namespace occlude::culler;
using occlude::kernel::Aabb;

namespace {

constexpr std::uint32_t kWorld = 1, kPlayer = 2;  // layers

/// A rectangle that stands on the x axis.
void add_rectangle(PolygonSoup& soup, double x, double width, double height) {
  const std::array loop{soup.add_vertex({x, 0, 0}), soup.add_vertex({x + width, 0, 0}),
                        soup.add_vertex({x + width, 0, height}), soup.add_vertex({x, 0, height})};
  soup.add_polygon(loop);
}

std::shared_ptr<const OccluderMesh> rectangle(double width, double height) {
  PolygonSoup soup;
  add_rectangle(soup, 0, width, height);
  return std::make_shared<OccluderMesh>(std::move(soup));
}

/// A trunk, and leaves as squares with a picture of leaves on them.
std::shared_ptr<const OccluderMesh> make_tree() {
  PolygonSoup tree;
  tree.add_box({-0.2, -0.2, 0}, {0.2, 0.2, 3});
  const std::size_t leaves = tree.size();
  for (int i = 0; i < 10; ++i) add_rectangle(tree, 0.3 * i - 1.5, 0.3, 4);
  tree.see_through_from(leaves);
  return std::make_shared<OccluderMesh>(std::move(tree));
}

/// A tile of terrain, 64 by 64 metres, as the triangles that are drawn.
std::shared_ptr<const OccluderMesh> make_terrain() {
  constexpr std::uint32_t kSide = 17;
  PolygonSoup soup;
  for (std::uint32_t y = 0; y < kSide; ++y) {
    for (std::uint32_t x = 0; x < kSide; ++x)
      soup.add_vertex({4.0 * x, 4.0 * y, -1 + std::sin(0.4 * x) * std::cos(0.3 * y)});
  }
  for (std::uint32_t y = 0; y + 1 < kSide; ++y) {
    for (std::uint32_t x = 0; x + 1 < kSide; ++x) {
      const std::uint32_t corner = y * kSide + x;
      soup.add_polygon(std::array{corner, corner + 1, corner + kSide + 1});
      soup.add_polygon(std::array{corner, corner + kSide + 1, corner + kSide});
    }
  }
  return std::make_shared<OccluderMesh>(std::move(soup));
}

/// What comes and goes together.
struct Tile {
  std::vector<ObjectId> objects;
  OccluderId ground;
};

Tile load_tile(Scene& scene, const glm::dvec3& origin) {
  auto ground = make_terrain();  // on any thread, while the scene is culled
  std::vector<Aabb> boxes;
  for (int i = 0; i < 64; ++i) {
    const double x = origin.x + 8 * (i % 8), y = origin.y + 8.0 * (i / 8);
    boxes.push_back({{x, y, 0}, {x + 1, y + 1, 1}});
  }
  Tile tile;
  tile.objects.resize(boxes.size());
  const std::vector<Box> plants(boxes.begin(), boxes.end());
  scene.add(plants, {}, tile.objects);
  tile.ground = scene.add(std::move(ground), {.origin = {origin.x, origin.y, origin.z}});
  return tile;
}

void unload_tile(Scene& scene, const Tile& tile) {
  for (const ObjectId object : tile.objects) scene.remove(object);
  scene.remove(tile.ground);
}

int level_of_detail(const DrawnObject& object) { return object.size > 0.2F ? 0 : object.size > 0.05F ? 1 : 2; }

}  // namespace

int main() {
  Scene scene;
  SceneView view, mirror_view, lamp_view;
  Camera camera;
  camera.eye = {0, -10, 1.7};
  camera.target = {0, 0, 1.7};
  const auto print = [&](const char* what) {
    scene.update();
    const SceneResult& result = scene.cull(camera, {}, view);
    std::printf("%-22s %3zu of %3zu objects drawn\n", what, result.drawn.size(), scene.objects());
  };

  const Tile garden = load_tile(scene, {-32, 1, 0});
  print("a garden:");

  // Instances: one mesh, placed many times. Panels overlap, so that no seam stays open between them.
  const auto panel = rectangle(4.2, 3);
  for (int i = -10; i < 10; ++i) {
    if (i != 0) scene.add(panel, {.origin = {4.0 * i, 0, 0}});
  }
  print("behind a wall:");

  // A door: what hides is tied to the object that draws it.
  const ObjectId door = scene.add(Aabb{{-0.2, -0.1, 0}, {4.2, 0.1, 3}});
  const OccluderId leaf = scene.add(rectangle(4.4, 3), {.origin = {-0.2, 0, 0}}, {.object = door});
  print("with a door:");
  // It opens by a quarter of a turn.
  scene.move(door, Aabb{{-0.3, 0, 0}, {-0.1, 4.4, 3}});
  scene.move(leaf, {.x = {0, 1, 0}, .y = {-1, 0, 0}, .origin = {-0.2, 0, 0}});
  print("that is open:");

  // A tree in the doorway: its trunk hides, its leaves do not.
  const ObjectId tree = scene.add(Aabb{{0.5, -1.2, 0}, {3.5, -0.8, 4}});
  scene.add(make_tree(), {.origin = {2, -1, 0}}, {.object = tree});
  print("with a tree in it:");

  // A figure that walks: a box for each pose, or one that holds them all. It hides nothing.
  const ObjectId figure = scene.add(Aabb{}, {.moves = true, .mask = kPlayer});
  scene.move(figure, Aabb{{-0.5, -6.5, 0}, {0.5, -5.5, 2}});
  print("and somebody before it:");

  // Levels of detail, from the sizes in the picture.
  std::array<int, 3> levels{};
  for (const DrawnObject& object : view.result().drawn) ++levels[static_cast<std::size_t>(level_of_detail(object))];
  std::printf("levels of detail: %d near, %d middle, %d far\n", levels[0], levels[1], levels[2]);

  // A mirror in the plane y = 0, without the player: the camera on its other side, with the picture turned over. The near
  // plane is the mirror, so that nothing behind it hides.
  const std::array<float, 16> reflected{1, 0, 0, 0, 0, 0, -1, -1, 0, 1, 0, 0, 0, -1.7F, -10, 10};
  const MatrixCamera mirror = MatrixCamera::from_columns(reflected.data(), ClipDepth::minus_w_to_w);
  const SceneResult& seen = scene.cull(mirror, {.mask = kWorld}, mirror_view);
  std::printf("objects in the mirror: %zu\n", seen.stats.drawn);

  // A lamp: its shadow map is the picture of a camera with parallel rays.
  const std::array<float, 16> shines{1.0F / 64, 0, 0, 0, 0, 1.0F / 64, 0, 0, 0, 0, -1.0F / 50, 0, 0, 0, 0.5F, 1};
  const MatrixCamera lamp = MatrixCamera::from_columns(shines.data(), ClipDepth::zero_to_w, Nearer::less);
  const SceneResult& lit = scene.cull(lamp, {.mask = kWorld}, lamp_view);
  std::printf("objects in the shadow map: %zu\n", lit.stats.drawn);

  unload_tile(scene, garden);
  print("without the garden:");
}
