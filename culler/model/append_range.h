// SPDX-License-Identifier: MIT
// Ranges of polygons, neighbours merged.
#pragma once

#include <vector>

#include "occlude/culler/polygon_soup.h"

namespace occlude::culler {

/// Appends `range`. If it begins where the last range ends, extends the last range instead.
/// REQUIRES: `range` does not begin before the end of the last range.
inline void append_range(std::vector<PolygonRange>& ranges, const PolygonRange& range) {
  if (!ranges.empty() && ranges.back().first + ranges.back().count == range.first) {
    ranges.back().count += range.count;
  } else {
    ranges.push_back(range);
  }
}

}  // namespace occlude::culler
