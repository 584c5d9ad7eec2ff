// SPDX-License-Identifier: MIT
// Asks the kernel's main question of everyone who can answer it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "occlude/fuzz/cases.h"
#include "report.h"

namespace occlude::fuzz {

/// Compares the answers about `boxes` and the shadow of the question's occluder with the oracle: certified and conservative,
/// one by one and in batches, with near planes closed and open, plain and the rivals. Some boxes, which the seed chooses,
/// are asked of the second oracle too. The box of `question` is not used.
void judge_overlap(const Case& question, std::span<const Box> boxes, std::uint64_t seed, Report& report);

/// Judges a case of the family and its neighbours.
void run_overlap(Family family, std::uint64_t seed, Report& report);

/// The oracle's answer to one case: "inside", "partial", "outside". Empty when it refuses.
[[nodiscard]] std::string judged_answer(const Case& question);

/// The finding of this kind that the case gives alone, if it gives one. A smaller case must give the same kind to replace
/// it.
[[nodiscard]] std::optional<Finding> find_again(const Case& question, const std::string& kind);

}  // namespace occlude::fuzz
