// SPDX-License-Identifier: MIT
#include "frusta/candidate_order.h"

namespace occlude::culler {
namespace {

/// Up to this many moves per candidate, insertion is cheaper than a new sort, which takes about ten comparisons for each of
/// a thousand candidates. The limit keeps a camera that jumps from taking quadratic time.
constexpr std::size_t kMostMoves = 8;

}  // namespace

void CandidateOrder::sort(std::span<Candidate> candidates) {
  std::sort(candidates.begin(), candidates.end(), [this](const Candidate& a, const Candidate& b) {
    ++comparisons_;
    return a < b;
  });
}

/// Where more than twice as many were sorted as the frame has asked for, half as many again as that are good in the next.
void CandidateOrder::raise_least() {
  if (sorted_.size() > 2 * asked_) least_ = sorted_[asked_ + asked_ / 2].score;
  asked_ = 0;
}

/// Writes each candidate to both ends, and keeps it at one: which of them cannot be foreseen, so there is no branch.
void CandidateOrder::separate(std::span<const Candidate> candidates) {
  good_.resize(candidates.size());
  others_.resize(candidates.size());
  std::size_t good = 0, others = 0;
  for (const Candidate& candidate : candidates) {
    good_[good] = others_[others] = candidate;
    const bool is_good = candidate.score >= least_;
    good += is_good ? 1 : 0;
    others += is_good ? 0 : 1;
  }
  good_.resize(good);
  others_.resize(others);
  comparisons_ += candidates.size();
}

/// Sorts the kept candidates: moves each of them up to its place, or, if there are too many moves, starts anew.
void CandidateOrder::sort_kept() {
  const std::span<Candidate> kept(sorted_);
  std::size_t next = 0, moves = 0;
  for (; next < kept.size() && moves <= kMostMoves * kept.size(); ++next) {
    const Candidate candidate = kept[next];
    std::size_t i = next;
    for (; i > 0 && candidate < kept[i - 1]; --i) kept[i] = kept[i - 1];
    kept[i] = candidate;
    moves += next - i;
  }
  kept_ = kept.size();
  moves_ = moves;
  comparisons_ += moves + next;
  if (next < kept.size()) sort(kept);
}

/// Keeps the good candidates that the last frame had sorted too, with their new scores, and sorts them. Clears their entries
/// in place_.
void CandidateOrder::keep() {
  merged_.clear();
  for (const Candidate& last : sorted_) {
    std::uint32_t& place = place_[last.occluder];
    if (place == 0) continue;
    merged_.push_back(good_[place - 1]);
    place = 0;
  }
  sorted_.swap(merged_);
  sort_kept();
}

void CandidateOrder::sort_others() {
  sort(others_);
  sorted_.insert(sorted_.end(), others_.begin(), others_.end());
  others_.clear();
  least_ = -kInfinity;  // too few were good
}

void CandidateOrder::reserve(std::size_t candidates, std::size_t occluders) {
  for (std::vector<Candidate>* own : {&good_, &others_, &sorted_, &arrivals_, &merged_}) own->reserve(candidates);
  place_.grow(occluders);
}

void CandidateOrder::update(std::span<const Candidate> candidates, std::size_t occluders) {
  place_.grow(occluders);
  comparisons_ = 0;
  raise_least();
  separate(candidates);
  for (std::size_t i = 0; i < good_.size(); ++i) place_[good_[i].occluder] = static_cast<std::uint32_t>(i + 1);
  keep();
  arrivals_.clear();
  for (const Candidate& candidate : good_) {
    std::uint32_t& place = place_[candidate.occluder];
    if (place != 0) arrivals_.push_back(candidate);
    place = 0;
  }
  sort(arrivals_);
  merged_.resize(sorted_.size() + arrivals_.size());
  std::merge(sorted_.begin(), sorted_.end(), arrivals_.begin(), arrivals_.end(), merged_.begin());
  comparisons_ += merged_.size();
  sorted_.swap(merged_);
}

}  // namespace occlude::culler
