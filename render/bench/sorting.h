// SPDX-License-Identifier: MIT
// The sort of section 4.2: the savings of starting from the previous frame's order, against sorting from scratch.
#pragma once

#include <optional>
#include <vector>

#include "setting.h"

namespace occlude::experiments {

/// At one threshold of the lists, and so for one number of candidates. Means over the frames except the first. Only the
/// candidates that a frame asks for are sorted, and a few more.
struct SortPoint {
  double threshold = 0;         ///< steradians
  double candidates = 0;        ///< listed and in view
  double arrivals = 0;          ///< not candidates in the previous frame
  double moves = 0;             ///< total places by which the insertion sort moves those that were sorted in that frame
  double comparisons = 0;       ///< of the whole: one per candidate to find the good ones, and those of their sort
  double comparisons_anew = 0;  ///< of std::sort on all candidates, from the order of the list
};

struct Sorting {
  std::vector<SortPoint> points;
  /// Of these totals over the number of candidates; 1 is linear. Empty if a total was always 0.
  std::optional<double> moves_exponent, comparisons_exponent, anew_exponent;
};

[[nodiscard]] Sorting measure_sorting(const Subject& subject, const Options& options);

}  // namespace occlude::experiments
