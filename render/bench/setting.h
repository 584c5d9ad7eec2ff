// SPDX-License-Identifier: MIT
// The input and the options of the experiments.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "occlude/culler/polygon_soup.h"
#include "occlude/render/camera_path.h"
#include "occlude/render/walk.h"

namespace occlude::experiments {

/// A model and a path through it.
struct Subject {
  std::string name;
  culler::PolygonSoup soup;
  render::CameraPath path;
};

struct Options {
  /// Frames, pictures, hierarchy and culling of all experiments, except what each experiment varies.
  render::WalkOptions walk;
  /// Regions for figure 4. Sampling time is proportional to it: minutes for the default of a preprocess, seconds for this
  /// one, whose cubes are twice as long.
  std::size_t regions = 4096;
  std::size_t samples = 1;          ///< viewpoints per region to sample depth complexity; 0: none
  std::size_t repetitions = 3;      ///< rounds of all timings
  std::size_t largest = 1'000'000;  ///< polygons of the largest city of the growth
  std::uint64_t seed = 1;           ///< of the cities
};

}  // namespace occlude::experiments
