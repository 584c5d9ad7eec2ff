// SPDX-License-Identifier: MIT
// What the experiments are made on, and how.
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
  /// Frames, pictures, hierarchy and culling of all experiments, but for what each of them varies.
  render::WalkOptions walk;
  /// Of the grid for figure 4. Sampling takes time in proportion: of the default grid minutes, of this one, whose regions
  /// are twice as long, seconds.
  std::size_t regions = 4096;
  std::size_t samples = 1;          ///< viewpoints a region by which depth complexity is sampled; 0: not at all
  std::size_t repetitions = 3;      ///< rounds of what is timed
  std::size_t largest = 1'000'000;  ///< polygons of the largest city of the growth
  std::uint64_t seed = 1;           ///< of the cities
};

}  // namespace occlude::experiments
