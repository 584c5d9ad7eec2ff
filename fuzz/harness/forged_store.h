// SPDX-License-Identifier: MIT
// Stores in which something is forged, with right hashes.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "occlude/fuzz/random.h"

namespace occlude::harness {

struct ForgedStore {
  std::string what;  ///< what was done to it, in a word or two
  /// It has oriented boxes, which a reader believes (Culler(const Parts&)).
  bool has_oriented_boxes = false;
  std::vector<std::byte> bytes;
};

/// A sound store of a small scene.
[[nodiscard]] ForgedStore sound_store(fuzz::Random& random);

/// A sound store with one to three forgeries: of numbers, counts, elements, sections, settings, the table; and whole trees,
/// lists, cells, rings, blocks, regions and shells that are what they should not be, or sound but other ones.
[[nodiscard]] ForgedStore forged_store(fuzz::Random& random);

}  // namespace occlude::harness
