// SPDX-License-Identifier: MIT
// The sort of section 4.2: insertion sort that starts from the last frame's order, in expected linear time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "base/sparse_zero_array.h"

namespace occlude::culler {

struct Candidate {
  double score;
  std::uint32_t occluder;

  /// Best first. Equal scores are ordered by occluder, so that the order never depends on the sorting algorithm.
  friend bool operator<(const Candidate& a, const Candidate& b) {
    return a.score != b.score ? a.score > b.score : a.occluder < b.occluder;
  }
};

/// A frame asks for a part of its candidates alone, so only good ones are sorted: those with a score like that of the last
/// one that the frames before asked for. If a frame asks for more, the others are sorted as well, and in the next frame all
/// are good.
class CandidateOrder {
 public:
  /// Takes the candidates of a frame and sorts the good ones. Those that the last frame had sorted start in its order.
  /// REQUIRES: no occluder occurs twice, and all are below `occluders`.
  void update(std::span<const Candidate> candidates, std::size_t occluders);
  /// Calls take(candidate) for all candidates, best first, until it returns false.
  template <class Take>
  void for_best_first(const Take& take) {
    const std::size_t all = sorted_.size() + others_.size();
    std::size_t i = 0;
    for (bool is_more = true; is_more && i < all; ++i) {
      if (i == sorted_.size()) sort_others();
      is_more = take(sorted_[i]);
    }
    asked_ = std::max(asked_, i);
  }

  /// Reserves memory for this many candidates of this many occluders.
  void reserve(std::size_t candidates, std::size_t occluders);

  /// In the last update: how many good candidates had been sorted in the frame before as well, and by how many places they
  /// moved in total.
  [[nodiscard]] std::size_t kept() const { return kept_; }
  [[nodiscard]] std::size_t moves() const { return moves_; }
  /// Comparisons of candidates since the last update began.
  [[nodiscard]] std::size_t comparisons() const { return comparisons_; }

 private:
  void raise_least();
  void separate(std::span<const Candidate> candidates);
  void keep();
  void sort_kept();
  void sort_others();
  void sort(std::span<Candidate> candidates);

  std::vector<Candidate> good_, others_;  ///< others_ is sorted once it is asked for, and then empty
  std::vector<Candidate> sorted_, arrivals_, merged_;
  static constexpr double kInfinity = std::numeric_limits<double>::infinity();
  double least_ = -kInfinity;             ///< the score of a good candidate is at least this
  std::size_t asked_ = 0;                 ///< for how many candidates the frame has asked
  SparseZeroArray<std::uint32_t> place_;  ///< for each occluder, its index among the candidates plus 1, or 0
  std::size_t kept_ = 0, moves_ = 0, comparisons_ = 0;
};

}  // namespace occlude::culler
