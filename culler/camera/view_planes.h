// SPDX-License-Identifier: MIT
// The planes of a view as the descents ask about them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "occlude/kernel/half_space.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// The planes of a view, at most kMostPlanes, and how boxes are held against them.
struct ViewPlanes {
  static constexpr std::size_t kMostPlanes = 8;

  std::span<const kernel::HalfSpace> planes;  ///< REQUIRES: at most kMostPlanes
  kernel::Arithmetic arithmetic;

  /// A bit for each plane.
  [[nodiscard]] std::uint32_t all() const { return (std::uint32_t{1} << planes.size()) - 1; }
};

}  // namespace occlude::culler
