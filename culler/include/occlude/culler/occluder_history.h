// SPDX-License-Identifier: MIT
// Coherence (section 4, criterion 3): what hid much in a frame does so in the next, and what hid nothing does not. Reading
// order: 6.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace occlude::culler {

struct Occluder;

/// What occluders hid in the last frames of one camera, which follow one another as they are shown. It costs nothing to
/// know: the traversal says which occluder took which subtree. A history belongs to one camera and one culler.
class OccluderHistory {
 public:
  /// Polygons that the shadow of the region took in the last frame in which it was an occluder: none where that is too long
  /// ago to tell.
  [[nodiscard]] std::optional<std::uint32_t> hidden(std::uint32_t region) const;

  /// Takes down a frame of a culler with so many regions.
  void record(std::size_t regions, std::span<const Occluder> occluders);

 private:
  struct Entry {
    std::uint32_t frame = 0;  ///< from 1; 0: never
    std::uint32_t hidden = 0;
  };
  std::uint32_t frames_ = 0;
  std::vector<Entry> entries_;  ///< by region
};

}  // namespace occlude::culler
