// SPDX-License-Identifier: MIT
// What the experiments found, for people and for programs.
#pragma once

#include <string>

#include "experiments.h"

namespace occlude::experiments {

[[nodiscard]] std::string report_text(const Result& result, const Options& options);

/// One object; experiments that were not made, and what could not be measured, are null.
[[nodiscard]] std::string report_json(const Result& result, const Options& options);

/// One page without scripts or outside addresses.
[[nodiscard]] std::string report_html(const Result& result, const Options& options);

}  // namespace occlude::experiments
