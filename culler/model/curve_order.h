// SPDX-License-Identifier: MIT
// Boxes in an order in which neighbours are near each other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "model/block_tree.h"
#include "occlude/kernel/types.h"

namespace occlude::culler {

/// Sorts boxes along a curve through space by the bits of their centres (Morton 1966), in linear time. Sorting no more boxes
/// than before allocates nothing.
class CurveOrder {
 public:
  /// Boxes at one place of the curve keep their order. REQUIRES: finite boxes.
  void sort(std::span<const kernel::Aabb> boxes);

  /// The indices of the boxes in the order of the curve.
  [[nodiscard]] std::span<const std::uint32_t> order() const { return order_; }
  /// The order in runs of at most so many boxes, one or more: what has more is divided where the highest bit of the places
  /// changes (Lauterbach et al. 2009), or in halves where all are the same.
  [[nodiscard]] std::vector<ItemRange> runs(std::uint32_t most) const;
  /// The bytes of memory that it holds.
  [[nodiscard]] std::size_t bytes() const;

 private:
  void find_codes(std::span<const kernel::Aabb> boxes);
  void sort_by_codes();
  void divide(const ItemRange& range, std::uint32_t most, std::vector<ItemRange>& runs) const;
  [[nodiscard]] std::uint32_t left_of(const ItemRange& range) const;

  std::vector<std::uint32_t> order_, codes_;              ///< the boxes, and their places on the curve
  std::vector<std::uint32_t> spare_order_, spare_codes_;  ///< memory of sort_by_codes()
};

}  // namespace occlude::culler
