// SPDX-License-Identifier: MIT
// Processor time; other programs' work does not count.
#pragma once

#include <ctime>

#include "occlude/render/stopwatch.h"

namespace occlude::render {

/// Since construction.
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

/// What some work took by the clock, and of the processor by all threads of the program: less, where others had it
/// meanwhile.
struct Took {
  double ms = 0, processor_ms = 0;
};

template <class Work>
[[nodiscard]] Took took(const Work& work) {
  const ProcessorTime processor(ProcessorTime::Of::process);  // which takes longer to ask for than the clock
  const Stopwatch clock;
  work();
  const double ms = clock.milliseconds();
  return {ms, processor.milliseconds()};
}

}  // namespace occlude::render
