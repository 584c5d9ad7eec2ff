// SPDX-License-Identifier: MIT
// Whether two triangles have no point in common.
#pragma once

#include "frusta/solid.h"

namespace occlude::culler {

/// True only if the triangles have no point in common, exactly. It may be false of triangles that are apart, if four of
/// their corners lie in a plane. REQUIRES: legal corners.
[[nodiscard]] bool are_apart(const SolidTriangle& a, const SolidTriangle& b);

}  // namespace occlude::culler
