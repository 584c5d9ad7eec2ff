// SPDX-License-Identifier: MIT
// Where in the coarse picture a frame looks: everywhere, or in one strip.
#pragma once

#include <algorithm>
#include <cstdint>

#include "cover/cover_buffer.h"
#include "occlude/culler/cull_result.h"

namespace occlude::culler {

class Look {
 public:
  /// REQUIRES: the picture has begun.
  Look(const CoverStrip& strip, const CoverBuffer& buffer) : buffer_(buffer), is_everywhere_(strip == CoverStrip{}) {
    first_ = column(strip.first);
    end_ = column(strip.end);
  }

  /// Whether what has this footprint is seen where the frame looks. What is not, is not looked at, and need not be hidden:
  /// behind what closes the strip, boxes that reach across its border would otherwise be looked at down to the last.
  [[nodiscard]] bool sees(CoverBuffer::Footprint footprint) const {
    if (is_everywhere_) return true;
    footprint.pixels.x0 = std::max(footprint.pixels.x0, first_);
    footprint.pixels.x1 = std::min(footprint.pixels.x1, end_);
    return footprint.size() > 0 && buffer_.open(footprint, 1) > 0;
  }

 private:
  [[nodiscard]] int column(std::uint32_t share) const {
    return static_cast<int>(share * static_cast<std::uint32_t>(buffer_.box_picture().width) / CoverStrip::kWidth);
  }

  const CoverBuffer& buffer_;
  bool is_everywhere_;
  int first_, end_;
};

}  // namespace occlude::culler
