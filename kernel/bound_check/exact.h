// SPDX-License-Identifier: MIT
// Exact numbers, and the roundoff of doubles.
#pragma once

#include <CGAL/Exact_rational.h>

#include <limits>

namespace occlude::bound_check {

using Exact = CGAL::Exact_rational;

/// The relative error of an operation on doubles is at most this.
inline const Exact kRoundoff = Exact(std::numeric_limits<double>::epsilon()) / 2;

}  // namespace occlude::bound_check
