// SPDX-License-Identifier: MIT
// Eight boxes side by side, for tests of all of them at once. Reading order: 12.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "occlude/kernel/half_space.h"
#include "occlude/kernel/shadow_frustum.h"
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

/// For each of eight questions, boxes of a block: byte k is the BoxBits of question k.
using BoxBytes = std::uint64_t;

/// How many there are for each of them, in its byte.
[[nodiscard]] constexpr BoxBytes counts(BoxBytes bytes) {
  constexpr BoxBytes kOdd = 0x5555'5555'5555'5555, kPairs = 0x3333'3333'3333'3333, kNibbles = 0x0F0F'0F0F'0F0F'0F0F;
  bytes -= bytes >> 1 & kOdd;
  bytes = (bytes & kPairs) + (bytes >> 2 & kPairs);
  return (bytes + (bytes >> 4)) & kNibbles;
}
/// The sum of eight counts().
[[nodiscard]] constexpr std::size_t total(BoxBytes counts) { return counts * 0x0101'0101'0101'0101 >> 56; }
/// How many there are for all of them together.
[[nodiscard]] constexpr std::size_t count(BoxBytes bytes) { return total(counts(bytes)); }
/// The same boxes for each of eight questions. REQUIRES: `boxes` is a BoxBits.
[[nodiscard]] constexpr BoxBytes for_all(std::uint32_t boxes) { return boxes * BoxBytes{0x0101'0101'0101'0101}; }
/// The boxes of one of them. REQUIRES: question < 8.
[[nodiscard]] constexpr BoxBits boxes_of(BoxBytes bytes, std::size_t question) {
  return static_cast<BoxBits>(bytes >> 8 * question & 0xFF);
}

/// For each of up to eight half-spaces, those of the asked boxes that are outside of it, and those inside.
struct BlockRelations {
  BoxBytes outside = 0, inside = 0;
};

/// What relation() answers, certified, for half-space k and the boxes of byte k of `asked`. Nothing is allocated. REQUIRES
/// (not checked): half-space k exists for each byte that is not 0; of the half-spaces and of the asked boxes, as relation().
[[nodiscard]] BlockRelations relations(std::span<const HalfSpace> half_spaces, const BoxBlock& block, BoxBytes asked);

/// Up to eight frusta that are asked about with the boxes of a block, and what the filter knows of the answers that
/// conservative_certified() gives (overlap.h), for either NearBoundary. Boxes of which nothing is set are `partial`.
struct BlockQuestions {
  static constexpr std::size_t kMost = 8;

  std::array<std::uint32_t, kMost> frustum;  ///< of each question
  std::uint32_t count;                       ///< of questions
  BoxBytes outside, inside;                  ///< answers
  BoxBytes unknown;                          ///< left to the test of a single box
};

/// Answers the questions as far as error bounds suffice. The answers for boxes that were never set mean nothing. Nothing is
/// allocated. REQUIRES (not checked): of each question, frusta[frustum] exists; of the boxes, as conservative_certified().
void conservative_filter(std::span<const ShadowFrustum* const> frusta, const BoxBlock& block, BlockQuestions& questions);

}  // namespace occlude::kernel
