// SPDX-License-Identifier: MIT
// The same trouble with less: fewer vertices, shorter numbers.
#pragma once

#include <functional>

#include "occlude/fuzz/case.h"

namespace occlude::fuzz {

/// A case for which `shows` holds, smaller by steps as long as one succeeds or a number of tries is used up: a vertex left
/// out, or cut off a polytope; the scene moved so that the viewpoint or another point is the origin; a coordinate made zero,
/// rounded to a whole number or to fewer bits. REQUIRES: shows(question).
[[nodiscard]] Case minimise(Case question, const std::function<bool(const Case&)>& shows);

}  // namespace occlude::fuzz
