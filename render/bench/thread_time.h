// SPDX-License-Identifier: MIT
// Processor time of the calling thread; other work of the machine does not count.
#pragma once

#include <ctime>

namespace occlude::experiments {

class ThreadTime {
 public:
  [[nodiscard]] double milliseconds() const { return now() - start_; }

 private:
  [[nodiscard]] static double now() {
    std::timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
  }

  double start_ = now();
};

}  // namespace occlude::experiments
