// SPDX-License-Identifier: MIT
// Coherence (section 4, criterion 3): what hid much in one frame does so in the next, and what hid nothing does not. Reading
// order: 8.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/sparse_zero_array.h"

namespace occlude::culler {

struct Occluder;

/// What occluders hid in the last frames of one view, whose frames follow one another as they are shown. Knowing it costs
/// nothing, because the traversal records which occluder culled which subtree.
class OccluderHistory {
 public:
  /// After this many frames it is forgotten what an occluder hid, and the occluder is tried again. Of 4, 8, 16, 64 and 300
  /// frames, 16 cull most on the paths through the city, Utrecht, the castle and Sponza together.
  static constexpr std::uint32_t kFrames = 16;

  /// An occluder used lately.
  struct Entry {
    std::uint32_t occluder = 0;
    std::uint32_t frame = 0;   ///< the last that used it, counted from 1
    std::uint32_t hidden = 0;  ///< polygons that its shadow culled then
  };

  /// The occluders of the last frames, in the order in which they came to be used.
  [[nodiscard]] std::span<const Entry> recent() const { return recent_; }
  /// What the occluder hid in the last frame that used it; none if that is too long ago.
  [[nodiscard]] std::optional<std::uint32_t> hidden(std::uint32_t occluder) const;

  /// Reserves memory for `potential` occluders, of which at most `remembered` are kept at once.
  void reserve(std::size_t potential, std::size_t remembered);
  /// Records a frame that chose from this many potential occluders. What probes would have hidden counts as hidden.
  void record(std::size_t potential, std::span<const Occluder> occluders, std::span<const Occluder> probes);

 private:
  void take_down(const Occluder& occluder);

  std::uint32_t frames_ = 0;
  std::vector<Entry> recent_;
  SparseZeroArray<std::uint32_t> place_;  ///< for each occluder, its index in recent_ plus 1, or 0
};

}  // namespace occlude::culler
