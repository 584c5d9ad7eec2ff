// SPDX-License-Identifier: MIT
// Gives the parts of a stage to whoever asks, and puts their results in order.
#pragma once

#include <cstdint>
#include <exception>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "kept_parts.h"
#include "occlude/render/job.h"

namespace occlude::render {

/// Any thread may call any function. After a failure nothing more is dealt.
class Dealer {
 public:
  struct Part {
    std::uint64_t number = 0;
    std::string input;
  };

  /// `kept` may be null. REQUIRES: both outlive the dealer.
  Dealer(const Stage& stage, unsigned stage_number, KeptParts* kept)
      : stage_(stage), stage_number_(stage_number), kept_(kept) {}

  /// The next part that is not kept; none when all are dealt, or after a failure.
  [[nodiscard]] std::optional<Part> next();
  /// The result of a part that next() gave, by a rank.
  void accept(std::uint64_t number, const std::string& result, std::size_t rank);
  void fail(std::exception_ptr failure);

  /// Throws the first failure. Call this when all parts that were dealt are accepted.
  void finish();

 private:
  struct Result {
    std::string bytes, place;  ///< where the bytes are from
  };

  std::optional<Part> next_not_kept();
  void take(std::uint64_t number, Result result);
  /// Calls work() unless something failed; what it throws is the failure.
  template <class Work>
  void attempt(Work&& work);

  const Stage& stage_;
  unsigned stage_number_;
  KeptParts* kept_;
  std::mutex mutex_;
  std::exception_ptr failure_;
  std::uint64_t dealt_ = 0, taken_ = 0;
  std::map<std::uint64_t, std::string> inputs_;  ///< of parts under way; empty unless parts are kept
  std::map<std::uint64_t, Result> waiting_;      ///< results for which an earlier one is missing
};

}  // namespace occlude::render
