// SPDX-License-Identifier: MIT
#pragma once

#include <array>

namespace occlude::render {

/// Names of the half-spaces of a view, in the order of append_view_frustum().
inline constexpr std::array<const char*, 6> kViewPlanes{"left", "right", "bottom", "top", "near", "far"};

}  // namespace occlude::render
