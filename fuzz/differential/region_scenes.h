// SPDX-License-Identifier: MIT
// Small scenes for cameras whose eye may be in a region, each aimed at one thing that is hard to bound.
#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "occlude/culler/camera.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/fuzz/random.h"

namespace occlude::fuzz {

enum class RegionAim {
  overtaking,  ///< short edges of a border with ends at different depths, of which one passes the other for some eye
  epipole,   ///< the eyes are on a line that meets an edge of a border between its ends: seen from there both ends move away
  edge_on,   ///< large planes that the eyes nearly reach or reach, and things by their side
  layers,    ///< things just before and behind the planes in focus, and walls in these planes
  touching,  ///< walls that touch the region, or on which the eye is
  slivers,   ///< walls of slivers in a plane in focus
};

inline constexpr std::array kRegionAims{RegionAim::overtaking, RegionAim::epipole,  RegionAim::edge_on,
                                        RegionAim::layers,     RegionAim::touching, RegionAim::slivers};

struct RegionScene {
  RegionAim aim{};
  culler::PolygonSoup soup;
  culler::Camera camera;
  culler::CullOptions options;
  /// Edges that the scene is about, as it was made: of the borders, or of the walls.
  std::vector<std::array<glm::dvec3, 2>> edges;
};

/// The planes in focus when the camera sees the soup: how far they are along the line of sight, from far to near.
[[nodiscard]] std::vector<double> focus_distances(const RegionScene& scene);

/// One in eight scenes is of a size from 2^-80 to 2^80, and one in eight has something far away. All numbers are legal. What
/// has coordinates of a few bits touches exactly, in half of the scenes.
[[nodiscard]] RegionScene some_region_scene(Random& random);

}  // namespace occlude::fuzz
