// SPDX-License-Identifier: MIT
#include "inner/solid_cells.h"

#include <algorithm>
#include <bit>
#include <glm/common.hpp>
#include <span>

#include "base/disjoint_sets.h"
#include "model/bounds.h"

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

/// A convex polygon; corners may be repeated. Cutting a layer out of it leaves at most two corners for each side, and the
/// three of a triangle are cut twice.
struct SolidCells::Outline {
  std::array<glm::dvec3, 12> corners;
  std::size_t count = 0;

  void add(const glm::dvec3& corner) { corners[count++] = corner; }
};

/// What lies between two planes across the axis, one at `layer` and one a cell beyond. Up to rounding.
SolidCells::Outline SolidCells::layer_of(const Outline& whole, int axis, double layer) {
  Outline part;
  for (std::size_t i = 0; i < whole.count; ++i) {
    const glm::dvec3 &a = whole.corners[i], &b = whole.corners[(i + 1) % whole.count];
    const auto [low, high] = std::minmax(a[axis], b[axis]);
    if (high < layer || low > layer + 1) continue;
    const auto at = [&](const glm::dvec3& end) {
      const double place = std::clamp(end[axis], layer, layer + 1);
      return place == end[axis] ? end : a + (b - a) * ((place - a[axis]) / (b[axis] - a[axis]));
    };
    part.add(at(a));
    part.add(at(b));
  }
  return part;
}

SolidCells::Block SolidCells::cells_about(const Outline& outline) const {
  glm::dvec3 low = outline.corners[0], high = low;
  for (std::size_t i = 1; i < outline.count; ++i) {
    low = glm::min(low, outline.corners[i]);
    high = glm::max(high, outline.corners[i]);
  }
  const auto cell = [&](double place) { return std::min(static_cast<std::size_t>(place), size_ - 1); };
  return {{cell(low.x), cell(low.y), cell(low.z)}, {cell(high.x) + 1, cell(high.y) + 1, cell(high.z) + 1}};
}

SolidCells::SolidCells(const Solid& solid, std::size_t size, const Checkpoint& checkpoint)
    : size_(size), space_(solid.box), rows_(size * size, bits_of(0, size)) {
  for (const SolidTriangle& triangle : solid.triangles) {
    checkpoint();
    mark(triangle);
  }
  drop_outside(solid, checkpoint);
}

/// Cells that are taken already are not looked for again, so copies of a triangle cost little.
void SolidCells::mark(const SolidTriangle& triangle) {
  Outline whole;
  for (const kernel::Vec3& corner : triangle.corners) {
    glm::dvec3 place;
    for (int axis = 0; axis < 3; ++axis) {
      const double extent = space_.max[axis] - space_.min[axis];
      place[axis] = (corner[axis] - space_.min[axis]) / extent * static_cast<double>(size_);
    }
    whole.add(place);
  }
  const Block layers = cells_about(whole);
  if (!has_free(layers)) return;
  for (std::size_t z = layers.first[2]; z < layers.end[2]; ++z) {
    const Outline layer = layer_of(whole, 2, static_cast<double>(z));
    const Block rows = cells_about(layer);
    for (std::size_t y = rows.first[1]; y < rows.end[1]; ++y) {
      const Outline part = layer_of(layer, 1, static_cast<double>(y));
      if (part.count == 0) continue;  // rounding moved all of the layer beyond the grid
      const Block cells = cells_about(part);
      row(y, z) &= ~bits_of(cells.first[0], cells.end[0] - cells.first[0]);
    }
  }
}

bool SolidCells::has_free(const Block& block) const {
  const Row cells = bits_of(block.first[0], block.end[0] - block.first[0]);
  for (std::size_t z = block.first[2]; z < block.end[2]; ++z) {
    for (std::size_t y = block.first[1]; y < block.end[1]; ++y) {
      if ((rows_[z * size_ + y] & cells) != 0) return true;
    }
  }
  return false;
}

/// Free cells that are connected are inside or outside together. Middles of cells that are not legal points may be taken for
/// anything; boxes are proven later.
void SolidCells::drop_outside(const Solid& solid, const Checkpoint& checkpoint) {
  struct Strip {
    std::size_t row;
    Row cells;  ///< next to each other
  };
  std::vector<Strip> strips;
  std::vector<std::size_t> first_strip;  // of each row, and the end
  for (std::size_t row = 0; row < rows_.size(); ++row) {
    first_strip.push_back(strips.size());
    for (Row left = rows_[row]; left != 0; left &= ~strips.back().cells) {
      const Row lowest = left & (~left + 1);
      strips.push_back({row, left & ~(left + lowest)});  // the sum carries over the strip
    }
  }
  first_strip.push_back(strips.size());
  DisjointSets sets(strips.size());
  const auto join_with = [&](std::size_t strip, std::size_t row) {
    for (std::size_t other = first_strip[row]; other < first_strip[row + 1]; ++other) {
      if ((strips[strip].cells & strips[other].cells) == 0) continue;
      sets.join(sets.find(static_cast<std::uint32_t>(strip)), sets.find(static_cast<std::uint32_t>(other)));
    }
  };
  for (std::size_t strip = 0; strip < strips.size(); ++strip) {
    const std::size_t row = strips[strip].row;
    if (row % size_ + 1 < size_) join_with(strip, row + 1);
    if (row + size_ < rows_.size()) join_with(strip, row + size_);
  }
  sets.for_each_set([&](std::span<const std::uint32_t> members) {
    checkpoint();
    const Strip& first = strips[members.front()];
    if (is_inside(solid, middle(box(block_of(first.row, static_cast<std::size_t>(std::countr_zero(first.cells))))))) return;
    for (const std::uint32_t member : members) rows_[strips[member].row] &= ~strips[member].cells;
  });
}

std::optional<SolidCells::Block> SolidCells::largest() const {
  std::optional<Block> best;
  std::size_t most = 0;
  std::vector<Row> open(size_);  // for each y, the cells that are free in all layers from z to last_z
  for (std::size_t z = 0; z < size_; ++z) {
    open.assign(size_, ~Row{0});
    for (std::size_t last_z = z; last_z < size_; ++last_z) {
      const std::size_t layers = last_z + 1 - z;
      std::size_t cells = 0;
      for (std::size_t y = 0; y < size_; ++y) {
        open[y] &= rows_[last_z * size_ + y];
        cells += static_cast<std::size_t>(std::popcount(open[y])) * layers;
      }
      if (cells <= most) continue;  // no block of these layers has more
      for (std::size_t y = 0; y < size_; ++y) {
        Row bits = open[y];
        for (std::size_t last_y = y; last_y < size_ && (bits &= open[last_y]) != 0; ++last_y) {
          const std::size_t rows = (last_y + 1 - y) * layers;
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

SolidCells::Block SolidCells::block_of(std::size_t row, std::size_t x) const {
  const std::size_t y = row % size_, z = row / size_;
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
