// SPDX-License-Identifier: MIT
// The culler's own ways: the view frustum alone, shadow frusta, joined shadows.
#pragma once

#include <vector>

#include "setting.h"
#include "visibility_way.h"

namespace occlude::experiments {

inline constexpr const char* kOurs = "occlude";  ///< the project
inline constexpr const char *kViewFrustumAlone = "view frustum alone", *kByFrusta = "occlude, shadow frusta",
                            *kByCover = "occlude, joined shadows";

/// In the order of the names above. `walk` has their tree and their options, except the method. Both arguments must outlive
/// what is prepared.
[[nodiscard]] std::vector<UnpreparedWay> own_ways(const Subject& subject, const render::WalkOptions& walk);

}  // namespace occlude::experiments
