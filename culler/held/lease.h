// SPDX-License-Identifier: MIT
// For how long regions should hold, and whether they are worth their time.
#pragma once

#include <cstddef>

namespace occlude::culler {

class Lease {
 public:
  /// A cull of one picture for a region takes as long as about four frames by point, and of six pictures as sixteen. A
  /// region must hold for twice as many frames.
  static constexpr double kFramesOfOne = 8, kFramesAround = 32;

  /// For how long the next region should hold.
  [[nodiscard]] double seconds() const { return seconds_; }
  /// Whether regions are tried at this time.
  [[nodiscard]] bool pays(double now) const { return now >= rests_until_; }

  /// What the last region hid, as a share of what a frame by point hid there and then.
  void hid(double share, double now);
  /// A region was left behind so long after it was asked for, though the lease was longer.
  void held(double seconds, double lease);

 private:
  void rest(double now);

  double seconds_ = 1;
  double rests_until_ = -1e300;
  double rest_ = 1;  ///< how long the next one is
};

}  // namespace occlude::culler
