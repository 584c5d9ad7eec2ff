// SPDX-License-Identifier: MIT
// How a walk's frames take turns, whatever part of them one run has.
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "occlude/render/walk.h"

namespace occlude::cli {

class Turns {
 public:
  /// `frames` ascend.
  explicit Turns(std::vector<std::size_t> frames) : frames_(std::move(frames)) {}

  /// The place of a frame in the walk.
  [[nodiscard]] std::size_t place(std::size_t frame) const {
    return static_cast<std::size_t>(std::ranges::lower_bound(frames_, frame) - frames_.begin());
  }

  /// About 48 frames, spread over the walk, of which more is asked.
  [[nodiscard]] bool is_reference(std::size_t frame) const { return place(frame) % step() == 0; }

  /// Reference frames take turns among themselves, so that they meet all there is; the others by their place.
  [[nodiscard]] std::size_t turn(std::size_t frame) const {
    return is_reference(frame) ? place(frame) / step() : place(frame);
  }

 private:
  [[nodiscard]] std::size_t step() const { return render::reference_step(frames_.size()); }

  std::vector<std::size_t> frames_;
};

}  // namespace occlude::cli
