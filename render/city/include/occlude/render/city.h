// SPDX-License-Identifier: MIT
// The composite model of section 6.3: London streets, the ceremonial centre of Tenochtitlan, English hills.
#pragma once

#include <cstddef>
#include <cstdint>

#include "occlude/culler/polygon_soup.h"
#include "occlude/render/camera_path.h"

namespace occlude::render {

/// Polygons that may be asked for.
inline constexpr std::size_t kSmallestCity = 20'000, kLargestCity = 50'000'000;

struct City {
  culler::PolygonSoup soup;
  CameraPath path;  ///< 2748 frames at street level through all three parts, never inside a building
};

/// Builds a model of at least `polygons` polygons. The result depends on the two arguments alone: the same bytes for every
/// machine, compiler and build type (integer random numbers, coordinates on a grid of 2^-10 m, no library trigonometry).
/// REQUIRES: kSmallestCity <= polygons <= kLargestCity.
[[nodiscard]] City generate_city(std::size_t polygons, std::uint64_t seed);

}  // namespace occlude::render
