// SPDX-License-Identifier: MIT
// Assigns turns to the frames of a walk.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "occlude/render/walk.h"

namespace occlude::cli {

class Turns {
 public:
  /// REQUIRES: `frames` are in ascending order.
  explicit Turns(std::vector<std::size_t> frames) : frames_(std::move(frames)) {}

  /// The index of a frame among the frames of the walk.
  [[nodiscard]] std::size_t place(std::size_t frame) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(frames_, frame) - frames_.begin());
  }

  /// At least 48 frames spread over the walk, or all frames of a shorter walk. More is computed for these.
  [[nodiscard]] bool is_reference(std::size_t frame) const { return place(frame) % step() == 0; }

  /// Reference frames count their turns among themselves, so that they go through all of them. Other frames use their index.
  [[nodiscard]] std::size_t turn(std::size_t frame) const {
    return is_reference(frame) ? place(frame) / step() : place(frame);
  }

 private:
  [[nodiscard]] std::size_t step() const { return render::reference_step(frames_.size()); }

  std::vector<std::size_t> frames_;
};

}  // namespace occlude::cli
