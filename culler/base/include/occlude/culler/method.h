// SPDX-License-Identifier: MIT
// The two ways of culling. Reading order: 1.
#pragma once

#include <cstdint>

namespace occlude::culler {

/// What hides.
enum class Method {
  frusta,  ///< the shadows of a few chosen occluders, each on its own: the paper's method
  cover,   ///< everything that is found visible, front to back, joined in a coarse picture
};

/// The best Hierarchy::Config::leaf_size for a method. For covers leaves are small: a hidden polygon is drawn if any part of
/// its leaf's box is not hidden.
[[nodiscard]] inline constexpr std::uint32_t leaf_size_for(Method method) { return method == Method::cover ? 4 : 16; }

}  // namespace occlude::culler
