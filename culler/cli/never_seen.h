// SPDX-License-Identifier: MIT
// What is hidden from everywhere in many boxes of eyes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "occlude/culler/culler.h"
#include "occlude/kernel/types.h"

namespace occlude::cli {

struct SearchOptions {
  std::size_t rays = 256;        ///< to each polygon, from random eyes: what one seems to reach is not asked
  std::size_t effort = 4096;     ///< culls at most, once cells were asked, which for this are divided into parts
  std::size_t cover_size = 384;  ///< side of the coarse pictures, pixels
  bool keeps_looks = false;
};

/// The culls that these mean.
[[nodiscard]] culler::CullOptions cull_options_of(const SearchOptions& options);

/// What culls by cover from everywhere in a cell have found.
struct Look {
  kernel::Aabb cell;
  std::vector<culler::Camera> cameras;  ///< of the culls. Each box that is hidden is culled by one of them
  std::vector<std::uint32_t> hidden;    ///< ascending
};

struct NeverSeen {
  std::vector<bool> polygons;  ///< of each polygon of the tree, whether it is hidden
  std::vector<Look> looks;     ///< if they are kept, those that hide such polygons, and these alone
};

/// The polygons of the tree that are hidden from everywhere in all cells.
/// 1. For each eye in a cell and each point of such a polygon, the segment between them meets an opaque polygon strictly
///    between.
/// 2. Polygons may be left out though they are hidden. It does not depend on the number of threads which.
/// Only candidates are asked, but all polygons hide.
/// REQUIRES: there are cells, and kernel::check() refuses none; candidates has a value for each polygon.
[[nodiscard]] NeverSeen never_seen(const culler::Culler& culler, const std::vector<kernel::Aabb>& cells,
                                   const std::vector<bool>& candidates, const SearchOptions& options,
                                   const std::function<void(std::size_t done, std::size_t all)>& progress);

}  // namespace occlude::cli
