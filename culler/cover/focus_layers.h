// SPDX-License-Identifier: MIT
// The layers of a picture of several eyes.
#pragma once

#include <array>
#include <cstddef>
#include <limits>

#include "cover/conservative_viewport.h"

namespace occlude::culler {

/// From far to near: each has its own plane in focus. Those of one eye are one.
struct FocusLayers {
  static constexpr std::size_t kMost = 12;

  std::array<float, kMost> focus{};
  std::size_t count = 1;
  /// A mesh is drawn into the layers that it reaches, and into so many beyond it. Still farther ones take over what nearer
  /// ones have closed.
  std::size_t beyond = 1;

  FocusLayers() = default;
  explicit FocusLayers(const ConservativeViewport& picture);

  /// What is not nearer than this cannot hide any box that asks the layer.
  [[nodiscard]] float start(std::size_t layer) const {
    return layer == 0 ? -std::numeric_limits<float>::infinity() : focus[layer - 1];
  }
};

}  // namespace occlude::culler
