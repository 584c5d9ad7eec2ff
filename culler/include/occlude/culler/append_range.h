// SPDX-License-Identifier: MIT
// Ranges of polygons, neighbours merged.
#pragma once

#include <vector>

#include "occlude/culler/polygon_soup.h"

namespace occlude::culler {

/// Appends a range, or makes the last one longer where it begins right after it. REQUIRES: it begins after the last one.
inline void append_range(std::vector<PolygonRange>& ranges, const PolygonRange& range) {
  if (!ranges.empty() && ranges.back().first + ranges.back().count == range.first) {
    ranges.back().count += range.count;
  } else {
    ranges.push_back(range);
  }
}

}  // namespace occlude::culler
