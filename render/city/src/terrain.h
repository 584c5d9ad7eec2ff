// SPDX-License-Identifier: MIT
// The shape of the hills: a regular grid of heights, plane on each half of a cell.
#pragma once

#include <vector>

#include "units.h"

namespace occlude::render::city {

class Terrain {
 public:
  /// Hills over `extent`, in cells of about `cell`. The height is 0 along the western edge, where the causeway arrives.
  Terrain(std::uint64_t seed, const Rect& extent, Length cell);

  [[nodiscard]] const Rect& extent() const { return extent_; }
  [[nodiscard]] Length columns() const { return columns_; }
  [[nodiscard]] Length rows() const { return rows_; }
  /// The positions of the grid lines.
  [[nodiscard]] Length x(Length column) const { return extent_.x0 + cell_ * column; }
  [[nodiscard]] Length y(Length row) const { return extent_.y0 + cell_ * row; }
  [[nodiscard]] Length cell() const { return cell_; }
  /// Height of the surface, 0 outside the hills.
  [[nodiscard]] Length height(Length x, Length y) const;

 private:
  [[nodiscard]] Length node(Length column, Length row) const {
    return heights_[static_cast<std::size_t>(row * (columns_ + 1) + column)];
  }
  Rect extent_;
  Length cell_, columns_, rows_;
  std::vector<Length> heights_;
};

}  // namespace occlude::render::city
