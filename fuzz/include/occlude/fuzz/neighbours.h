// SPDX-License-Identifier: MIT
// Boxes near a box: touching much of what it touches, or missing it by the least there is.
#pragma once

#include <cstdint>

#include "occlude/fuzz/case.h"

namespace occlude::fuzz {

/// The same box for the same arguments, on every machine. One to three changes: a bound or half edge moved to the next
/// double, or by one unit of the coarsest grid of powers of two that holds the box; a side collapsed, halved or doubled; the
/// box slid along itself. It may leave the legal range.
[[nodiscard]] Box neighbour(const Box& box, std::uint64_t seed);

}  // namespace occlude::fuzz
