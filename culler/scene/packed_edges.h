// SPDX-License-Identifier: MIT
// An oriented box in twelve bytes beside the axis-aligned box around it.
#pragma once

#include <array>
#include <cstdint>

#include "occlude/kernel/types.h"

namespace occlude::culler {

/// The half-edges of an oriented box, as whole 500ths of the half-widths of the axis-aligned box around it, its outer box.
/// Both have the same middle. What is unpacked holds what was packed, exactly; it is a few of these 500ths larger on each
/// side.
class PackedEdges {
 public:
  /// None: the box is the outer one.
  PackedEdges() = default;
  /// Those of a box that holds the given one. None if there is no such box whose edges fit, or if a number of it would not
  /// be legal. REQUIRES: finite numbers, and the outer_box().
  PackedEdges(const kernel::Obb& box, const kernel::Aabb& outer);

  [[nodiscard]] bool is_none() const { return edges_ == Words{}; }
  /// A legal box. REQUIRES: not is_none(), and the outer box that the edges were packed with.
  [[nodiscard]] kernel::Obb box(const kernel::Aabb& outer) const;

 private:
  using Words = std::array<std::uint32_t, 3>;

  Words edges_{};  ///< of each edge, ten bits for each axis
};

}  // namespace occlude::culler
