// SPDX-License-Identifier: MIT
// Processor time since construction; other programs' work does not count.
#pragma once

#include <ctime>

namespace occlude::experiments {

class ProcessorTime {
 public:
  enum class Of { thread, process };  ///< the calling thread, or all threads of the program

  explicit ProcessorTime(Of of) : clock_(of == Of::thread ? CLOCK_THREAD_CPUTIME_ID : CLOCK_PROCESS_CPUTIME_ID) {}

  [[nodiscard]] double milliseconds() const { return now() - start_; }

 private:
  [[nodiscard]] double now() const {
    std::timespec time{};
    clock_gettime(clock_, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
  }

  clockid_t clock_;
  double start_ = now();
};

}  // namespace occlude::experiments
