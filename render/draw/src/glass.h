// SPDX-License-Identifier: MIT
// How see-through surfaces look.
#pragma once

namespace occlude::render {

/// The share of a see-through surface in what one sees through it.
inline constexpr double kGlassShare = 0.4;

}  // namespace occlude::render
