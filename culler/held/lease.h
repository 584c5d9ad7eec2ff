// SPDX-License-Identifier: MIT
// For how long regions should hold, and whether they are worth their time.
#pragma once

#include <algorithm>
#include <cstddef>

namespace occlude::culler {

class Lease {
 public:
  /// For how long the next region should hold, of one picture or of six, with frames of this length. It holds for so many
  /// frames that it takes half of their time by point, or less.
  [[nodiscard]] double seconds(bool is_around, double frame_seconds) const {
    return std::max(seconds_, 2 * (is_around ? cost_around_ : cost_) * frame_seconds);
  }
  /// Whether what the last region hid made it longer or shorter.
  [[nodiscard]] bool has_changed() const { return has_changed_; }
  /// Whether regions are tried at this time.
  [[nodiscard]] bool pays(double now) const { return now >= rests_until_; }

  /// What the last region hid, as a share of what a frame by point hid there and then.
  void hid(double share, double now);
  /// How many frames by point take as long as a region.
  void cost(bool is_around, double frames) { (is_around ? cost_around_ : cost_) = frames; }
  /// A region that should have held for `lease` was left behind after so many seconds, when so many frames had used it.
  void held(double seconds, double lease, bool is_around, std::size_t frames, double now);

 private:
  static constexpr double kShortestRest = 1.0 / 8;

  void rest(double now);

  double seconds_ = 0.25;
  double cost_ = 4, cost_around_ = 16;  ///< until they are known
  bool has_changed_ = true;
  double rests_until_ = -1e300;
  double rest_ = kShortestRest;  ///< how long the next one is
  bool lost_ = false;            ///< the last region took longer than the frames that used it would have taken by point
};

}  // namespace occlude::culler
