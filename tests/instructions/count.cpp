// SPDX-License-Identifier: MIT
// Small fixed work of each kind, for callgrind to count its instructions. Prints nothing. Exit code 77 where this machine
// has not the instruction set that the numbers are of.
#include <valgrind/callgrind.h>

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <random>
#include <span>
#include <utility>
#include <vector>

#include "occlude/culler/culler.h"
#include "occlude/culler/inner_boxes.h"
#include "occlude/culler/scene.h"
#include "occlude/kernel/overlap.h"
#include "only_target.h"

namespace {

using namespace occlude;
using kernel::Aabb;

constexpr std::uint32_t kSeed = 7;

/// All work on this thread, the only one whose instructions are counted.
const culler::Checkpoint kAlone{culler::Executor()};

/// Counts the instructions of work() under this name.
template <class Work>
void count(const char* name, const Work& work) {
  CALLGRIND_ZERO_STATS;
  CALLGRIND_TOGGLE_COLLECT;
  work();
  CALLGRIND_TOGGLE_COLLECT;
  CALLGRIND_DUMP_STATS_AT(name);
}

int whole(std::mt19937& random, int low, int high) {
  return low + static_cast<int>(random() % static_cast<std::uint32_t>(high - low + 1));
}
double real(std::mt19937& random, double low, double high) {
  return low + (high - low) * (static_cast<double>(random()) * 0x1p-32);
}

kernel::Vec3 wall_corner(int x, int z) { return {static_cast<double>(x), 10, static_cast<double>(z)}; }

std::vector<kernel::ShadowFrustum> walls(std::mt19937& random, std::size_t number) {
  std::vector<kernel::ShadowFrustum> frusta;
  while (frusta.size() < number) {
    const int x = whole(random, -20, 10), z = whole(random, -10, 5), width = whole(random, 2, 10),
              height = whole(random, 2, 5);
    const std::array loop{wall_corner(x, z), wall_corner(x + width, z), wall_corner(x + width, z + height),
                          wall_corner(x, z + height)};
    auto made = kernel::ShadowFrustum::make(kernel::Viewpoint::eye({0, 0, 0}), loop, kernel::Near::surface);
    if (made.frustum) frusta.push_back(std::move(*made.frustum));
  }
  return frusta;
}

void count_kernel() {
  std::mt19937 random(kSeed);
  std::vector<kernel::ShadowFrustum> frusta;
  count("kernel.frusta", [&] { frusta = walls(random, 500); });
  std::vector<Aabb> apart, touching;
  for (int i = 0; i < 2000; ++i) {
    const double x = real(random, -60, 40), y = real(random, 5, 40), z = real(random, -30, 15);
    apart.push_back({{x, y, z}, {x + 2.3, y + 1.1, z + 1.7}});
    // On rays through corners of walls: many touch a side exactly.
    const int far = whole(random, 1, 3), at_x = far * whole(random, -20, 20), at_z = far * whole(random, -10, 10);
    const auto corner = [&](int dx, int dz, double dy) {
      return kernel::Vec3{static_cast<double>(at_x + dx), 10.0 * far + dy, static_cast<double>(at_z + dz)};
    };
    touching.push_back({corner(0, 0, 0), corner(far, far, 5)});
  }
  std::size_t inside = 0;
  const auto ask = [&](const std::vector<Aabb>& boxes) {
    for (std::size_t i = 0; i < boxes.size(); ++i) {
      for (std::size_t f = 0; f < 10; ++f) {
        const auto found = kernel::overlap_certified(frusta[(i + 37 * f) % frusta.size()], boxes[i]);
        inside += found.relation == kernel::Relation::inside ? 1 : 0;
      }
    }
  };
  count("kernel.overlap_random", [&] { ask(apart); });
  count("kernel.overlap_touching", [&] { ask(touching); });
}

/// A building for each place of a grid, on a ground.
culler::PolygonSoup town(std::mt19937& random, int side) {
  culler::PolygonSoup soup;
  soup.add_box({0, 0, -1}, {20.0 * side, 20.0 * side, 0});
  for (int i = 0; i < side * side; ++i) {
    const double x = 20.0 * (i % side) + 4, y = 20.0 * (i / side) + 4;
    soup.add_box({x, y, 0}, {x + real(random, 8, 14), y + real(random, 8, 14), real(random, 5, 30)});
    soup.add_box({x + 3, y - 3, 0}, {x + 3.5, y - 2.5, 2});
  }
  return soup;
}

culler::Camera camera_at(int side, int frame) {
  culler::Camera camera;
  camera.eye = {10.0 * side + frame, 10.0 * side + 2, 1.7};
  camera.target = camera.eye + glm::dvec3{1, 0.3 * (frame % 7) - 1, 0.02};
  return camera;
}

void count_model() {
  constexpr int kSide = 30;
  std::mt19937 random(kSeed);
  const culler::PolygonSoup soup = town(random, kSide);
  std::unique_ptr<culler::Culler> culler;
  culler::BuildConfig config;
  config.lists.regions = 1000;
  count("model.build", [&] { culler = std::make_unique<culler::Culler>(soup, config, kAlone); });
  count("model.prepare_frusta", [&] { culler->prepare(culler::Method::frusta, kAlone); });
  count("model.prepare_cover", [&] { culler->prepare(culler::Method::cover, kAlone); });
  for (const auto& [name, method] : {std::pair("model.cull_by_frusta", culler::Method::frusta),
                                     std::pair("model.cull_by_cover", culler::Method::cover)}) {
    culler::CullOptions options;
    options.method = method;
    options.cover.ms = std::numeric_limits<double>::infinity();  // the work, whatever time it takes
    culler::View view;
    culler->cull(camera_at(kSide, 0), options, view);
    count(name, [&] {
      for (int frame = 1; frame <= 20; ++frame) culler->cull(camera_at(kSide, frame), options, view);
    });
  }
}

void count_inner_boxes() {
  std::mt19937 random(kSeed);
  const culler::PolygonSoup soup = town(random, 8);
  count("model.inner_boxes", [&] { static_cast<void>(culler::find_inner_boxes(soup, {}, {}, kAlone)); });
}

void count_scene() {
  constexpr int kSide = 30;
  std::mt19937 random(kSeed);
  culler::Scene scene;
  culler::SceneView view;
  const auto mesh = std::make_shared<culler::OccluderMesh>(town(random, kSide), kAlone);
  std::vector<culler::Box> boxes;
  for (int i = 0; i < 20000; ++i) {
    const double x = real(random, 0, 20 * kSide), y = real(random, 0, 20 * kSide), z = real(random, 0, 5);
    boxes.emplace_back(Aabb{{x, y, z}, {x + 1, y + 1, z + 1}});
  }
  std::vector<culler::ObjectId> ids(boxes.size()), cars;
  count("scene.build", [&] {
    scene.add(boxes, {}, ids);
    scene.add(mesh);
    scene.update();
  });
  for (int i = 0; i < 500; ++i) cars.push_back(scene.add(boxes[static_cast<std::size_t>(i)], {.moves = true}));
  scene.update();
  const std::span<const culler::Box> tile = std::span(boxes).first(1000);
  std::vector<culler::ObjectId> visitors(tile.size());
  count("scene.update", [&] {
    for (std::size_t frame = 0; frame < 10; ++frame) {
      for (std::size_t i = 0; i < cars.size(); ++i) scene.move(cars[i], boxes[i + frame]);
      scene.add(tile, {}, visitors);
      scene.update();
      for (const culler::ObjectId id : visitors) scene.remove(id);
    }
  });
  scene.update();
  const culler::SceneOptions options{.cover = {.ms = std::numeric_limits<double>::infinity()}};
  scene.cull(camera_at(kSide, 0), options, view);
  count("scene.cull", [&] {
    for (int frame = 1; frame <= 20; ++frame) scene.cull(camera_at(kSide, frame), options, view);
  });
}

}  // namespace

int main() {
  if ((hwy::SupportedTargets() & HWY_AVX2) == 0) return 77;
  const OnlyTarget avx2(HWY_AVX2);
  count_kernel();
  count_model();
  count_inner_boxes();
  count_scene();
  return 0;
}
