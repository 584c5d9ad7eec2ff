// SPDX-License-Identifier: MIT
// How much of what touches a leaf hides together with it.
#pragma once

#include <cstddef>

namespace occlude::culler {

/// Limits of the polygons around a leaf. Polygons with more than kMostSidesAround sides are left out, and so are those at a
/// corner where more than kMostAtCorner meet. All of them together have at most kMostAround triangles for each of the leaf's
/// own.
inline constexpr std::size_t kMostSidesAround = 64, kMostAtCorner = 64, kMostAround = 8;

}  // namespace occlude::culler
