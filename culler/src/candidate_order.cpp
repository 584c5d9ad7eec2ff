// SPDX-License-Identifier: MIT
#include "candidate_order.h"

#include <algorithm>

namespace occlude::culler {
namespace {

/// Up to this many moves per candidate, insertion is cheaper than a new sort, which takes about ten comparisons for each of
/// a thousand candidates. The limit keeps a camera that jumps from taking quadratic time.
constexpr std::size_t kMostMoves = 8;

}  // namespace

/// Moves the last of the sorted candidates up to its place.
void CandidateOrder::insert_last() {
  std::size_t i = sorted_.size() - 1;
  const Candidate last = sorted_[i];
  for (; i > 0 && last < sorted_[i - 1]; --i) {
    sorted_[i] = sorted_[i - 1];
    ++moves_;
  }
  sorted_[i] = last;
}

/// Keeps the candidates that the last frame had too, with their new scores, and sorts them. Clears their entries in place_.
void CandidateOrder::keep(std::span<const Candidate> candidates) {
  merged_.clear();
  for (const Candidate& last : sorted_) {
    std::uint32_t& place = place_[last.occluder];
    if (place == 0) continue;
    merged_.push_back(candidates[place - 1]);
    place = 0;
  }
  kept_ = merged_.size();
  moves_ = 0;
  sorted_.clear();
  std::size_t next = 0;
  for (; next < kept_ && moves_ <= kMostMoves * kept_; ++next) {
    sorted_.push_back(merged_[next]);
    insert_last();
  }
  if (next == kept_) return;
  sorted_.insert(sorted_.end(), merged_.begin() + static_cast<std::ptrdiff_t>(next), merged_.end());
  std::sort(sorted_.begin(), sorted_.end());
}

void CandidateOrder::reserve(std::size_t candidates, std::size_t occluders) {
  for (std::vector<Candidate>* own : {&sorted_, &arrivals_, &merged_}) own->reserve(candidates);
  place_.grow(occluders);
}

void CandidateOrder::update(std::span<const Candidate> candidates, std::size_t occluders) {
  place_.grow(occluders);
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    place_[candidates[i].occluder] = static_cast<std::uint32_t>(i + 1);
  }
  keep(candidates);
  arrivals_.clear();
  for (const Candidate& candidate : candidates) {
    std::uint32_t& place = place_[candidate.occluder];
    if (place != 0) arrivals_.push_back(candidate);
    place = 0;
  }
  std::sort(arrivals_.begin(), arrivals_.end());
  merged_.resize(sorted_.size() + arrivals_.size());
  std::merge(sorted_.begin(), sorted_.end(), arrivals_.begin(), arrivals_.end(), merged_.begin());
  sorted_.swap(merged_);
}

}  // namespace occlude::culler
