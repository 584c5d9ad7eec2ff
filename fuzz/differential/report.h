// SPDX-License-Identifier: MIT
// What a run of cases found: counts, and the cases on which somebody who claims to be right is wrong.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "occlude/fuzz/case.h"

namespace occlude::fuzz {

/// Wrong answers of an arithmetic that makes no promise. A wrong cull says `inside` of what is not: something visible
/// disappears. Any other wrong answer at worst draws what is hidden.
struct WrongAnswers {
  std::uint64_t culls = 0, draws = 0;

  void count(kernel::Relation answer, kernel::Relation truth) {
    if (answer != truth) ++(answer == kernel::Relation::inside ? culls : draws);
  }
  WrongAnswers& operator+=(const WrongAnswers& other) {
    culls += other.culls;
    draws += other.draws;
    return *this;
  }
  friend bool operator==(const WrongAnswers&, const WrongAnswers&) = default;
};

struct Tally {
  std::uint64_t cases = 0;
  std::uint64_t refused = 0;                 ///< by the kernel and by the oracle
  std::array<std::uint64_t, 3> relations{};  ///< as in kernel::Relation; of answered cases
  std::array<std::uint64_t, 2> stages{};     ///< as in kernel::Stage
  std::uint64_t judged_twice = 0;            ///< by the second oracle as well
  std::uint64_t disagreements = 0;           ///< cases with one finding or more
  std::uint64_t planes_asked = 0;            ///< boxes outside that `conservative` was asked of
  std::uint64_t undecided = 0;               ///< `conservative` says partial of a box that is outside
  std::uint64_t others_asked = 0;            ///< cases that plain and the rivals were asked
  WrongAnswers plain, float32, fused;

  void count(kernel::Relation truth, kernel::Stage stage) {
    ++relations[static_cast<std::size_t>(truth)];
    ++stages[static_cast<std::size_t>(stage)];
  }
  Tally& operator+=(const Tally& other);
  friend bool operator==(const Tally&, const Tally&) = default;
};

/// A disagreement, and how to make it again.
struct Finding {
  std::string kind;                ///< who was wrong about what: a smaller case must show the same
  std::string what;                ///< one line: who said what
  std::optional<Case> question{};  ///< where it is one that a case file can hold
  std::string expect{};            ///< the oracle's answer to it
  std::string family{};            ///< it and the seed make the finding again; whoever ran the cases knows them
  std::uint64_t seed = 0;
};

struct Report {
  Tally tally;
  double core_seconds = 0;  ///< processor time
  std::vector<Finding> findings;
};

/// Findings kept of many reports: those of the lowest seeds.
inline constexpr std::size_t kKeptFindings = 3;

/// Says of each finding where it comes from.
void sign(Report& report, const std::string& family, std::uint64_t seed);

/// Adds `part` to `whole`, in whatever order parts come.
void add(Report& whole, Report&& part);

}  // namespace occlude::fuzz
