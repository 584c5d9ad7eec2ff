// SPDX-License-Identifier: MIT
// Boxes in an order in which neighbours are near each other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "occlude/kernel/types.h"

namespace occlude::culler {

/// Sorts boxes along a curve through space by the bits of their centres (Morton 1966), in linear time. Sorting no more boxes
/// than before allocates nothing.
class CurveOrder {
 public:
  /// Boxes at one place of the curve keep their order. REQUIRES: finite boxes.
  void sort(std::span<const kernel::Aabb> boxes);

  /// The indices of the boxes in the order of the curve, and the places of these on it.
  [[nodiscard]] std::span<const std::uint32_t> order() const { return order_; }
  [[nodiscard]] std::span<const std::uint32_t> codes() const { return codes_; }
  /// The bytes of memory that it holds.
  [[nodiscard]] std::size_t bytes() const;

 private:
  void find_codes(std::span<const kernel::Aabb> boxes);
  void sort_by_codes();

  std::vector<std::uint32_t> order_, codes_;
  std::vector<std::uint32_t> spare_order_, spare_codes_;  ///< memory of sort_by_codes()
};

}  // namespace occlude::culler
