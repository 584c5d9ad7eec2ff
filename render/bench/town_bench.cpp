// SPDX-License-Identifier: MIT
#include "town_bench.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "occlude/render/progress.h"
#include "peak_memory.h"

namespace occlude::experiments {
namespace {

using culler::ObjectId;

// Metres. All are whole numbers, so that rectangles of neighbours share an edge exactly.
constexpr double kWidth = 12, kDepth = 12, kStreet = 18, kRow = kDepth + kStreet;
constexpr double kWall = 6;  // height of the rectangles that hide, below the eaves of every house
constexpr double kEye = 1.7;

/// Where a house stands: the terraces are as long as the town is wide.
struct Place {
  double west, south;
};

class Town {
 public:
  explicit Town(const TownBenchOptions& options)
      : options_(options),
        columns_(static_cast<std::size_t>(
            std::ceil(std::sqrt(static_cast<double>(std::max<std::size_t>(options.houses, 1)) * kRow / kWidth)))) {
    for (std::size_t i = 0; i < options.houses; ++i) {
      const auto [west, south] = place(i);
      houses_.emplace_back(
          kernel::Aabb{{west, south, 0}, {west + kWidth, south + kDepth, kWall + 2 + static_cast<double>(i % 3)}});
    }
  }

  /// What an engine does to load it.
  [[nodiscard]] culler::Scene made(std::vector<ObjectId>& cars) const {
    culler::Scene scene;
    std::vector<ObjectId> houses(houses_.size());
    scene.add(houses_, {}, houses);
    cars.clear();
    for (std::size_t i = 0; i < options_.cars; ++i) cars.push_back(scene.add(car(i, 0), {.moves = true}));
    scene.add(std::make_shared<culler::OccluderMesh>(walls()));
    scene.update();
    return scene;
  }

  void drive(culler::Scene& scene, const std::vector<ObjectId>& cars, std::size_t frame) const {
    for (std::size_t i = 0; i < cars.size(); ++i) scene.move(cars[i], car(i, frame));
  }

  /// Walks along five streets, one after another, and turns around its own axis all the time.
  [[nodiscard]] culler::Camera camera(std::size_t frame) const {
    constexpr std::size_t kStreets = 5;
    const std::size_t of_street = std::max<std::size_t>(options_.frames / kStreets, 1), street = frame / of_street;
    const double rows = static_cast<double>(houses_.size() / columns_), turn = 0.1 * static_cast<double>(frame);
    culler::Camera camera;
    camera.eye = {width() / 4 + 1.4 * static_cast<double>(frame % of_street),
                  kRow * std::floor(rows * static_cast<double>(street + 1) / (kStreets + 2)) + kDepth + kStreet / 2, kEye};
    camera.target = camera.eye + glm::dvec3{std::cos(turn), std::sin(turn), 0};
    return camera;
  }

 private:
  [[nodiscard]] Place place(std::size_t house) const {
    return {kWidth * static_cast<double>(house % columns_), kRow * static_cast<double>(house / columns_)};
  }
  [[nodiscard]] double width() const { return kWidth * static_cast<double>(columns_); }

  [[nodiscard]] culler::Box car(std::size_t i, std::size_t frame) const {
    const std::size_t rows = std::max<std::size_t>(houses_.size() / columns_, 1);
    const double start = width() * static_cast<double>(i) / static_cast<double>(options_.cars);
    const double west = std::fmod(start + 0.25 * static_cast<double>(frame), width());
    const double south = kRow * static_cast<double>(i * 7 % rows) + kDepth + 5;
    return kernel::Aabb{{west, south, 0}, {west + 4, south + 1.75, 1.5}};
  }

  /// In the middle of each house, from side to side.
  [[nodiscard]] culler::PolygonSoup walls() const {
    culler::PolygonSoup soup;
    for (std::size_t i = 0; i < std::min(options_.walls, options_.houses); ++i) {
      const auto [west, south] = place(i);
      const double y = south + kDepth / 2;
      std::uint32_t corners[4];
      corners[0] = soup.add_vertex({west, y, 0});
      corners[1] = soup.add_vertex({west + kWidth, y, 0});
      corners[2] = soup.add_vertex({west + kWidth, y, kWall});
      corners[3] = soup.add_vertex({west, y, kWall});
      soup.add_polygon(corners);
    }
    return soup;
  }

  const TownBenchOptions& options_;
  std::size_t columns_;
  std::vector<culler::Box> houses_;
};

/// How long the town takes to make, each time.
Spread prepared_ms(const Town& town, std::size_t repetitions) {
  render::Progress progress("made", repetitions);
  std::vector<ObjectId> cars;
  std::vector<double> ms;
  while (ms.size() < repetitions) {
    render::check_interrupt();
    ms.push_back(milliseconds([&] { static_cast<void>(town.made(cars)); }));
    progress.update(ms.size());
  }
  return spread_of(ms);
}

}  // namespace

TownBenchResult bench_town(const TownBenchOptions& options) {
  TownBenchResult result;
  const Town town(options);
  result.prepared_ms = prepared_ms(town, options.repetitions);

  std::vector<ObjectId> cars;
  const PeakMemory memory;
  culler::Scene scene = town.made(cars);
  result.held_bytes = memory.held_bytes();

  render::Progress progress("frame", options.frames);
  culler::SceneView view;
  std::vector<double> update_ms;
  ViewSamples samples;
  for (std::size_t frame = 0; frame < options.frames; ++frame) {
    render::check_interrupt();
    town.drive(scene, cars, frame);
    update_ms.push_back(milliseconds([&] { scene.update(); }));
    const double cull_ms = milliseconds([&] { scene.cull(town.camera(frame), {.cover = options.cover}, view); });
    samples.add(cull_ms, view.result().stats);
    progress.update(frame + 1);
  }
  result.update_ms = spread_of(update_ms);
  result.view = samples.spread();
  return result;
}

}  // namespace occlude::experiments
