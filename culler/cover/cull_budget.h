// SPDX-License-Identifier: MIT
// What a frame by cover may still do.
//
// On its way from front to back, a frame draws what it sees and asks what may be hidden. Once three quarters of the budget
// are spent, it draws no more. The rest is spent on asking what is left, and what is left after that is drawn as far as it
// is in view.
#pragma once

#include <chrono>
#include <cstddef>
#include <limits>

#include "occlude/culler/cull_result.h"

namespace occlude::culler {

/// The work that is left to do at the end for a leaf that is seen, which is asked again, and for one that is kept to be
/// drawn: both are put in order. With less, frames take longer than their budget: by a fifth of 1 ms above a landscape.
inline constexpr std::size_t kWorkOfSeen = 3, kWorkOfKept = 1;

/// How many triangles a frame could draw with its budget.
[[nodiscard]] std::size_t triangles_of(const CoverOptions& options);

/// Work is counted as CoverOptions::work says.
class CullBudget {
 public:
  using Clock = std::chrono::steady_clock;

  /// One that has no end.
  CullBudget() = default;
  /// Of a frame whose picture has so many pixels. Time counts from `start`, when the frame began. Work begins now.
  CullBudget(const CoverOptions& options, int pixels, Clock::time_point start);

  /// Spends so much if it is left. Otherwise nothing is left from here on.
  bool spend(std::size_t work) {
    if (is_spent_) return false;
    is_spent_ = work > left() || (is_timed_ && is_too_late(work));
    if (is_spent_) return false;
    used_ += work;
    return true;
  }
  /// Counts what is done anyway, now or at the end of the frame.
  void add(std::size_t work) {
    if (!is_spent_) used_ += work;
  }
  void reserve(std::size_t work) {
    add(work);
    reserved_ += work;
  }
  [[nodiscard]] bool is_spent() const { return is_spent_; }

  /// Ends drawing. What is left of the budget is for asking.
  void begin_asking();

  /// What was spent. A frame as_before with it is the same.
  [[nodiscard]] CoverWork work() const {
    return is_asking_ ? CoverWork{drawing_, used_, triangles_} : CoverWork{used_, 0, triangles_};
  }
  /// Through how many pixels a leaf must be seen to be worth drawing.
  [[nodiscard]] int worth() const { return worth_; }

 private:
  static constexpr std::size_t kNoLimit = std::numeric_limits<std::size_t>::max();
  /// The clock is read again after so much work, about 1.5 microseconds, of which the reading takes a fiftieth.
  static constexpr std::size_t kWorkOfReading = 64;

  [[nodiscard]] std::size_t left() const { return used_ < most_ ? most_ - used_ : 0; }
  bool is_too_late(std::size_t work);

  bool is_timed_ = false, is_spent_ = false, is_asking_ = false;
  std::size_t triangles_ = kNoLimit;
  int worth_ = 0;
  std::size_t most_ = kNoLimit, most_asking_ = kNoLimit;
  std::size_t used_ = 0;                        ///< for drawing, or for asking
  std::size_t drawing_ = 0;                     ///< what was used for it, when asking has begun
  std::size_t reserved_ = 0;                    ///< what will be done at the end
  std::size_t since_reading_ = kWorkOfReading;  ///< of the clock
  Clock::time_point begin_, end_, end_of_asking_;
};

}  // namespace occlude::culler
