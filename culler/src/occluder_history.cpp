// SPDX-License-Identifier: MIT
#include "occlude/culler/occluder_history.h"

#include "occlude/culler/culler.h"

namespace occlude::culler {
namespace {

/// Frames after which what an occluder hid is forgotten and it is tried once more: of 4, 8, 16, 64 and 300 those that cull
/// most on the paths through the city, Utrecht, the castle and Sponza together.
constexpr std::uint32_t kMemory = 16;

}  // namespace

std::optional<std::uint32_t> OccluderHistory::hidden(std::uint32_t region) const {
  if (region >= entries_.size()) return std::nullopt;
  const Entry& entry = entries_[region];
  if (entry.frame == 0 || frames_ - entry.frame >= kMemory) return std::nullopt;
  return entry.hidden;
}

void OccluderHistory::record(std::size_t regions, std::span<const Occluder> occluders) {
  entries_.resize(regions);
  ++frames_;
  for (const Occluder& occluder : occluders) entries_[occluder.region] = {frames_, occluder.hidden};
}

}  // namespace occlude::culler
