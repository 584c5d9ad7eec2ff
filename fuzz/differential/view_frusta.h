// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

#include "report.h"

namespace occlude::fuzz {

/// Compares boxes with half-spaces, one and many (kernel/half_space.h, kernel/view_frustum.h): the planes of a shadow
/// frustum as doubles, and perhaps a far plane.
void run_view_frusta(std::uint64_t seed, Report& report);

}  // namespace occlude::fuzz
