// SPDX-License-Identifier: MIT
// Where one can stand in a model, and step from there: a grid of columns in which the triangles are solid spans, as in
// navigation meshes for games (Mononen's Recast).
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

/// Measures of who walks, in eye heights.
namespace walker {
inline constexpr double kHeadroom = 1.1;     // 1.87 m of a person's 1.7: doors are 2 m high
inline constexpr double kStep = 0.26;        // 0.44 m: two steps of a stair, which a column may span
inline constexpr double kRadius = 0.15;      // 0.26 m: half of a door of 0.8 m, less a column of 0.14 m
inline constexpr double kComfort = 0.6;      // 1 m from walls where there is room
inline constexpr double kCeiling = 5;        // what is higher is a sky rather than a ceiling
inline constexpr double kSurroundings = 15;  // 25 m: walls that are farther do not enclose
}  // namespace walker

/// As a graph (rounds.h) of stands, with distances in tenths of a column.
class Floors {
 public:
  static constexpr std::uint32_t kMostCost = 14;
  static constexpr std::uint32_t kNone = ~std::uint32_t{0};

  struct Stand {
    float floor, ceiling;  ///< heights
    std::uint32_t column, span;
    std::array<std::uint32_t, 4> next;  ///< the stands one step away in +x, +y, -x, -y, or kNone
  };

  /// None if the columns would have to be too wide for a person.
  [[nodiscard]] static std::optional<Floors> find(const Place& place, const culler::Checkpoint& checkpoint);

  [[nodiscard]] const Columns& columns() const { return columns_; }
  [[nodiscard]] const std::vector<Stand>& stands() const { return stands_; }
  [[nodiscard]] std::size_t size() const { return stands_.size(); }
  /// How far the stand is from the nearest stand at a wall or a drop, in tenths of a column.
  [[nodiscard]] std::uint32_t clearance(std::uint32_t stand) const { return clearance_[stand]; }
  /// How much of the surroundings is walls and ceiling, from 0 to 1.
  [[nodiscard]] double enclosure(std::uint32_t stand) const { return enclosure_[stand] / kWholeEnclosure; }
  /// Whether no air comes here from outside of the model, not even through windows.
  [[nodiscard]] bool is_sealed(std::uint32_t stand) const { return !is_airy_[stands_[stand].span]; }
  /// How many of floor and ceiling turn their front side here: 0 to 2.
  [[nodiscard]] int fronts(std::uint32_t stand) const;

  /// Calls visit(next, tenths) for the up to eight stands around, with their distance in tenths of a column. Diagonal steps
  /// are those that can be taken both ways round.
  template <class Visit>
  void for_each_next(std::uint32_t stand, Visit&& visit) const {
    for (unsigned d = 0; d < 4; ++d) {
      if (const std::uint32_t next = stands_[stand].next[d]; next != kNone) visit(next, 10U);
      if (const std::uint32_t next = diagonal(stand, d); next != kNone) visit(next, 14U);
    }
  }

 private:
  enum Bits : std::uint8_t { kLevelTop = 1, kTopUp = 2, kBottomUp = 4 };
  struct Span {
    float low, high;
    std::uint8_t bits;
  };
  static constexpr double kWholeEnclosure = 10;  // eight directions, and two for the ceiling

  Floors(const Place& place, const Columns& columns, const culler::Checkpoint& checkpoint);

  void find_spans(const culler::Checkpoint& checkpoint);
  void merge_spans();
  void find_stands();
  void link_stands();
  void find_clearance(const culler::Checkpoint& checkpoint);
  void find_enclosure();
  void find_air();

  [[nodiscard]] std::uint32_t diagonal(std::uint32_t stand, unsigned d) const;
  [[nodiscard]] std::uint32_t neighbour(std::uint32_t column, int dx, int dy) const;
  [[nodiscard]] bool is_wall(std::uint32_t column, const Stand& before) const;

  const Place& place_;
  Columns columns_;
  std::vector<std::uint32_t> first_span_, first_stand_;  ///< of each column, and one more
  std::vector<Span> spans_;
  std::vector<Stand> stands_;
  std::vector<std::uint32_t> clearance_;
  std::vector<std::uint8_t> enclosure_, is_airy_;  ///< is_airy_ of the gap above each span
};

}  // namespace occlude::render
