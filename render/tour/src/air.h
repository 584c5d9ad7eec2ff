// SPDX-License-Identifier: MIT
// The air in and around a model: cubic cells that no triangle goes through.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "columns.h"
#include "occlude/culler/executor.h"
#include "place.h"

namespace occlude::render {

/// As a graph (rounds.h) of cells, with distances in tenths of a cell.
class Air {
 public:
  static constexpr std::uint32_t kMostCost = 17;

  /// None if the cells would have to be too wide.
  [[nodiscard]] static std::optional<Air> find(const Place& place, const culler::Checkpoint& checkpoint);

  [[nodiscard]] std::size_t size() const { return columns_.size() * nz_; }
  [[nodiscard]] double cell() const { return columns_.cell; }
  [[nodiscard]] glm::dvec3 middle(std::uint32_t cell) const;
  /// The cell that holds the point. REQUIRES: it is over the columns.
  [[nodiscard]] std::uint32_t cell_at(const glm::dvec3& point) const;
  /// About how far the cell's middle is from the nearest cell with a triangle, in tenths of a cell. 0 if it has one.
  [[nodiscard]] std::uint32_t clearance(std::uint32_t cell) const { return clearance_[cell]; }
  /// The clearance of the narrowest place on the widest way from outside. 0 where there is no way.
  [[nodiscard]] std::uint32_t width(std::uint32_t cell) const { return width_[cell]; }
  /// In how many of the directions to its 26 neighbours, and beyond them, there is a triangle, from 0 to 1.
  [[nodiscard]] double enclosure(std::uint32_t cell) const { return enclosure_[cell] / 26.0; }
  /// Whether the cell is the last one on a side of the grid, or at its top.
  [[nodiscard]] bool is_outermost(std::uint32_t cell) const;

  /// Calls visit(next, tenths) for the up to 26 cells around, with the distance of their middles.
  template <class Visit>
  void for_each_next(std::uint32_t cell, Visit&& visit) const {
    static constexpr std::uint32_t kDistances[] = {0, 10, 14, 17};
    const auto [x, y, z] = position(cell);
    for (int dz = -1; dz <= 1; ++dz) {
      for (int dy = -1; dy <= 1; ++dy) {
        for (int dx = -1; dx <= 1; ++dx) {
          const int moves = dx * dx + dy * dy + dz * dz;
          if (moves > 0 && has(x + dx, y + dy, z + dz)) visit(number(x + dx, y + dy, z + dz), kDistances[moves]);
        }
      }
    }
  }

 private:
  using Position = std::array<int, 3>;

  Air(const Place& place, const Columns& columns, double z, std::uint32_t nz, const culler::Checkpoint& checkpoint);

  void find_clearance(const Place& place, const culler::Checkpoint& checkpoint);
  void find_width();
  void find_enclosure();

  [[nodiscard]] Position position(std::uint32_t cell) const {
    const std::uint32_t column = cell / nz_;
    return {static_cast<int>(column % columns_.nx), static_cast<int>(column / columns_.nx), static_cast<int>(cell % nz_)};
  }
  [[nodiscard]] bool has(int x, int y, int z) const {
    return x >= 0 && y >= 0 && z >= 0 && x < static_cast<int>(columns_.nx) && y < static_cast<int>(columns_.ny) &&
           z < static_cast<int>(nz_);
  }
  [[nodiscard]] std::uint32_t number(int x, int y, int z) const {
    return (static_cast<std::uint32_t>(y) * columns_.nx + static_cast<std::uint32_t>(x)) * nz_ +
           static_cast<std::uint32_t>(z);
  }

  Columns columns_;
  double z_ = 0;
  std::uint32_t nz_ = 0;
  std::vector<std::uint32_t> clearance_, width_;
  std::vector<std::uint8_t> enclosure_;
};

}  // namespace occlude::render
