// SPDX-License-Identifier: MIT
// What of a tree, or of a scene, is idle: it neither hid anything nor was hidden when a view last looked at it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "cover/worth_of_hiding.h"

namespace occlude::culler {

/// A frame notes what it took as idle, so that it can be repeated.
class IdleSet {
 public:
  /// A frame in which nothing is idle, and from which nothing is learned.
  void begin_alone() {
    is_used_ = false;
    left_ = {};
  }
  /// The next frame of a view. After one that looks, set() says what is idle in those that save, with numbers below `size`.
  void begin_next(WorthOfHiding::Frame kind, std::size_t size) {
    begin_alone();
    if (kind == WorthOfHiding::Frame::looks) is_idle_.assign(size, false);
    is_used_ = kind == WorthOfHiding::Frame::saves;
  }
  /// A frame once more that took these.
  void begin_again(std::span<const std::uint32_t> taken) {
    is_used_ = false;
    left_ = taken;
  }

  /// Whether the frame takes this number as idle. If so, it is appended to `taken`.
  [[nodiscard]] bool take(std::uint32_t number, std::vector<std::uint32_t>& taken) {
    if (is_used_ ? number >= is_idle_.size() || !is_idle_[number] : left_.empty() || left_.front() != number) return false;
    if (!is_used_) left_ = left_.subspan(1);
    taken.push_back(number);
    return true;
  }
  void set(std::uint32_t number) { is_idle_[number] = true; }

 private:
  bool is_used_ = false;
  std::span<const std::uint32_t> left_;  ///< of those to be taken again
  std::vector<bool> is_idle_;
};

}  // namespace occlude::culler
