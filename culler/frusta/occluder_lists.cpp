// SPDX-License-Identifier: MIT
#include "frusta/occluder_lists.h"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "base/part_checks.h"
#include "frusta/region_lists.h"
#include "model/part_list.h"

namespace occlude::culler {
namespace {

constexpr std::string_view kListFirst = "list first", kListEntries = "listed", kListHidden = "hidden";

/// Whether they can be the lists of so many regions, of these occluders. What hides nothing is in no list.
bool are_sound(const OccluderLists::Stored& stored, std::size_t regions, const PotentialOccluders& occluders,
               const Checkpoint& checkpoint) {
  const Array<std::uint64_t>& first = stored.first;
  const auto is_sound = [&](std::size_t region) {
    const std::span listed(stored.occluders.data() + first[region], stored.occluders.data() + first[region + 1]);
    return are_ascending_below(listed, occluders.size()) &&
           std::ranges::all_of(listed, [&](std::uint32_t i) { return occluders.hides(i); });
  };
  return first.size() == regions + 1 && are_starts(first, stored.occluders.size(), checkpoint) &&
         are_all(regions, is_sound, checkpoint);
}

bool is_of(std::span<const float> hidden, const OccluderLists::Stored& stored) {
  return hidden.size() == stored.occluders.size() &&
         std::ranges::all_of(hidden, [](float h) { return h >= 0 && std::isfinite(h); });
}

}  // namespace

OccluderLists::OccluderLists(Partition partition, Stored stored)
    : partition_(std::move(partition)), stored_(std::move(stored)) {
  for (std::size_t region = 0; region < partition_.regions(); ++region) {
    longest_ = std::max(longest_, list(region).occluders.size());
  }
}

std::string OccluderLists::fault(const ListConfig& config) {
  if (!(config.threshold > 0)) return "the threshold of the lists must be above 0";
  return Partition::can_have(config.regions) ? "" : "the number of regions must be from 1 to 2^30";
}

OccluderLists OccluderLists::build(const PotentialOccluders& occluders, const Space& space, const ListConfig& config,
                                   const Checkpoint& checkpoint) {
  if (const std::string reason = fault(config); !reason.empty()) throw std::invalid_argument(reason);
  Partition partition = Partition::make(config.kind, space, config.regions, checkpoint);
  Stored stored = list_occluders(partition, occluders, config, checkpoint);
  return {std::move(partition), std::move(stored)};
}

void OccluderLists::append_parts(PartWriter& parts) const {
  partition_.append_parts(parts);
  parts.put(kListFirst, stored_.first);
  parts.put(kListEntries, stored_.occluders);
  parts.put(kListHidden, stored_.hidden);
}

OccluderLists OccluderLists::from_parts(const PartReader& parts, const PotentialOccluders& occluders,
                                        const Checkpoint& checkpoint) {
  Partition partition = Partition::from_parts(parts);
  Stored stored{parts.get<std::uint64_t>(kListFirst), parts.get<std::uint32_t>(kListEntries), parts.get<float>(kListHidden)};
  if (!are_sound(stored, partition.regions(), occluders, checkpoint)) {
    refuse_part(kListEntries, "the lists are not of these regions and occluders");
  }
  if (!stored.hidden.empty() && !is_of({stored.hidden.begin(), stored.hidden.end()}, stored)) {
    refuse_part(kListHidden, "it is not of these lists");
  }
  return {std::move(partition), std::move(stored)};
}

OccluderLists OccluderLists::with_hidden(std::vector<float> hidden) const {
  if (!is_of(hidden, stored_)) throw std::invalid_argument("what occluders hide is not of these lists");
  return {partition_, {stored_.first, stored_.occluders, std::move(hidden)}};
}

OccluderLists::List OccluderLists::list(std::size_t region) const {
  const std::size_t first = stored_.first[region], count = stored_.first[region + 1] - first;
  List list{{stored_.occluders.data() + first, count}, {}};
  if (!stored_.hidden.empty()) list.hidden = {stored_.hidden.data() + first, count};
  return list;
}

}  // namespace occlude::culler
