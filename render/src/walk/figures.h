// SPDX-License-Identifier: MIT
// Table 2 and figures 2 and 3 of the paper, as HTML.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "occlude/render/walk.h"

namespace occlude::render {

/// Averages per frame of both methods, beside the paper's.
[[nodiscard]] std::string table2_html(const nlohmann::ordered_json& summary);

/// Frame time, if rendered, and polygons rendered, frame by frame.
[[nodiscard]] std::string figures_html(const WalkResult& result, bool rendered);

}  // namespace occlude::render
