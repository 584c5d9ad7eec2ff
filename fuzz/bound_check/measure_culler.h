// SPDX-License-Identifier: MIT
// Measures the errors of the culler as shares of their bounds: so many cases of each bound.
#pragma once

#include <cstdint>
#include <vector>

#include "search.h"

namespace occlude::bound_check {

/// Points, cuts and planes in the coarse picture.
[[nodiscard]] std::vector<Measured> measure_picture(int cases, std::uint64_t seed);
/// Edges in it, and the pixels that they touch.
[[nodiscard]] std::vector<Measured> measure_edges(int cases, std::uint64_t seed);
/// Boxes in it.
[[nodiscard]] std::vector<Measured> measure_boxes(int cases, std::uint64_t seed);
/// Cameras and matrices, and renderers in single precision.
[[nodiscard]] std::vector<Measured> measure_cameras(int cases, std::uint64_t seed);
/// Shadows that are made smaller.
[[nodiscard]] std::vector<Measured> measure_margins(int cases, std::uint64_t seed);

}  // namespace occlude::bound_check
