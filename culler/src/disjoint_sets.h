// SPDX-License-Identifier: MIT
// Union-find over 0, ..., n - 1.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

namespace occlude::culler {

class DisjointSets {
 public:
  explicit DisjointSets(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0U); }

  /// The element that stands for the set of i.
  [[nodiscard]] std::uint32_t find(std::uint32_t i) {
    std::uint32_t root = i;
    while (parent_[root] != root) root = parent_[root];
    while (parent_[i] != root) i = std::exchange(parent_[i], root);
    return root;
  }
  /// Joins the sets that roots a and b stand for; a stands for both.
  void join(std::uint32_t a, std::uint32_t b) { parent_[b] = a; }

  /// Calls visit(members) for every set, of the least root first, with its members in ascending order.
  template <class Visit>
  void for_each_set(Visit&& visit) {
    std::vector<std::uint32_t> order(parent_.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::stable_sort(order, {}, [&](std::uint32_t i) { return find(i); });
    for (std::size_t first = 0, end = 0; first < order.size(); first = end) {
      const std::uint32_t root = find(order[first]);
      while (end < order.size() && find(order[end]) == root) ++end;
      visit(std::span<const std::uint32_t>(order).subspan(first, end - first));
    }
  }

 private:
  std::vector<std::uint32_t> parent_;
};

}  // namespace occlude::culler
