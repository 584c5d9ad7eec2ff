// SPDX-License-Identifier: MIT
// How much of what is hidden in some views each polygon hides.
#pragma once

#include <span>
#include <vector>

#include "occlude/culler/camera.h"
#include "occlude/culler/executor.h"
#include "occlude/culler/polygon_soup.h"

namespace occlude::culler {

/// Of each polygon of the soup, its shares of how many polygons are hidden, summed over the views; 0 if none needs it. What
/// hides a box together has equal shares: without any one of them the box shows. That is how the worth of what takes all of
/// a group is shared out (Shapley 1953). It is a heuristic: others, farther behind, might do instead. Takes a few times as
/// long as to cull the frames. REQUIRES: a legal soup, cameras without a fault().
[[nodiscard]] std::vector<double> shares_of_hiding(PolygonSoup soup, std::span<const Camera> views,
                                                   const Checkpoint& checkpoint);

}  // namespace occlude::culler
