// SPDX-License-Identifier: MIT
// On which threads work is done, and how a caller stops what takes seconds. Reading order: 1.
#pragma once

#include <concepts>
#include <cstddef>
#include <functional>
#include <type_traits>
#include <utility>

namespace occlude::culler {

/// Runs parts of a piece of work, on threads of the caller if wished: a job system, oneTBB, or the calling thread alone. The
/// results of this library do not depend on it.
class Executor {
 public:
  /// One part of the work, called with its number. It never throws, and may run on any thread.
  using Part = std::function<void(std::size_t)>;
  /// Calls part(0), …, part(count - 1), each once, in any order and on any threads, at once or one after another. Returns
  /// when all have returned.
  using Run = std::function<void(std::size_t count, const Part& part)>;

  /// More than machines have, and few enough that products of two do not overflow.
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

/// A function of the caller that long work calls every few milliseconds, on any of its threads and on several at once. What
/// it throws stops the work and is thrown on to the caller. So an engine cancels loading by throwing.
class Checkpoint {
 public:
  /// Calls nothing, and works on all processors.
  Checkpoint() = default;
  template <std::invocable Call>
  requires(!std::same_as<std::remove_cvref_t<Call>, Checkpoint>) Checkpoint(Call&& call)
      : call_(std::forward<Call>(call)) {}  // NOLINT: any call is one
  /// Calls nothing, and works by this executor.
  explicit Checkpoint(Executor executor) : executor_(std::move(executor)) {}
  template <std::invocable Call>
  Checkpoint(Call&& call, Executor executor) : call_(std::forward<Call>(call)), executor_(std::move(executor)) {}

  void operator()() const {
    if (call_) call_();
  }
  /// For step i of a loop of short steps: calls the function once in 2^14 steps, beginning with step 0.
  void at(std::size_t i) const {
    constexpr std::size_t kSteps = std::size_t{1} << 14U;  // each takes microseconds at most
    if (i % kSteps == 0) (*this)();
  }

  [[nodiscard]] const Executor& executor() const { return executor_; }

 private:
  std::function<void()> call_;
  Executor executor_ = Executor::own_threads();
};

}  // namespace occlude::culler
