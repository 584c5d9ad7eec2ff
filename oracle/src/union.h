// SPDX-License-Identifier: MIT
// Whether two sets cover a box, each the intersection of the inner sides of planes.
#pragma once

#include "relate.h"

namespace occlude::oracle {

/// Whether every point of the box lies in one of the sets or in both.
[[nodiscard]] bool cover(const Planes& first, const Planes& second, const Box& box);

}  // namespace occlude::oracle
