// SPDX-License-Identifier: MIT
#include "model/curve_order.h"

#include <algorithm>
#include <array>
#include <numeric>

#include "model/bounds.h"

namespace occlude::culler {
namespace {

/// Bits of a centre on each axis. Three times as many fit in a code.
constexpr int kBits = 10;

/// The bits of a number of kBits bits, three places apart.
std::uint32_t spread(std::uint32_t x) {
  x = (x | x << 16U) & 0x030000FFU;
  x = (x | x << 8U) & 0x0300F00FU;
  x = (x | x << 4U) & 0x030C30C3U;
  return (x | x << 2U) & 0x09249249U;
}

double centre(const kernel::Aabb& box, int axis) { return box.min[axis] / 2 + box.max[axis] / 2; }

}  // namespace

void CurveOrder::sort(std::span<const kernel::Aabb> boxes) {
  order_.resize(boxes.size());
  std::iota(order_.begin(), order_.end(), 0U);
  find_codes(boxes);
  sort_by_codes();
}

void CurveOrder::find_codes(std::span<const kernel::Aabb> boxes) {
  kernel::Aabb centres = empty_box();
  for (const kernel::Aabb& box : boxes) grow(centres, kernel::Vec3{centre(box, 0), centre(box, 1), centre(box, 2)});
  constexpr double kCells = 1 << kBits;
  // The same scale on all axes, so that cells are cubes.
  double extent = 0;
  for (int axis = 0; axis < 3; ++axis) extent = std::max(extent, centres.max[axis] - centres.min[axis]);
  const double scale = extent > 0 ? kCells / extent : 0;
  codes_.resize(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    std::uint32_t code = 0;
    for (int axis = 0; axis < 3; ++axis) {
      const double cell = std::min((centre(boxes[i], axis) - centres.min[axis]) * scale, kCells - 1);
      code = code | spread(static_cast<std::uint32_t>(cell)) << static_cast<unsigned>(axis);
    }
    codes_[i] = code;
  }
}

/// Radix sort (Hollerith 1889).
void CurveOrder::sort_by_codes() {
  constexpr unsigned kDigit = 10, kDigits = 1U << kDigit;
  static_assert(3 * kBits == 3 * kDigit);
  spare_order_.resize(order_.size());
  spare_codes_.resize(codes_.size());
  for (unsigned shift = 0; shift < 3 * kDigit; shift += kDigit) {
    std::array<std::uint32_t, kDigits> next{};
    const auto digit = [&](std::uint32_t code) { return code >> shift & (kDigits - 1); };
    for (const std::uint32_t code : codes_) ++next[digit(code)];
    std::exclusive_scan(next.begin(), next.end(), next.begin(), 0U);
    for (std::size_t i = 0; i < codes_.size(); ++i) {
      const std::uint32_t to = next[digit(codes_[i])]++;
      spare_codes_[to] = codes_[i];
      spare_order_[to] = order_[i];
    }
    codes_.swap(spare_codes_);
    order_.swap(spare_order_);
  }
}

std::vector<ItemRange> CurveOrder::runs(std::uint32_t most) const {
  std::vector<ItemRange> runs;
  if (!order_.empty()) divide({0, static_cast<std::uint32_t>(order_.size())}, most, runs);
  return runs;
}

void CurveOrder::divide(const ItemRange& range, std::uint32_t most, std::vector<ItemRange>& runs) const {
  if (range.count <= most) return runs.push_back(range);
  const std::uint32_t left = left_of(range);
  divide({range.first, left}, most, runs);
  divide({range.first + left, range.count - left}, most, runs);
}

/// How many boxes go left. So there are no more levels than a place has bits, and the logarithm of the number of boxes more.
std::uint32_t CurveOrder::left_of(const ItemRange& range) const {
  const auto begin = codes_.begin() + range.first, end = begin + range.count;
  const std::uint32_t differ = *begin ^ *(end - 1);
  if (differ == 0) return range.count / 2;
  const std::uint32_t bit = std::bit_floor(differ);
  return static_cast<std::uint32_t>(std::partition_point(begin, end, [&](std::uint32_t c) { return (c & bit) == 0; }) -
                                    begin);
}

std::size_t CurveOrder::bytes() const {
  const std::size_t numbers = order_.capacity() + codes_.capacity() + spare_order_.capacity() + spare_codes_.capacity();
  return numbers * sizeof(std::uint32_t);
}

}  // namespace occlude::culler
