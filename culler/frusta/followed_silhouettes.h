// SPDX-License-Identifier: MIT
// The silhouettes of shells that a view follows from frame to frame.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "base/sparse_zero_array.h"
#include "occlude/kernel/polytope_silhouette.h"

namespace occlude::culler {

/// Holds a fixed number of silhouettes, whatever the path. A new one replaces one that was not asked for since the hand
/// passed it last (the clock algorithm, Corbato 1968).
class FollowedSilhouettes {
 public:
  /// Makes places for `count` of `shells`, which have at most this many faces and edges. REQUIRES: count > 0 if there are
  /// shells; the same shells at every call.
  void reserve(std::size_t count, std::size_t shells, std::size_t faces, std::size_t edges) {
    place_.grow(shells);
    followed_.reserve(count);
    while (followed_.size() < count) followed_.emplace_back().seen.reserve(faces, edges);
  }

  /// What was last seen of the shell; empty at first.
  [[nodiscard]] kernel::PolytopeSilhouette& of(std::uint32_t shell) {
    std::uint32_t& place = place_[shell];
    if (place == 0) {
      place = free_place() + 1;
      followed_[place - 1].shell = shell;
    }
    Followed& followed = followed_[place - 1];
    followed.is_recent = true;
    return followed.seen;
  }

  [[nodiscard]] std::size_t size() const { return followed_.size(); }

 private:
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  struct Followed {
    std::uint32_t shell = kNone;
    bool is_recent = false;  ///< asked for since the hand was here last
    kernel::PolytopeSilhouette seen;
  };

  std::uint32_t free_place() {
    for (;; hand_ = (hand_ + 1) % followed_.size()) {
      Followed& followed = followed_[hand_];
      if (!followed.is_recent) break;
      followed.is_recent = false;
    }
    Followed& free = followed_[hand_];
    if (free.shell != kNone) place_[free.shell] = 0;
    free.seen.clear();
    return static_cast<std::uint32_t>(hand_);
  }

  std::vector<Followed> followed_;
  SparseZeroArray<std::uint32_t> place_;  ///< for each shell, its index in followed_ plus 1, or 0
  std::size_t hand_ = 0;
};

}  // namespace occlude::culler
