// SPDX-License-Identifier: MIT
// What a descent by a cover tells of a leaf.
#pragma once

#include <cstdint>

#include "cover/cover_buffer.h"

namespace occlude::culler {

/// A leaf that is not culled.
struct SeenNode {
  std::uint32_t node;
  std::uint32_t straddled_planes;  ///< a bit for each plane that may cross it
  CoverBuffer::Footprint footprint;
  bool is_worth_closing;  ///< whether it is seen through more than a slit
};

}  // namespace occlude::culler
