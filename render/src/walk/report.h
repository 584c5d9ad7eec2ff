// SPDX-License-Identifier: MIT
// report.html: one page without scripts or outside addresses; plates lie beside it.
#pragma once

#include <nlohmann/json.hpp>
#include <string>

#include "occlude/render/walk.h"

namespace occlude::render {

[[nodiscard]] std::string report_html(const WalkResult& result, const nlohmann::ordered_json& summary);

}  // namespace occlude::render
