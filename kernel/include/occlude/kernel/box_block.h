// SPDX-License-Identifier: MIT
// Eight boxes side by side, for tests of all of them at once. Reading order: 12.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "occlude/kernel/half_space.h"
#include "occlude/kernel/types.h"

namespace occlude::kernel {

/// Eight axis-aligned boxes, coordinate by coordinate. A box that was never set is the point (0, 0, 0).
struct BoxBlock {
  static constexpr std::size_t kBoxes = 8;
  using Row = std::array<double, kBoxes>;

  alignas(64) std::array<Row, 3> min{};
  std::array<Row, 3> max{};

  /// REQUIRES of both: i < kBoxes.
  void set(std::size_t i, const Aabb& box) {
    for (int axis = 0; axis < 3; ++axis) {
      min[static_cast<std::size_t>(axis)][i] = box.min[axis];
      max[static_cast<std::size_t>(axis)][i] = box.max[axis];
    }
  }
  [[nodiscard]] Aabb box(std::size_t i) const {
    return {{min[0][i], min[1][i], min[2][i]}, {max[0][i], max[1][i], max[2][i]}};
  }
};

/// Boxes of a block: bit i stands for box i.
using BoxBits = std::uint8_t;

/// How many there are.
[[nodiscard]] constexpr std::size_t count(BoxBits boxes) {
  constexpr std::uint64_t kOfNibble = 0x4332'3221'3221'2110;  // std::popcount() is slow on the processors of old
  return (kOfNibble >> (boxes % 16 * 4) & 0xF) + (kOfNibble >> (boxes / 16 * 4) & 0xF);
}

/// Those of the asked boxes that are outside of a half-space, and those inside.
struct BlockRelation {
  BoxBits outside, inside;
};

/// For each bit i of `which`, sets relations[i] to what relation() answers, certified, for half-space i and each of the
/// asked boxes. Nothing is allocated. REQUIRES (not checked): half-space i and relations[i] exist; of the half-spaces and of
/// the asked boxes, as relation().
void relations(std::span<const HalfSpace> half_spaces, std::uint32_t which, const BoxBlock& block, BoxBits asked,
               std::span<BlockRelation> relations);

}  // namespace occlude::kernel
