// SPDX-License-Identifier: MIT
// Work in parts. Whoever is free takes the next part: this process, or the ranks of mpirun. The results come back in the
// order of the parts, so they are the same for any number of ranks. Finished parts may be kept on disk.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>

namespace occlude::render {

class KeptParts;

/// Parts of one kind.
struct Stage {
  /// The input of the next part; none after the last one. Called on the first rank, one call at a time.
  std::function<std::optional<std::string>()> next;
  /// The result for an input. Called on the main thread of any rank, on each rank in the order of the parts.
  std::function<std::string(const std::string& input)> work;
  /// Takes the results in the order of the parts. Called as next() is, and never at the same time. A result may come from
  /// another process or from disk: throws PartError unless it can be that of its input.
  std::function<void(const std::string& result)> take;
};

/// Where finished parts are kept, and whether to go on with those that are there.
struct Keeping {
  std::string folder;  ///< empty: nowhere
  bool resume = false;
};

class Job {
 public:
  /// `key` tells jobs apart, by all that their results depend on beside the inputs of the parts. It is called only if parts
  /// are kept or there are several ranks. Throws InputError for a folder that cannot be used, has parts of another job, or
  /// has parts and is not to be resumed, and if the user's key that seals parts cannot be read or made.
  Job(const Keeping& keeping, const std::function<std::uint64_t()>& key);
  ~Job();
  Job(const Job&) = delete;
  Job& operator=(const Job&) = delete;

  /// Does all parts of a stage. Every rank calls it for the same stages; on helpers it only works. Throws what the functions
  /// of the stage throw, InputError for a helper that fails, and Interrupted, after saying which parts are kept.
  void run(const Stage& stage);

  /// Removes the parts that were kept. Call this once the results are written.
  void finish();

 private:
  void run_first(const Stage& stage, unsigned number);

  std::uint64_t key_ = 0;
  unsigned stages_ = 0;
  std::unique_ptr<KeptParts> kept_;
};

}  // namespace occlude::render
