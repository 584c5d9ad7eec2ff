// SPDX-License-Identifier: MIT
// Names of what is in a scene. Reading order: 13.
#pragma once

#include <cstdint>
#include <limits>

namespace occlude::culler {

/// Names one object or one occluder of a scene until it is removed; none by default. What is added later never has the id of
/// what was removed. `slot` is small: what is added takes the place of what was removed. So an array of a caller's own,
/// indexed by slots, stays short.
template <class Of>
struct SceneId {
  static constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();

  std::uint32_t slot = kNone, generation = 0;

  [[nodiscard]] bool is_none() const { return slot == kNone; }
  friend bool operator==(const SceneId&, const SceneId&) = default;
};

using ObjectId = SceneId<struct OfObject>;
using OccluderId = SceneId<struct OfOccluder>;

}  // namespace occlude::culler
