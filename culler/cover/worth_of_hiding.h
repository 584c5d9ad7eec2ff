// SPDX-License-Identifier: MIT
// Whether it pays to look for what is hidden, by what the frames of a view have found.
#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#include "occlude/culler/cull_result.h"

namespace occlude::culler {

/// Where frames find that less than a quarter of what is in view is hidden, the next ones look less. Where all is drawn,
/// that costs at most a third more than without what is hidden. It decides how much is culled, never whether it may be, and
/// depends on the frames alone, not on time.
class WorthOfHiding {
 public:
  /// The options of the next frame: with no more work than it is worth.
  [[nodiscard]] CoverOptions limited(CoverOptions options) const {
    options.work = std::min(options.work, work());
    return options;
  }
  /// What the next frame may spend (CoverOptions::work).
  [[nodiscard]] std::size_t work() const {
    if (pays()) return std::numeric_limits<std::size_t>::max();
    if (!tries()) return kLeastWork;
    return tries_ == kMostTries ? std::numeric_limits<std::size_t>::max() : kWorkOfTry << tries_;
  }

  /// Learns how many polygons, or objects, that frame has hidden and drawn.
  void learn(std::size_t hidden, std::size_t drawn) {
    const auto all = static_cast<double>(hidden + drawn);
    const double share = all > 0 ? static_cast<double>(hidden) / all : 1;
    if (pays()) {
      share_ += (share - share_) / kFrames;
    } else if (share >= kLeastShare) {
      *this = {};
    } else if (tries()) {
      frames_ = 0;
      tries_ = std::min(tries_ + 1, kMostTries);
    } else {
      ++frames_;
    }
  }

 private:
  static constexpr double kLeastShare = 0.25;
  /// The share before the first frame. With this a view takes some twenty frames to find that hiding does not pay.
  static constexpr double kDoubt = 0.5;
  /// The share is that of about so many frames, so that a few in which little is hidden change nothing: of the paths through
  /// Sponza, where up to sixty in a row hide less than a quarter, all is culled as ever.
  static constexpr std::size_t kFrames = 32;
  /// 0.3 ms on an AMD EPYC, in which half of what is hidden in a street is found.
  static constexpr std::size_t kLeastWork = 12288;
  /// After kFrames such frames, one looks more, with work that takes 2 ms there. If that does not pay either, another one
  /// tries twice as much after twice as many frames. The fourth looks as far as ever, and so does one in 256 after it.
  static constexpr std::size_t kWorkOfTry = 8 * kLeastWork, kMostTries = 3;

  [[nodiscard]] bool pays() const { return share_ >= kLeastShare; }
  [[nodiscard]] bool tries() const { return frames_ + 1 == kFrames << tries_; }

  double share_ = kDoubt;
  // Since it does not pay:
  std::size_t tries_ = 0, frames_ = 0;  ///< frames since the last of them
};

}  // namespace occlude::culler
