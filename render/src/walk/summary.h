// SPDX-License-Identifier: MIT
// The figures of a walk: means over its frames, as JSON, CSV and text.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "occlude/render/walk_summary.h"

namespace occlude::render {

/// summary.json. Members that need pictures are null when the walk did not render.
[[nodiscard]] nlohmann::ordered_json summarise(const WalkResult& result, const WalkOptions& options,
                                               const std::string& model);

/// frames.csv, a header line and a line for each frame.
[[nodiscard]] std::string frames_csv(const WalkResult& result);

}  // namespace occlude::render
