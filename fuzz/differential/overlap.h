// SPDX-License-Identifier: MIT
// The kernel's main question, asked of everyone who can answer it.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "occlude/fuzz/cases.h"
#include "report.h"

namespace occlude::fuzz {

/// Puts `boxes` to the shadow of the question's occluder (the box of `question` does not count): certified and conservative,
/// one by one and in batches, near plane closed and open, plain and the rivals, against the oracle; some boxes, of the
/// seed's choice, against the second oracle too.
void judge_overlap(const Case& question, std::span<const Box> boxes, std::uint64_t seed, Report& report);

/// A case of the family and its neighbours.
void run_overlap(Family family, std::uint64_t seed, Report& report);

/// What the oracle says of one case: "inside", "partial", "outside"; empty when it refuses.
[[nodiscard]] std::string judged_answer(const Case& question);

/// The finding of this kind that the case gives by itself, if it does: what a smaller case must show too to stand for it.
[[nodiscard]] std::optional<Finding> find_again(const Case& question, const std::string& kind);

}  // namespace occlude::fuzz
