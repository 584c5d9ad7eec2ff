// SPDX-License-Identifier: MIT
#include "occlude/culler/occluder_lists.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <stdexcept>
#include <utility>

#include "region_lists.h"

namespace occlude::culler {
namespace {

Partition partition_of(const Space& space, const OccluderLists::Config& config, const Checkpoint& checkpoint) {
  if (!(config.threshold > 0)) throw std::invalid_argument("the threshold of the lists must be above 0");
  return Partition::make(config.kind, space, config.regions, checkpoint);
}

/// Whether they can be the lists of so many regions, of so many occluders.
bool are_sound(const OccluderLists::Stored& stored, std::size_t regions, std::size_t occluders) {
  const std::vector<std::uint64_t>& first = stored.first;
  const std::vector<std::uint32_t>& listed = stored.occluders;
  const std::vector<float>& hidden = stored.hidden;
  const auto ascend = [&] {
    for (std::size_t region = 0; region < regions; ++region) {
      const auto list = std::span(listed).subspan(first[region], first[region + 1] - first[region]);
      if (std::ranges::adjacent_find(list, std::ranges::greater_equal()) != list.end()) return false;
    }
    return true;
  };
  return first.size() == regions + 1 && first.front() == 0 && std::ranges::is_sorted(first) &&
         first.back() == listed.size() && (hidden.empty() || hidden.size() == listed.size()) &&
         std::ranges::all_of(listed, [&](std::uint32_t i) { return i < occluders; }) && ascend() &&
         std::ranges::all_of(hidden, [](float h) { return h >= 0 && std::isfinite(h); });
}

}  // namespace

OccluderLists::OccluderLists(Partition partition, Stored stored)
    : partition_(std::move(partition)), stored_(std::move(stored)) {
  for (std::size_t region = 0; region < partition_.regions(); ++region) {
    longest_ = std::max(longest_, list(region).occluders.size());
  }
}

OccluderLists OccluderLists::build(const PotentialOccluders& occluders, const Space& space, const Config& config,
                                   const Checkpoint& checkpoint) {
  Partition partition = partition_of(space, config, checkpoint);
  Stored stored = list_occluders(partition, occluders, config, checkpoint);
  return {std::move(partition), std::move(stored)};
}

OccluderLists OccluderLists::restore(const PotentialOccluders& occluders, const Space& space, const Config& config,
                                     Stored stored, const Checkpoint& checkpoint) {
  Partition partition = partition_of(space, config, checkpoint);
  if (!are_sound(stored, partition.regions(), occluders.size())) {
    throw std::invalid_argument("the lists of occluders are not of this model");
  }
  return {std::move(partition), std::move(stored)};
}

OccluderLists::List OccluderLists::list(std::size_t region) const {
  const std::size_t first = stored_.first[region], count = stored_.first[region + 1] - first;
  List list{std::span(stored_.occluders).subspan(first, count), {}};
  if (!stored_.hidden.empty()) list.hidden = std::span(stored_.hidden).subspan(first, count);
  return list;
}

}  // namespace occlude::culler
