// SPDX-License-Identifier: MIT
// Coherence (section 4, criterion 3): what hid much in a frame does so in the next, and what hid nothing does not. Reading
// order: 8.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace occlude::culler {

struct Occluder;

/// What occluders hid in the last frames of one view, which follow one another as they are shown. It costs nothing to know:
/// the traversal says which occluder took which subtree.
class OccluderHistory {
 public:
  /// Frames after which what an occluder hid is forgotten and it is tried once more: of 4, 8, 16, 64 and 300 those that cull
  /// most on the paths through the city, Utrecht, the castle and Sponza together.
  static constexpr std::uint32_t kFrames = 16;

  /// An occluder used lately.
  struct Entry {
    std::uint32_t occluder = 0;
    std::uint32_t frame = 0;   ///< the last in which it was one, counted from 1
    std::uint32_t hidden = 0;  ///< polygons that its shadow took then
  };

  /// The occluders of the last frames, in the order in which they came to be used.
  [[nodiscard]] std::span<const Entry> recent() const { return recent_; }
  /// What the occluder hid in the last frame in which it was one: none where that is too long ago to tell.
  [[nodiscard]] std::optional<std::uint32_t> hidden(std::uint32_t occluder) const;

  /// Makes room for what is kept of so many of the potential occluders.
  void reserve(std::size_t potential, std::size_t remembered);
  /// Takes down a frame that chose from so many potential occluders. What probes would have hidden counts as hidden.
  void record(std::size_t potential, std::span<const Occluder> occluders, std::span<const Occluder> probes);

 private:
  void take_down(const Occluder& occluder);

  std::uint32_t frames_ = 0;
  std::vector<Entry> recent_;
  std::vector<std::uint32_t> place_;  ///< of each occluder, one more than its place in recent_, or 0
};

}  // namespace occlude::culler
