// SPDX-License-Identifier: MIT
// The cells of a grid over a solid's box that lie inside of it. Where a box is looked for; heuristic, up to rounding.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "frusta/solid.h"
#include "occlude/culler/executor.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

class SolidCells {
 public:
  /// A row of cells along x is the bits of one word.
  static constexpr std::size_t kMostCells = 64;

  /// A block of cells: from `first` to before `end` on each axis.
  struct Block {
    std::array<std::size_t, 3> first, end;

    [[nodiscard]] std::size_t cells() const { return (end[0] - first[0]) * (end[1] - first[1]) * (end[2] - first[2]); }
  };

  /// `size` cells on each axis, so that thin solids have some, too. REQUIRES: 0 < size <= kMostCells; a solid whose box has
  /// volume. Takes time in proportion to the rows of cells that triangles meet, and to the rows.
  SolidCells(const Solid& solid, std::size_t size, const Checkpoint& checkpoint);

  /// A block with as many cells as any that has only cells inside the solid that are not taken. Takes time in proportion to
  /// the fourth power of the size, and a few operations on words for each such unit.
  [[nodiscard]] std::optional<Block> largest() const;
  void take(const Block& block);
  /// The block with another layer of cells around it, where there are any.
  [[nodiscard]] Block one_more(const Block& block) const;
  /// The box of the block; with an inset, in cells, each face that much farther within.
  [[nodiscard]] kernel::Aabb box(const Block& block, double inset = 0) const;

 private:
  using Row = std::uint64_t;
  struct Outline;

  [[nodiscard]] Row& row(std::size_t y, std::size_t z) { return rows_[z * size_ + y]; }
  [[nodiscard]] bool has_free(const Block& block) const;
  [[nodiscard]] Block block_of(std::size_t row, std::size_t x) const;
  [[nodiscard]] static Outline layer_of(const Outline& whole, int axis, double layer);
  [[nodiscard]] Block cells_about(const Outline& outline) const;
  void mark(const SolidTriangle& triangle);
  void drop_outside(const Solid& solid, const Checkpoint& checkpoint);

  std::size_t size_;
  kernel::Aabb space_;
  std::vector<Row> rows_;  ///< row z * size_ + y: bit x is set while the cell is free
};

}  // namespace occlude::culler
