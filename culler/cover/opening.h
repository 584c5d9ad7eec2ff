// SPDX-License-Identifier: MIT
// Through how many pixels a node is seen, and which leaves are worth drawing.
#pragma once

#include <algorithm>
#include <cstddef>

#include "cover/cover_buffer.h"
#include "cover/cover_descent.h"

namespace occlude::culler {

/// A leaf that is seen through fewer pixels is not worth drawing: it shows through slits that nothing closes. With a
/// limit of 4, frames of models would draw 50 % more triangles and cull only a few thousandths more. An occluder of a
/// scene costs more, because it is found in two trees: with 8, a cull takes 8 % longer and draws 1 % fewer objects.
inline constexpr int kWorthOfLeaf = 8, kWorthOfOccluder = 12;
/// The more a frame has drawn, the less another leaf is worth: the limit is a pixel for each 512 triangles, as far as this
/// is between the limit above and 24. Frames of up to 4,096 triangles stay as they are. The castle and Sponza, of 18,000
/// to 28,000, draw half to two thirds of that, take 0.7 to 0.8 of the time, and cull less: of what is hidden 0.2 to 0.8 %
/// in the castle, 1 to 5 % in Sponza.
inline constexpr std::size_t kTrianglesOfPixel = 512, kMostWorth = 24;

/// Through how many pixels a leaf must be seen to be worth drawing, at least so many, once so many triangles are drawn.
[[nodiscard]] inline int worth_closing(int least, std::size_t triangles) {
  return std::max(least, static_cast<int>(std::min(triangles / kTrianglesOfPixel, kMostWorth)));
}

/// Where a node is in the coarse picture, and through how many pixels it is seen, as far as that matters.
struct Opening {
  CoverBuffer::Footprint footprint;
  int open;  ///< up to `enough`; any number below that where it cannot reach it, but 0 only if no pixel is open

  /// `groups` is how many have been drawn by now.
  template <class Boxes>
  Opening(const CoverBuffer& buffer, const TestedBlock<Boxes>& tested, std::size_t i, std::size_t groups, int enough)
      : footprint(buffer.footprint(tested.seen, i)) {
    // Nothing was drawn since it was found not to be hidden, so some pixel is open.
    const bool is_too_small = tested.groups == groups && footprint.size() < enough;
    open = is_too_small ? 1 : buffer.open(footprint, enough);
  }
  [[nodiscard]] bool is_hidden() const { return open == 0 && footprint.is_in_picture; }
};

}  // namespace occlude::culler
