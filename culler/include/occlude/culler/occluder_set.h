// SPDX-License-Identifier: MIT
// Everything that may hide a model, and where it may be chosen: the polygons, the potential occluders made of them, and the
// regions that list these. Reading order: 8.
#pragma once

#include <memory>
#include <utility>

#include "occlude/culler/checkpoint.h"
#include "occlude/culler/occluder_lists.h"
#include "occlude/culler/polygon_soup.h"
#include "occlude/culler/potential_occluders.h"

namespace occlude::culler {

/// Const calls may run on several threads at once. Copies share the soup.
class OccluderSet : public PotentialOccluders {
 public:
  /// The potential occluders of the soup, and the lists of the regions of `space`. REQUIRES and throws as
  /// PotentialOccluders::find() and OccluderLists::build().
  [[nodiscard]] static OccluderSet build(std::shared_ptr<const PolygonSoup> soup, const Space& space, const Config& config,
                                         const OccluderLists::Config& of_lists, const Checkpoint& checkpoint = {}) {
    PotentialOccluders potential = find(std::move(soup), config, checkpoint);
    OccluderLists lists = OccluderLists::build(potential, space, of_lists, checkpoint);
    return {std::move(potential), std::move(lists)};
  }

  /// The same with lists that were stored. REQUIRES as build(); throws as OccluderLists::restore().
  [[nodiscard]] static OccluderSet restore(std::shared_ptr<const PolygonSoup> soup, const Space& space, const Config& config,
                                           const OccluderLists::Config& of_lists, OccluderLists::Stored stored,
                                           const Checkpoint& checkpoint = {}) {
    PotentialOccluders potential = find(std::move(soup), config, checkpoint);
    OccluderLists lists = OccluderLists::restore(potential, space, of_lists, std::move(stored), checkpoint);
    return {std::move(potential), std::move(lists)};
  }

  [[nodiscard]] const OccluderLists& lists() const { return lists_; }

 private:
  OccluderSet(PotentialOccluders potential, OccluderLists lists)
      : PotentialOccluders(std::move(potential)), lists_(std::move(lists)) {}

  OccluderLists lists_;
};

}  // namespace occlude::culler
