// SPDX-License-Identifier: MIT
// Neighbours of a box. They touch much of what the box touches, or miss it by the smallest possible amount.
#pragma once

#include <cstdint>

#include "occlude/fuzz/case.h"

namespace occlude::fuzz {

/// Makes one to three changes to the box: moves a bound or half edge to the next double, or by one unit of the coarsest grid
/// of powers of two that holds the box; collapses, halves or doubles a side; slides the box along itself. The same arguments
/// give the same box on every machine. The box may leave the legal range.
[[nodiscard]] Box neighbour(const Box& box, std::uint64_t seed);

}  // namespace occlude::fuzz
