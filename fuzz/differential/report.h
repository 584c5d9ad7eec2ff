// SPDX-License-Identifier: MIT
// The results of a run: counts, and the cases in which something that claims to be right is wrong.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "occlude/fuzz/case.h"

namespace occlude::fuzz {

/// Wrong answers of an arithmetic that promises nothing. A wrong cull says `inside` where that is false: something visible
/// would disappear. Any other wrong answer at worst draws what is hidden.
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

/// The lines of sight that try to refute a cull.
inline constexpr std::uint64_t kLinesOfCull = 256;

struct Tally {
  std::uint64_t cases = 0;
  std::uint64_t refused = 0;                 ///< by the kernel and by the oracle
  std::array<std::uint64_t, 3> relations{};  ///< the answered cases, by kernel::Relation
  std::array<std::uint64_t, 2> stages{};     ///< by kernel::Stage
  std::uint64_t judged_twice = 0;            ///< also by the second oracle
  std::uint64_t lines_of_sight = 0;          ///< tried to refute culls, at most kLinesOfCull a case
  std::uint64_t disagreements = 0;           ///< cases with at least one finding
  std::uint64_t planes_asked = 0;            ///< boxes outside about which `conservative` was asked
  std::uint64_t undecided = 0;               ///< boxes outside for which `conservative` says partial
  std::uint64_t others_asked = 0;            ///< cases about which plain and the rivals were asked
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
  std::string kind;                ///< who was wrong about what; a smaller case must show the same
  std::string what;                ///< one line: who said what
  std::optional<Case> question{};  ///< when a case file can hold it
  std::string expect{};            ///< the oracle's answer to it
  std::string family{};            ///< together with the seed it makes the finding again
  std::uint64_t seed = 0;
};

struct Report {
  Tally tally;
  double core_seconds = 0;  ///< processor time
  std::vector<Finding> findings;
};

/// The number of findings that are kept of many reports: those with the lowest seeds.
inline constexpr std::size_t kKeptFindings = 3;

/// Sets the family and the seed of all findings.
void sign(Report& report, const std::string& family, std::uint64_t seed);

/// Adds `part` to `whole`. The sum does not depend on the order of the parts.
void add(Report& whole, Report&& part);

}  // namespace occlude::fuzz
