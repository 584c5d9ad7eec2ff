// SPDX-License-Identifier: MIT
// Whether a triangle lies on others.
#pragma once

#include <span>
#include <string>

#include "occlude/oracle/visibility.h"

namespace occlude::oracle {

/// Proves, in rational numbers, that each point of `triangle` is a point of those of the `faces` that lie in its plane and
/// turn the same way: nothing is left of it once they are cut out. One without area must be one of the faces, corner for
/// corner. Returns an empty string, else what failed. REQUIRES: finite numbers.
[[nodiscard]] std::string refute_on_faces(std::span<const Triangle> faces, const Triangle& triangle);

}  // namespace occlude::oracle
