// SPDX-License-Identifier: MIT
// The preprocess of section 4.1: space divided into regions, each with its list of potential occluders.
// Reading order: 7.
#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <string>
#include <vector>

#include "frusta/partition.h"
#include "frusta/potential_occluders.h"
#include "occlude/culler/cull_result.h"
#include "occlude/culler/executor.h"
#include "occlude/culler/parts.h"

namespace occlude::culler {

/// Const calls may run on several threads at once. Region numbers are not checked.
class OccluderLists {
 public:
  /// The lists of all regions, one after another, each ascending.
  struct Stored {
    Array<std::uint64_t> first;  ///< region r has the entries [first[r], first[r + 1])
    Array<std::uint32_t> occluders;
    /// For each entry, the mean number of polygons that the occluder hides as seen from the region. Empty if not sampled.
    Array<float> hidden;
  };

  /// The list of one region.
  struct List {
    std::span<const std::uint32_t> occluders;  ///< ascending indices in PotentialOccluders
    std::span<const float> hidden;             ///< for each, as in Stored; or empty
  };

  /// Why no lists can be made so: a threshold that is not above 0, or a number of regions that a partition cannot have.
  /// Empty if they can.
  [[nodiscard]] static std::string fault(const ListConfig& config);

  /// A partition of `space`, and its lists of the occluders that have an area.
  /// 1. Unless lists are cut, they are conservative: over the box of each region the area-angle is bounded from above.
  /// 2. The work is on all processors; the lists do not depend on their number.
  /// Throws std::invalid_argument for a config with a fault(), and what `checkpoint` throws. REQUIRES as Partition::make().
  [[nodiscard]] static OccluderLists build(const PotentialOccluders& occluders, const Space& space, const ListConfig& config,
                                           const Checkpoint& checkpoint = {});

  /// For Culler::parts().
  void append_parts(PartWriter& parts) const;
  /// The lists with these parts. Throws std::invalid_argument if they cannot be of so many occluders.
  [[nodiscard]] static OccluderLists from_parts(const PartReader& parts, const PotentialOccluders& occluders,
                                                const Checkpoint& checkpoint = {});
  /// The same lists with what occluders hide. Throws std::invalid_argument unless there is a finite number, not below 0, for
  /// each entry.
  [[nodiscard]] OccluderLists with_hidden(std::vector<float> hidden) const;

  [[nodiscard]] const Partition& partition() const { return partition_; }
  [[nodiscard]] const Stored& stored() const { return stored_; }
  /// The list of the region that the point is in. REQUIRES: the point is finite.
  [[nodiscard]] List list(const glm::dvec3& point) const { return list(partition_.region_at(point)); }
  [[nodiscard]] List list(std::size_t region) const;
  /// Entries of the longest list.
  [[nodiscard]] std::size_t longest() const { return longest_; }

 private:
  OccluderLists(Partition partition, Stored stored);

  Partition partition_;
  Stored stored_;
  std::size_t longest_ = 0;
};

}  // namespace occlude::culler
