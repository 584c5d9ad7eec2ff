// SPDX-License-Identifier: MIT
// What a walk found, for people and for programs.
#pragma once

#include <string>

#include "occlude/render/walk.h"

namespace occlude::render {

/// The text of summary.json.
[[nodiscard]] std::string summary_json(const WalkResult& result, const WalkOptions& options, const std::string& model);

/// Table 2 of the paper beside this run, and the checks.
[[nodiscard]] std::string summary_text(const WalkResult& result, const WalkOptions& options, const std::string& model);

/// Whether no visible polygon was culled and every differing pixel is explained by the renderer's rounding.
[[nodiscard]] bool passed(const WalkResult& result);

}  // namespace occlude::render
