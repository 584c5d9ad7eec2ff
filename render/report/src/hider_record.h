// SPDX-License-Identifier: MIT
// What one hider did on a walk: an occluder, or a piece of a cover.
#pragma once

#include <cstddef>

namespace occlude::render {

struct HiderRecord {
  std::size_t frames = 0;       ///< for which it was used
  std::size_t useless = 0;      ///< of these, in which it hid nothing
  std::size_t hidden = 0;       ///< polygons that it hid, summed over the frames
  std::size_t best_frame = 0;   ///< in which it hid most, counted from the first of the walk
  std::size_t best_hidden = 0;  ///< and how much there

  void add(std::size_t frame, std::size_t hidden_there) {
    if (hidden_there > best_hidden || frames == 0) {
      best_frame = frame;
      best_hidden = hidden_there;
    }
    ++frames;
    hidden += hidden_there;
    if (hidden_there == 0) ++useless;
  }
  [[nodiscard]] bool is_useless() const { return 2 * useless > frames; }
};

}  // namespace occlude::render
