// SPDX-License-Identifier: MIT
// The report of a walk as one HTML page without scripts or external addresses. Its plates are files beside it.
#pragma once

#include <string>
#include <vector>

#include "occlude/render/summary.h"

namespace occlude::render {

[[nodiscard]] std::string walk_page(const Summary& summary, const std::vector<FrameRecord>& frames,
                                    const std::vector<Plate>& plates);

/// Table 2: averages per frame of both methods, beside those of the paper.
[[nodiscard]] std::string table2_html(const Summary& summary);

/// Figures 2 and 3: frame time (if rendered) and polygons rendered, frame by frame.
[[nodiscard]] std::string figures_html(const std::vector<FrameRecord>& frames, bool rendered);

}  // namespace occlude::render
