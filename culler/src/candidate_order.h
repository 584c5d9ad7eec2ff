// SPDX-License-Identifier: MIT
// The sort of section 4.2: insertion sort on last frame's order, expected linear.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace occlude::culler {

struct Candidate {
  double score;
  std::uint32_t occluder;

  /// Best first; equals by their number, so that the order never depends on the sorting algorithm.
  friend bool operator<(const Candidate& a, const Candidate& b) {
    return a.score != b.score ? a.score > b.score : a.occluder < b.occluder;
  }
};

class CandidateOrder {
 public:
  /// Sorts the candidates of a frame. Those that the last frame had too start in its order. REQUIRES: no occluder twice, all
  /// of them below `occluders`.
  void update(std::span<const Candidate> candidates, std::size_t occluders);

  /// Makes room for so many candidates of so many occluders.
  void reserve(std::size_t candidates, std::size_t occluders);

  [[nodiscard]] std::span<const Candidate> best_first() const { return sorted_; }
  /// Of the last update: candidates kept from the frame before, and the places by which they moved, all together.
  [[nodiscard]] std::size_t kept() const { return kept_; }
  [[nodiscard]] std::size_t moves() const { return moves_; }

 private:
  void keep(std::span<const Candidate> candidates);
  void insert_last();

  std::vector<Candidate> sorted_, arrivals_, merged_;
  std::vector<std::uint32_t> place_;  ///< of each occluder, one more than its place among the candidates, or 0
  std::size_t kept_ = 0, moves_ = 0;
};

}  // namespace occlude::culler
