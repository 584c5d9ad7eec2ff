// SPDX-License-Identifier: MIT
// Makes a finding smaller: fewer vertices, shorter numbers.
#pragma once

#include <functional>

#include "occlude/fuzz/case.h"

namespace occlude::fuzz {

/// A smaller case for which `shows` is true. It is found by steps, until no step succeeds or a number of tries is used up. A
/// step leaves out a vertex, or cuts it off a polytope; moves the scene so that the viewpoint or another point becomes the
/// origin; makes a coordinate zero; or rounds it to an integer or to fewer bits. REQUIRES: shows(question).
[[nodiscard]] Case minimise(Case question, const std::function<bool(const Case&)>& shows);

}  // namespace occlude::fuzz
