// SPDX-License-Identifier: MIT
#include "frusta/occluder_history.h"

#include "occlude/culler/cull_result.h"

namespace occlude::culler {
std::optional<std::uint32_t> OccluderHistory::hidden(std::uint32_t occluder) const {
  const std::uint32_t place = occluder < place_.size() ? place_.get(occluder) : 0;
  if (place == 0) return std::nullopt;
  return recent_[place - 1].hidden;
}

void OccluderHistory::take_down(const Occluder& occluder) {
  std::uint32_t& place = place_[occluder.index];
  if (place == 0) {
    recent_.push_back({});
    place = static_cast<std::uint32_t>(recent_.size());
  }
  recent_[place - 1] = {occluder.index, frames_, occluder.hidden};
}

void OccluderHistory::reserve(std::size_t potential, std::size_t remembered) {
  place_.grow(potential);
  recent_.reserve(remembered);
}

void OccluderHistory::record(std::size_t potential, std::span<const Occluder> occluders, std::span<const Occluder> probes) {
  place_.grow(potential);
  ++frames_;
  for (const Occluder& occluder : occluders) take_down(occluder);
  for (const Occluder& probe : probes) take_down(probe);
  std::size_t kept = 0;
  for (const Entry& entry : recent_) {
    const bool is_recent = frames_ - entry.frame < kFrames;
    if (is_recent) recent_[kept++] = entry;
    place_[entry.occluder] = is_recent ? static_cast<std::uint32_t>(kept) : 0;
  }
  recent_.resize(kept);
}

}  // namespace occlude::culler
