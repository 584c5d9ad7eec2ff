// SPDX-License-Identifier: MIT
#include "linear_tree.h"

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>

#include "bounds.h"

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

void LinearTree::build(std::span<const kernel::Aabb> boxes, std::uint32_t leaf_size) {
  nodes_.clear();
  order_.resize(boxes.size());
  std::iota(order_.begin(), order_.end(), 0U);
  if (boxes.empty()) return;
  find_codes(boxes);
  sort();
  append(boxes, 0, static_cast<std::uint32_t>(boxes.size()), leaf_size);
}

void LinearTree::find_codes(std::span<const kernel::Aabb> boxes) {
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

/// Sorts order_ and codes_ by the codes; what has the same code keeps its order (radix sort, Hollerith 1889).
void LinearTree::sort() {
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

/// Appends the subtree over order_[first, first + count).
void LinearTree::append(std::span<const kernel::Aabb> boxes, std::uint32_t first, std::uint32_t count,
                        std::uint32_t leaf_size) {
  const std::size_t self = nodes_.size();
  nodes_.push_back({.box = empty_box(), .first = first, .count = count});
  if (count <= leaf_size) {
    for (std::uint32_t i = first; i < first + count; ++i) grow(nodes_[self].box, boxes[order_[i]]);
    return;
  }
  const std::uint32_t left = left_of(first, count);
  append(boxes, first, left, leaf_size);
  const std::size_t right = nodes_.size();
  append(boxes, first + left, count - left, leaf_size);
  nodes_[self].right = static_cast<std::uint32_t>(right);
  nodes_[self].box = nodes_[self + 1].box;
  grow(nodes_[self].box, nodes_[right].box);
}

/// How many items go left: those before the change of the highest bit in which their codes differ, or half of them where all
/// codes are the same. So a tree has no more levels than a code has bits, and the logarithm of the number of items more.
std::uint32_t LinearTree::left_of(std::uint32_t first, std::uint32_t count) const {
  const auto begin = codes_.begin() + first, end = begin + count;
  const std::uint32_t differ = *begin ^ *(end - 1);
  if (differ == 0) return count / 2;
  const std::uint32_t bit = std::bit_floor(differ);
  return static_cast<std::uint32_t>(std::partition_point(begin, end, [&](std::uint32_t c) { return (c & bit) == 0; }) -
                                    begin);
}

std::size_t LinearTree::bytes() const {
  const std::size_t numbers = order_.capacity() + codes_.capacity() + spare_order_.capacity() + spare_codes_.capacity();
  return nodes_.capacity() * sizeof(HierarchyNode) + numbers * sizeof(std::uint32_t);
}

}  // namespace occlude::culler
