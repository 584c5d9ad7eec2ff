// SPDX-License-Identifier: MIT
#include "solid_cells.h"

#include <algorithm>
#include <bit>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <span>

#include "bounds.h"
#include "disjoint_sets.h"

namespace occlude::culler {
namespace {

using kernel::Aabb;

/// The longest run of bits that are set.
struct Run {
  std::size_t first = 0, length = 0;
};

Run longest_run(std::uint64_t bits) {
  Run run;
  for (; bits != 0; bits &= bits >> 1U) {  // after k rounds, where k + 1 bits follow
    run.first = static_cast<std::size_t>(std::countr_zero(bits));
    ++run.length;
  }
  return run;
}

/// `length` bits from bit `first` on.
std::uint64_t bits_of(std::size_t first, std::size_t length) { return ~std::uint64_t{0} >> (64 - length) << first; }

}  // namespace

SolidCells::SolidCells(const Solid& solid, std::size_t size, const Checkpoint& checkpoint)
    : size_(size), space_(solid.box), rows_(size * size, bits_of(0, size)) {
  for (const SolidTriangle& triangle : solid.triangles) {
    checkpoint();
    mark(triangle);
  }
  drop_outside(solid, checkpoint);
}

void SolidCells::mark(const SolidTriangle& triangle) {
  Piece piece;
  for (std::size_t i = 0; i < 3; ++i) {
    for (int axis = 0; axis < 3; ++axis) {
      const double extent = space_.max[axis] - space_.min[axis];
      piece[i][axis] = (triangle.corners[i][axis] - space_.min[axis]) / extent * static_cast<double>(size_);
    }
  }
  mark(piece);
}

/// Takes the cells of the triangle's box, if that is small; else marks the two halves of the triangle.
void SolidCells::mark(const Piece& piece) {
  constexpr double kSmall = 0.5;  // cells: so a slanting wall takes hardly more cells than it meets
  const glm::dvec3 low = glm::min(glm::min(piece[0], piece[1]), piece[2]);
  const glm::dvec3 high = glm::max(glm::max(piece[0], piece[1]), piece[2]);
  const glm::dvec3 extent = high - low;
  if (std::max({extent.x, extent.y, extent.z}) <= kSmall) {
    const auto cell = [&](double place) { return std::min(static_cast<std::size_t>(place), size_ - 1); };
    take({{cell(low.x), cell(low.y), cell(low.z)}, {cell(high.x) + 1, cell(high.y) + 1, cell(high.z) + 1}});
    return;
  }
  const auto squared = [&](std::size_t i) { return glm::dot(piece[(i + 1) % 3] - piece[i], piece[(i + 1) % 3] - piece[i]); };
  std::size_t longest = squared(1) > squared(0) ? 1 : 0;
  if (squared(2) > squared(longest)) longest = 2;
  const glm::dvec3 &from = piece[longest], &to = piece[(longest + 1) % 3], &other = piece[(longest + 2) % 3];
  const glm::dvec3 middle = (from + to) * 0.5;
  mark(Piece{from, middle, other});
  mark(Piece{middle, to, other});
}

/// Free cells that are connected are inside or outside together. Middles of cells that are not legal points may be taken for
/// anything; boxes are proven later.
void SolidCells::drop_outside(const Solid& solid, const Checkpoint& checkpoint) {
  DisjointSets sets(size_ * size_ * size_);
  const auto set_of = [&](std::size_t cell) { return sets.find(static_cast<std::uint32_t>(cell)); };
  for (std::size_t cell = 0; cell < size_ * size_ * size_; ++cell) {
    if (!is_free(cell)) continue;
    std::size_t step = 1;
    for (int axis = 0; axis < 3; ++axis, step *= size_) {
      if (cell / step % size_ + 1 < size_ && is_free(cell + step)) sets.join(set_of(cell), set_of(cell + step));
    }
  }
  sets.for_each_set([&](std::span<const std::uint32_t> cells) {
    if (!is_free(cells.front())) return;
    checkpoint();
    if (is_inside(solid, middle(box(block_of(cells.front()))))) return;
    for (const std::uint32_t cell : cells) take(block_of(cell));
  });
}

std::optional<SolidCells::Block> SolidCells::largest() const {
  std::optional<Block> best;
  std::size_t most = 0;
  std::vector<Row> open(size_);  // for each y, the cells that are free in all layers from z to last_z
  for (std::size_t z = 0; z < size_; ++z) {
    open.assign(size_, ~Row{0});
    for (std::size_t last_z = z; last_z < size_; ++last_z) {
      for (std::size_t y = 0; y < size_; ++y) open[y] &= rows_[last_z * size_ + y];
      for (std::size_t y = 0; y < size_; ++y) {
        Row bits = open[y];
        for (std::size_t last_y = y; last_y < size_ && (bits &= open[last_y]) != 0; ++last_y) {
          const std::size_t rows = (last_y + 1 - y) * (last_z + 1 - z);
          if (static_cast<std::size_t>(std::popcount(bits)) * rows <= most) continue;
          const Run run = longest_run(bits);
          if (run.length * rows <= most) continue;
          most = run.length * rows;
          best = {{run.first, y, z}, {run.first + run.length, last_y + 1, last_z + 1}};
        }
      }
    }
  }
  return best;
}

void SolidCells::take(const Block& block) {
  const Row taken = bits_of(block.first[0], block.end[0] - block.first[0]);
  for (std::size_t z = block.first[2]; z < block.end[2]; ++z) {
    for (std::size_t y = block.first[1]; y < block.end[1]; ++y) row(y, z) &= ~taken;
  }
}

SolidCells::Block SolidCells::one_more(const Block& block) const {
  Block more = block;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    if (more.first[axis] > 0) --more.first[axis];
    if (more.end[axis] < size_) ++more.end[axis];
  }
  return more;
}

SolidCells::Block SolidCells::block_of(std::size_t cell) const {
  const std::size_t x = cell % size_, y = cell / size_ % size_, z = cell / size_ / size_;
  return {{x, y, z}, {x + 1, y + 1, z + 1}};
}

Aabb SolidCells::box(const Block& block, double inset) const {
  const auto place = [&](int axis, double cell) {
    return space_.min[axis] + (space_.max[axis] - space_.min[axis]) * (cell / static_cast<double>(size_));
  };
  Aabb box;
  for (int axis = 0; axis < 3; ++axis) {
    const auto a = static_cast<std::size_t>(axis);
    // What rounding puts beyond the solid's own box is of no use.
    box.min[axis] = std::max(place(axis, static_cast<double>(block.first[a]) + inset), space_.min[axis]);
    box.max[axis] = std::min(place(axis, static_cast<double>(block.end[a]) - inset), space_.max[axis]);
  }
  return box;
}

}  // namespace occlude::culler
