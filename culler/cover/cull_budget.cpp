// SPDX-License-Identifier: MIT
#include "cover/cull_budget.h"

#include <algorithm>

#include "cover/worth_drawing.h"

namespace occlude::culler {
namespace {

using Milliseconds = std::chrono::duration<double, std::milli>;

CullBudget::Clock::duration to_duration(double ms) {
  constexpr double kLongest = 1e9;  // eleven days: longer ones have no other effect
  return std::chrono::duration_cast<CullBudget::Clock::duration>(Milliseconds(ms > 0 ? std::min(ms, kLongest) : 0));
}

/// The share of the budget that is for asking what is left. Shares from a fifth to a half were tried with budgets of a
/// quarter of a millisecond to two: a half culls less nearly everywhere, the others do not differ.
constexpr std::size_t kShareOfAsking = 4;

/// What a unit of work takes: 23 ns on an AMD EPYC, and elsewhere what it has taken in the frame so far. The guess counts
/// for as much as this much work, because what a frame does first waits for memory.
constexpr double kGuess = 25e-6;
constexpr std::size_t kWorkOfGuess = 4096;

/// Milliseconds of what a frame does once its budget is spent, however large that was: it draws what is left in view, and
/// puts all in order. On an AMD EPYC that takes 0.1 ms, and 0.2 ms in the slowest frames, of which the view frustum alone
/// takes 0.04. With this, frames keep to the quarter more and the time of the view frustum that they may take, on all paths
/// tried. With 0.05, some exceed it by 0.05 ms.
constexpr double kEnd = 0.08;

}  // namespace

std::size_t triangles_of(const CoverOptions& options) {
  if (options.as_before) return options.as_before->work.triangles;
  const double timed = options.ms > 0 ? options.ms / kGuess : 0;
  const std::size_t work = timed < static_cast<double>(options.work) ? static_cast<std::size_t>(timed) : options.work;
  return work / CoverOptions::kWorkOfTriangle;
}

CullBudget::CullBudget(const CoverOptions& options, int pixels, Clock::time_point start)
    : is_timed_(options.ms != std::numeric_limits<double>::infinity() && !options.as_before),
      triangles_(triangles_of(options)),
      worth_(worth_of_budget(pixels, static_cast<double>(triangles_))),
      most_(options.work - options.work / kShareOfAsking),
      most_asking_(options.work / kShareOfAsking) {
  if (options.as_before) {
    const CoverWork& work = options.as_before->work;
    most_ = work.drawing;
    most_asking_ = work.asking;
  }
  if (!is_timed_) return;
  begin_ = Clock::now();
  const double ms = options.ms - kEnd;
  end_of_asking_ = start + to_duration(ms);
  end_ = start + to_duration(ms - ms / double{kShareOfAsking});
}

void CullBudget::begin_asking() {
  is_asking_ = true;
  drawing_ = used_;
  used_ = 0;
  most_ = most_asking_;
  end_ = end_of_asking_;
  is_spent_ = false;
  since_reading_ = kWorkOfReading;
}

/// Whether this work, with what is reserved, would take longer than the budget.
bool CullBudget::is_too_late(std::size_t work) {
  since_reading_ += work;
  if (since_reading_ < kWorkOfReading) return false;
  since_reading_ = 0;
  const Clock::time_point now = Clock::now();
  const auto done = static_cast<double>(drawing_ + used_ - std::min(reserved_, drawing_ + used_) + kWorkOfGuess);
  const double unit = (Milliseconds(now - begin_).count() + kGuess * kWorkOfGuess) / done;
  return Milliseconds(end_ - now).count() < unit * static_cast<double>(work + reserved_);
}

}  // namespace occlude::culler
