// SPDX-License-Identifier: MIT
// Everything that may hide a model, and where it may be chosen: the polygons, the potential occluders made of them, and the
// regions that list these. Reading order: 8.
#pragma once

#include <memory>
#include <utility>

#include "occlude/culler/checkpoint.h"
#include "occlude/culler/occluder_grid.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/culler/potential_occluders.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// Const calls may run on several threads at once. Copies share the soup.
class OccluderSet : public PotentialOccluders {
 public:
  /// The potential occluders of the soup, and a grid of regions over `space`, which is about where the viewpoints are.
  /// REQUIRES and throws as PotentialOccluders::find() and OccluderGrid::build().
  [[nodiscard]] static OccluderSet build(std::shared_ptr<const PolygonSoup> soup, const kernel::Aabb& space,
                                         const Config& config, const OccluderGrid::Config& grid,
                                         const Checkpoint& checkpoint = {}) {
    PotentialOccluders potential = find(std::move(soup), config, checkpoint);
    OccluderGrid lists = OccluderGrid::build(potential, space, grid, checkpoint);
    return {std::move(potential), std::move(lists)};
  }

  /// The same with the lists of a grid that was built before. REQUIRES as build(); throws as OccluderGrid::restore().
  [[nodiscard]] static OccluderSet restore(std::shared_ptr<const PolygonSoup> soup, const kernel::Aabb& space,
                                           const Config& config, const OccluderGrid::Config& grid, OccluderGrid::Lists lists,
                                           const Checkpoint& checkpoint = {}) {
    PotentialOccluders potential = find(std::move(soup), config, checkpoint);
    OccluderGrid restored = OccluderGrid::restore(potential, space, grid, std::move(lists));
    return {std::move(potential), std::move(restored)};
  }

  [[nodiscard]] const OccluderGrid& grid() const { return grid_; }

 private:
  OccluderSet(PotentialOccluders potential, OccluderGrid grid)
      : PotentialOccluders(std::move(potential)), grid_(std::move(grid)) {}

  OccluderGrid grid_;
};

}  // namespace occlude::culler
