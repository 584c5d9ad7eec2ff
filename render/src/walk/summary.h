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

/// Table 2 of the paper beside a summary.
[[nodiscard]] std::string table2_text(const nlohmann::ordered_json& summary);

/// What was chosen: the member `options`.
[[nodiscard]] nlohmann::ordered_json options_json(const WalkOptions& options, const culler::BuildConfig& build);

/// Where it was measured: the member `machine`. `renderer` is empty where nothing was drawn.
[[nodiscard]] nlohmann::ordered_json machine_json(const std::string& renderer);

/// frames.csv, a header line and a line for each frame.
[[nodiscard]] std::string frames_csv(const WalkResult& result);

}  // namespace occlude::render
