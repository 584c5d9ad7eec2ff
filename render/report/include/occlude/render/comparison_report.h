// SPDX-License-Identifier: MIT
// Two walks side by side as text, JSON and a page.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "occlude/render/paint.h"
#include "occlude/render/walk_comparison.h"

namespace occlude::render {

[[nodiscard]] std::string text_of(const WalkComparison& comparison, const Paint& paint = {});
[[nodiscard]] nlohmann::ordered_json json_of(const WalkComparison& comparison);

/// The table, and the curves of both if both have a frames.csv.
[[nodiscard]] std::string comparison_page(const WalkComparison& comparison);

}  // namespace occlude::render
