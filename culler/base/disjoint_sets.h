// SPDX-License-Identifier: MIT
// Union-find over 0, ..., n - 1.
#pragma once

#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace occlude::culler {

class DisjointSets {
 public:
  DisjointSets() = default;
  explicit DisjointSets(std::size_t size) { reset(size); }

  void reserve(std::size_t size) { parent_.reserve(size); }
  /// Makes each element a set of its own.
  void reset(std::size_t size) {
    parent_.resize(size);
    std::iota(parent_.begin(), parent_.end(), 0U);
  }

  /// The element that stands for the set of i.
  [[nodiscard]] std::uint32_t find(std::uint32_t i) {
    std::uint32_t root = i;
    while (parent_[root] != root) root = parent_[root];
    while (parent_[i] != root) i = std::exchange(parent_[i], root);
    return root;
  }
  /// Joins the sets that roots a and b stand for, which may be one; a stands for both.
  void join(std::uint32_t a, std::uint32_t b) { parent_[b] = a; }

  /// Calls visit(members) for every set, in ascending order of the roots, with its members in ascending order.
  template <class Visit>
  void for_each_set(Visit&& visit) {
    const auto size = static_cast<std::uint32_t>(parent_.size());
    std::vector<std::uint32_t> end(size + std::size_t{1}), order(size);  // a set of root r ends at end[r + 1]
    for (std::uint32_t i = 0; i < size; ++i) ++end[find(i) + std::size_t{1}];
    std::partial_sum(end.begin(), end.end(), end.begin());
    std::vector<std::uint32_t> next(end.begin(), end.end() - 1);
    for (std::uint32_t i = 0; i < size; ++i) order[next[find(i)]++] = i;
    for (std::uint32_t root = 0; root < size; ++root) {
      const std::size_t first = end[root], count = end[root + std::size_t{1}] - first;
      if (count != 0) visit(std::span<const std::uint32_t>(order).subspan(first, count));
    }
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace occlude::culler
