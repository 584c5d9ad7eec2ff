// SPDX-License-Identifier: MIT
// On which threads work is done. Reading order: 1.
#pragma once

#include <cstddef>
#include <functional>

namespace occlude::culler {

/// Runs parts of a piece of work, on threads of the caller if wished: a job system, oneTBB, or the calling thread alone. The
/// results of this library do not depend on it.
class Executor {
 public:
  /// Work calls of one part. It never throws, and may run on any thread.
  using Part = std::function<void(std::size_t)>;
  /// Calls part(0), …, part(count - 1), each once, in any order and on any threads, at once or one after another. Returns
  /// when all have returned.
  using Run = std::function<void(std::size_t count, const Part& part)>;

  /// More than machines have, and few enough to be multiplied.
  static constexpr std::size_t kMostThreads = 65536;

  /// The calling thread alone.
  Executor() = default;
  /// `threads` is how many parts `run` can run at once. Work is divided into about so many. REQUIRES: `run` is not empty;
  /// 0 < threads <= kMostThreads.
  Executor(std::size_t threads, Run run);
  /// A thread for each processor, or as many as the system can start. They are started for each piece of work, so they are
  /// for long work only.
  [[nodiscard]] static Executor own_threads();
  /// The same with so many threads, the calling one among them. REQUIRES: 0 < threads <= kMostThreads.
  [[nodiscard]] static Executor own_threads(std::size_t threads);

  [[nodiscard]] std::size_t threads() const { return threads_; }
  /// Does what Run says. What `run` throws is thrown on.
  void run(std::size_t count, const Part& part) const;

 private:
  std::size_t threads_ = 1;
  Run run_;
};

}  // namespace occlude::culler
