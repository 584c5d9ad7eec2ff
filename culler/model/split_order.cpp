// SPDX-License-Identifier: MIT
#include "model/split_order.h"

#include <algorithm>
#include <limits>
#include <numeric>

#include "model/block_tree.h"
#include "model/bounds.h"

namespace occlude::culler {
namespace {

constexpr std::uint32_t kWidth = TreeBlock::kNodes;

}  // namespace

SplitOrder::Bounds::Bounds() { least.fill(std::numeric_limits<float>::infinity()); }

SplitOrder::Bounds::Bounds(const kernel::Aabb& box, const kernel::Vec3& origin) : Bounds() {
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    least[k] = static_cast<float>(box.min[axis] - origin[axis]);
    least[k + 4] = static_cast<float>(origin[axis] - box.max[axis]);
  }
}

float SplitOrder::Bounds::half_area() const {
  const float x = -(least[0] + least[4]), y = -(least[1] + least[5]), z = -(least[2] + least[6]);
  return x * y + y * z + z * x;
}

void SplitOrder::sort(std::span<const kernel::Aabb> boxes) {
  kernel::Aabb all = empty_box();
  for (const kernel::Aabb& box : boxes) grow(all, box);
  bounds_.clear();
  for (const kernel::Aabb& box : boxes) bounds_.emplace_back(box, all.min);
  is_left_.resize(boxes.size());
  for (std::size_t axis = 0; axis < 3; ++axis) sort_on(axis);
  const auto count = static_cast<std::uint32_t>(boxes.size());
  std::uint32_t of_part = kWidth;
  while (of_part * kWidth < count) of_part *= kWidth;
  split(0, count, of_part);
}

/// Counts how many boxes have their centres in each of kCells equal parts of the axis. Boxes in one part keep their order.
void SplitOrder::sort_on(std::size_t axis) {
  constexpr std::size_t kCells = 1024;
  const auto centre = [&](const Bounds& box) { return box.least[axis] - box.least[axis + 4]; };  // twice the centre
  float low = std::numeric_limits<float>::infinity(), high = -low;
  for (const Bounds& box : bounds_) {
    low = std::min(low, centre(box));
    high = std::max(high, centre(box));
  }
  const float extent = high > low ? high - low : 1;
  const auto cell = [&](const Bounds& box) {
    // Divided before it is multiplied, because 1 / extent may be infinite.
    return std::min(static_cast<std::size_t>((centre(box) - low) / extent * kCells), kCells - 1);
  };
  std::array<std::uint32_t, kCells> next{};
  for (const Bounds& box : bounds_) ++next[cell(box)];
  std::exclusive_scan(next.begin(), next.end(), next.begin(), 0U);
  sorted_[axis].resize(bounds_.size());
  for (std::uint32_t i = 0; i < bounds_.size(); ++i) sorted_[axis][next[cell(bounds_[i])]++] = i;
}

/// Orders a part of the boxes. It becomes parts of `of_part` boxes each, and the last of what is left.
void SplitOrder::split(std::uint32_t first, std::uint32_t count, std::uint32_t of_part) {
  if (count <= kWidth) return;  // one block, in which the order means nothing
  while (count <= of_part) of_part /= kWidth;
  const Split split = best_split(first, count, of_part);
  divide(first, count, split);
  this->split(first, split.left, of_part);
  this->split(first + split.left, count - split.left, of_part);
}

SplitOrder::Split SplitOrder::best_split(std::uint32_t first, std::uint32_t count, std::uint32_t of_part) {
  Split best{of_part, 0};
  float least = std::numeric_limits<float>::infinity();
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const auto part = std::span(sorted_[axis]).subspan(first, count);
    left_areas_.clear();
    Bounds box;
    for (std::uint32_t i = 0; i < count; ++i) {
      if (i > 0 && i % of_part == 0) left_areas_.push_back(box.half_area());
      box.grow(bounds_[part[i]]);
    }
    box = {};
    for (std::uint32_t i = count; i-- > of_part;) {
      box.grow(bounds_[part[i]]);
      if (i % of_part != 0) continue;
      const float cost =
          left_areas_[i / of_part - 1] * static_cast<float>(i) + box.half_area() * static_cast<float>(count - i);
      if (!(cost < least)) continue;
      least = cost;
      best = {i, axis};
    }
  }
  return best;
}

/// Moves the boxes of the left half to the front, on each axis. They keep their order.
void SplitOrder::divide(std::uint32_t first, std::uint32_t count, const Split& split) {
  for (std::uint32_t i = 0; i < count; ++i) is_left_[sorted_[split.axis][first + i]] = i < split.left;
  right_.resize(count);
  for (std::vector<std::uint32_t>& sorted : sorted_) {
    const auto part = std::span(sorted).subspan(first, count);
    std::size_t left = 0, right = 0;
    for (const std::uint32_t i : part) {
      part[left] = i;
      right_[right] = i;
      left += is_left_[i];
      right += 1U - is_left_[i];
    }
    std::copy_n(right_.begin(), right, part.begin() + static_cast<std::ptrdiff_t>(left));
  }
}

std::size_t SplitOrder::bytes() const {
  std::size_t numbers = right_.capacity();
  for (const auto& sorted : sorted_) numbers += sorted.capacity();
  return numbers * sizeof(std::uint32_t) + bounds_.capacity() * sizeof(Bounds) + left_areas_.capacity() * sizeof(float) +
         is_left_.capacity();
}

}  // namespace occlude::culler
