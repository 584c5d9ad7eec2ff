// SPDX-License-Identifier: MIT
// Everything that may hide a model, and where it may be chosen: the polygons, the potential occluders made of them, and the
// regions that list these. Reading order: 8.
#pragma once

#include <utility>
#include <vector>

#include "frusta/occluder_lists.h"
#include "frusta/potential_occluders.h"
#include "occlude/culler/executor.h"
#include "occlude/culler/polygon_soup.h"

namespace occlude::culler {

/// Const calls may run on several threads at once. Copies share the soup.
class OccluderSet : public PotentialOccluders {
 public:
  /// The potential occluders of the soup, and the lists of the regions of `space`. REQUIRES and throws as
  /// PotentialOccluders::find() and OccluderLists::build().
  [[nodiscard]] static OccluderSet build(SharedSoup soup, const Space& space, const OccluderConfig& config,
                                         const ListConfig& of_lists, const Checkpoint& checkpoint = {}) {
    PotentialOccluders potential = find(std::move(soup), config, checkpoint);
    OccluderLists lists = OccluderLists::build(potential, space, of_lists, checkpoint);
    return {std::move(potential), std::move(lists)};
  }

  /// For Culler::parts().
  void append_parts(PartWriter& parts) const {
    PotentialOccluders::append_parts(parts);
    lists_.append_parts(parts);
  }
  /// The occluders with these parts. REQUIRES and throws as those of PotentialOccluders and OccluderLists.
  [[nodiscard]] static OccluderSet from_parts(const PartReader& parts, SharedSoup soup, const Checkpoint& checkpoint = {}) {
    PotentialOccluders potential = PotentialOccluders::from_parts(parts, std::move(soup), checkpoint);
    OccluderLists lists = OccluderLists::from_parts(parts, potential, checkpoint);
    return {std::move(potential), std::move(lists)};
  }

  /// The same with what listed occluders hide. Throws as OccluderLists::with_hidden().
  [[nodiscard]] OccluderSet with_hidden(std::vector<float> hidden) const {
    return {static_cast<const PotentialOccluders&>(*this), lists_.with_hidden(std::move(hidden))};
  }

  [[nodiscard]] const OccluderLists& lists() const { return lists_; }

 private:
  OccluderSet(PotentialOccluders potential, OccluderLists lists)
      : PotentialOccluders(std::move(potential)), lists_(std::move(lists)) {}

  OccluderLists lists_;
};

}  // namespace occlude::culler
