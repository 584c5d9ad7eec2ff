// SPDX-License-Identifier: MIT
// Reports of the fuzzer as bytes, for parts of a run.
#pragma once

#include <string>
#include <vector>

#include "differential/report.h"

namespace occlude::cli {

[[nodiscard]] std::string pack(const std::vector<fuzz::Report>& reports);
[[nodiscard]] std::vector<fuzz::Report> unpack(const std::string& bytes);

}  // namespace occlude::cli
