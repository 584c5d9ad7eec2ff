// SPDX-License-Identifier: MIT
// Tables and figures of the paper: a walk beside what the paper reports, and the spread of its figures.
#pragma once

#include <string>
#include <vector>

#include "occlude/render/summary.h"
#include "occlude/render/table.h"

namespace occlude::render {

/// Table 1: operations of a test, worst and best in the paper, mean on this walk. REQUIRES: tests were counted.
[[nodiscard]] Table table1_of(const kernel::Operations& counted);

/// Table 2: averages per frame of both methods, beside those of the paper.
[[nodiscard]] Table table2_of(const Summary& summary);

/// How the figures of single frames are spread around the means, with links to the worst frames.
[[nodiscard]] Table spread_table(const Summary& summary);

/// Figures 2 and 3, as HTML: frame time (if rendered) and polygons rendered, frame by frame.
[[nodiscard]] std::string figures_html(const std::vector<FrameRecord>& frames, bool rendered);

}  // namespace occlude::render
