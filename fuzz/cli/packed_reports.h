// SPDX-License-Identifier: MIT
// Reports of the fuzzer as bytes, for parts of a run.
#pragma once

#include <span>
#include <string>
#include <vector>

#include "differential/campaign.h"
#include "differential/report.h"

namespace occlude::cli {

[[nodiscard]] std::string pack(const std::vector<fuzz::Report>& reports);
/// Those of this campaign of these experiments. Throws render::PartError where they cannot be.
[[nodiscard]] std::vector<fuzz::Report> unpack(const std::string& bytes, const fuzz::Campaign& campaign,
                                               std::span<const fuzz::Experiment> experiments);

}  // namespace occlude::cli
