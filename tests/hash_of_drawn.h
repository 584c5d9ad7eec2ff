// SPDX-License-Identifier: MIT
// A hash of what a frame draws, as pages and Node compute it, too.
#pragma once

#include <cstdint>
#include <vector>

#include "occlude/culler/culler.h"

namespace occlude {

/// FNV-1a, 32 bits, over the numbers of the polygons that are drawn, ascending.
inline std::uint32_t hash_of_drawn(const culler::Hierarchy& hierarchy, const culler::CullResult& frame) {
  std::vector<bool> is_drawn(hierarchy.soup().size());
  for (const auto& [first, count] : frame.drawn) {
    for (std::uint32_t p = first; p < first + count; ++p) is_drawn[hierarchy.original(p)] = true;
  }
  std::uint32_t hash = 0x811c9dc5;
  for (std::uint32_t number = 0; number < is_drawn.size(); ++number) {
    if (is_drawn[number]) hash = (hash ^ number) * 0x01000193;
  }
  return hash;
}

}  // namespace occlude
