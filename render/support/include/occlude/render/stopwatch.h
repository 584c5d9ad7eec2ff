// SPDX-License-Identifier: MIT
// Elapsed time by the monotonic clock.
#pragma once

#include <chrono>

namespace occlude::render {

class Stopwatch {
 public:
  [[nodiscard]] double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  [[nodiscard]] double milliseconds() const { return 1000 * seconds(); }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point start_ = Clock::now();
};

}  // namespace occlude::render
