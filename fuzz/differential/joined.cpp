// SPDX-License-Identifier: MIT
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "any_case.h"
#include "cull_judge.h"
#include "frame/view_memory.h"
#include "occlude/culler/culler.h"
#include "rows.h"
#include "small_scenes.h"
#include "verdict.h"

namespace occlude::fuzz {
namespace {

using culler::Camera;
using culler::Culler;
using glm::dvec3;

/// Adds a wall of panels across the line of sight, folded or flat. Sometimes a panel is missing or a corner is moved by very
/// little. A large wall is drawn in several groups that share edges.
void add_panels(Random& random, culler::PolygonSoup& soup, const Camera& camera) {
  const auto [right, up, forward] = camera.axes();
  const bool is_large = random.chance(0.05);
  const int count = is_large ? random.integer(17, 24) : random.integer(2, 6),
            left_out = random.chance(0.3) ? random.integer(0, count * count - 1) : -1;
  const double distance = random.integer(1, 6), size = is_large ? distance : 0.5 * random.integer(1, 6),
               fold = random.chance(0.5) ? 0.25 : 0;
  std::vector<std::uint32_t> corners;
  for (int i = 0; i <= count; ++i) {
    for (int k = 0; k <= count; ++k) {
      const dvec3 across = size * ((2.0 * i / count - 1) * right + (2.0 * k / count - 1) * up);
      corners.push_back(soup.add_vertex(camera.eye + (distance + fold * ((i + k) % 2)) * forward + across));
    }
  }
  const auto at = [&](int i, int k) { return corners[static_cast<std::size_t>(i * (count + 1) + k)]; };
  for (int panel = 0; panel < count * count; ++panel) {
    if (panel == left_out) continue;
    const int i = panel / count, k = panel % count;
    std::array<std::uint32_t, 4> loop{at(i, k), at(i + 1, k), at(i + 1, k + 1), at(i, k + 1)};
    if (random.chance(0.05)) {
      const dvec3 gap = std::ldexp(1.0, -random.integer(4, 50)) * lattice_point(random, 1);
      loop[0] = soup.add_vertex(soup.vertices[loop[0]] + gap);
    }
    if (random.chance(0.2)) std::swap(loop[1], loop[3]);
    soup.add_polygon(loop);
  }
}

culler::CullOptions some_cover_options(Random& random) {
  culler::CullOptions options;
  options.method = culler::Method::cover;
  options.cover.width = std::array{64, 128, 256}[random.index(3)];
  if (random.chance(0.3)) options.cover.work = random.index(random.chance(0.5) ? 64 : 2000);
  options.cover.height = std::array{64, 96, 160}[random.index(3)];
  if (random.chance(0.3)) options.margin = std::array{0x1p-80, 0x1p-20, 0x1p-6}[random.index(3)];
  return options;
}

/// A camera without a fault.
Camera some_good_camera(Random& random, culler::SoupView soup) {
  return first_legal([&]() -> std::optional<Camera> {
    Camera camera = some_camera(random, soup);
    return culler::fault(camera).empty() ? std::optional(camera) : std::nullopt;
  });
}

/// Makes the camera look along an axis, so that what is flat across the line of sight has flat boxes.
void turn_to_axis(Random& random, Camera& camera) {
  const int axis = random.integer(0, 2);
  dvec3 forward{}, up{};
  forward[axis] = random.chance(0.5) ? 1 : -1;
  up[(axis + 1) % 3] = 1;
  camera.target = camera.eye + forward;
  camera.up = up;
}

/// A ball, or a box with up to three half-edges.
culler::EyeRegion some_region(Random& random) {
  const double size = std::array{1e-9, 0x1p-10, 0x1p-5, 0.5}[random.index(4)];
  if (random.chance(0.4)) return culler::EyeRegion::ball(size);
  culler::EyeRegion eyes;
  for (int i = random.integer(0, 2); i < 3; ++i)
    eyes.half_edges[static_cast<std::size_t>(i)] = size * lattice_point(random, 2);
  return eyes;
}

template <class AnyCamera>
std::string fault_of_frame(const Culler& culler, const AnyCamera& camera, const culler::CullOptions& options) {
  return culler::fault(camera).empty() ? fuzz::fault_of(culler, camera, options, culler.cull(camera, options)) : "";
}

/// What is wrong with the frame of the camera or a matrix of it, perhaps for several eyes.
std::string fault_from_eyes(Random& random, const Culler& culler, Camera camera, const culler::CullOptions& options) {
  if (random.chance(0.5)) camera.eyes = some_region(random);
  if (random.chance(0.5)) return fault_of_frame(culler, camera, options);
  culler::MatrixCamera matrix = matrix_of(random, camera);
  matrix.eyes = camera.eyes;
  return fault_of_frame(culler, matrix, options);
}

}  // namespace

void run_joined(std::uint64_t seed, Report& report) {
  Random random(seed);
  culler::PolygonSoup soup = some_soup(random);
  Camera camera = some_good_camera(random, soup);
  if (random.chance(0.2)) turn_to_axis(random, camera);
  if (!culler::fault(camera).empty()) return;  // the eye is so far away that it rounds to its own target
  for (int walls = random.integer(1, 3); walls > 0; --walls) add_panels(random, soup, camera);
  culler::BuildConfig config;
  config.hierarchy.leaf_size = static_cast<std::uint32_t>(random.integer(1, 4));
  config.lists.regions = 1;  // covers need no regions, and to make many would take longer than the rest
  const Culler culler(soup, config);
  culler::CullOptions options = some_cover_options(random);
  if (random.chance(0.5)) options.method = culler::Method::automatic;
  culler::View view;
  for (int frame = 0; frame < 3; ++frame) {
    const culler::CullResult& result = culler.cull(camera, options, view);
    memory_of(view).worth.cheap = 0;  // so that the third frame saves work
    report.tally.cases += soup.size();
    report.tally.relations[0] += result.stats.shadow_culled_polygons;
    report.tally.relations[1] += result.stats.drawn_polygons;
    report.tally.relations[2] += result.stats.view_culled_polygons;
    report.tally.stages[0] += soup.size();
    std::string wrong = fault_of(culler, camera, options, result);
    if (wrong.empty() && random.chance(0.3)) wrong = fault_from_eyes(random, culler, camera, options);
    if (!wrong.empty()) return add_finding(report, "frame", wrong);
    camera.eye += 0.25 * lattice_point(random, 2);
    camera.target += 0.125 * lattice_point(random, 2);
    if (!culler::fault(camera).empty()) return;
  }
}

}  // namespace occlude::fuzz
