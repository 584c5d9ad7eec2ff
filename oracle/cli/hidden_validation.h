// SPDX-License-Identifier: MIT
// Proves a file of `occlude bake --witness` or `occlude prune --witness`.
#pragma once

#include <cstddef>
#include <string>

#include "occlude/culler/hierarchy.h"
#include "occlude/render/job.h"
#include "witness_file.h"

namespace occlude::cli {

struct HiddenValidation {
  std::size_t witnesses = 0, proved_witnesses = 0;
  std::size_t pairs = 0, proved_pairs = 0;  ///< of a box, or of outside, and a polygon that is claimed to be hidden from it
  std::string line_fault, claim_fault;      ///< what the first is that fails, of lines and of claims, with its place
};

[[nodiscard]] bool passed(const HiddenValidation& validation);
[[nodiscard]] std::string to_text(const HiddenValidation& validation);
[[nodiscard]] std::string to_json(const HiddenValidation& validation);

/// Proves all lines of the file, and what they claim. Throws InputError for a line that is neither a claim nor a witness.
[[nodiscard]] HiddenValidation validate_hidden(render::Job& job, const culler::Hierarchy& hierarchy, WitnessFile& file);

}  // namespace occlude::cli
