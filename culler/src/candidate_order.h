// SPDX-License-Identifier: MIT
// The sort of section 4.2: insertion sort that starts from the last frame's order, in expected linear time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "zeros.h"

namespace occlude::culler {

struct Candidate {
  double score;
  std::uint32_t occluder;

  /// Best first. Equal scores are ordered by occluder, so that the order never depends on the sorting algorithm.
  friend bool operator<(const Candidate& a, const Candidate& b) {
    return a.score != b.score ? a.score > b.score : a.occluder < b.occluder;
  }
};

class CandidateOrder {
 public:
  /// Sorts the candidates of a frame. Those that the last frame also had start in its order. REQUIRES: no occluder occurs
  /// twice, and all are below `occluders`.
  void update(std::span<const Candidate> candidates, std::size_t occluders);

  /// Reserves memory for this many candidates of this many occluders.
  void reserve(std::size_t candidates, std::size_t occluders);

  [[nodiscard]] std::span<const Candidate> best_first() const { return sorted_; }
  /// In the last update: how many candidates were kept from the frame before, and by how many places they moved in total.
  [[nodiscard]] std::size_t kept() const { return kept_; }
  [[nodiscard]] std::size_t moves() const { return moves_; }

 private:
  void keep(std::span<const Candidate> candidates);
  void insert_last();

  std::vector<Candidate> sorted_, arrivals_, merged_;
  Zeros<std::uint32_t> place_;  ///< for each occluder, its index among the candidates plus 1, or 0
  std::size_t kept_ = 0, moves_ = 0;
};

}  // namespace occlude::culler
