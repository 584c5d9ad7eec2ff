// SPDX-License-Identifier: MIT
// The sort of section 4.2: what last frame's order saves against sorting each frame anew.
#pragma once

#include <optional>
#include <vector>

#include "setting.h"

namespace occlude::experiments {

/// At one threshold of the lists, and so for one number of candidates. Means over the frames but the first. Where the
/// insertion sort gives up, for the camera jumped, and sorts anew, only what it did until then is counted.
struct SortPoint {
  double threshold = 0;    ///< steradians
  double candidates = 0;   ///< listed and in view
  double arrivals = 0;     ///< those of them that were none in the frame before; they are sorted among themselves and merged
  double moves = 0;        ///< places by which the insertion sort moves the others, all together
  double comparisons = 0;  ///< of all of it: one more than moves for each other, the arrivals', one each for the merge
  double comparisons_anew = 0;  ///< of std::sort on all candidates, from the order of the list
};

struct Sorting {
  std::vector<SortPoint> points;
  /// Of these totals with the number of candidates: 1 is linear. None where something was never done.
  std::optional<double> moves_exponent, comparisons_exponent, anew_exponent;
};

[[nodiscard]] Sorting measure_sorting(const Subject& subject, const Options& options);

}  // namespace occlude::experiments
