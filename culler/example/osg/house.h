// SPDX-License-Identifier: MIT
// The kinds of houses of the town.
#pragma once

#include <osg/ref_ptr>
#include <random>
#include <vector>

#include "town_mesh.h"

namespace occlude::example {

/// A house with a gabled roof: x from 0 to width along the street, y from 0 (the front) to depth.
struct House {
  float width, depth, eaves, ridge;
  /// Holes in the front, through which one sees what is inside: none, or the windows of a shop.
  std::vector<Opening> openings;
  TownMesh mesh;
};

[[nodiscard]] House make_house(float width, std::mt19937& random);

/// A number from low to high; the same everywhere for the same state of `random`.
[[nodiscard]] float uniform(std::mt19937& random, float low, float high);

}  // namespace occlude::example
