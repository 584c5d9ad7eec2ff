// SPDX-License-Identifier: MIT
// Tables and figures of the paper, as HTML: a walk beside what the paper reports, and the spread of its figures.
#pragma once

#include <string>
#include <vector>

#include "occlude/render/summary.h"

namespace occlude::render {

/// Table 1: operations of a test, worst and best in the paper, mean on this walk.
[[nodiscard]] std::string table1_html(const Summary& summary);

/// Table 2: averages per frame of both methods, beside those of the paper.
[[nodiscard]] std::string table2_html(const Summary& summary);

/// How the figures of single frames are spread around the means, with links to the worst frames.
[[nodiscard]] std::string spread_html(const Summary& summary);

/// Figures 2 and 3: frame time (if rendered) and polygons rendered, frame by frame.
[[nodiscard]] std::string figures_html(const std::vector<FrameRecord>& frames, bool rendered);

}  // namespace occlude::render
